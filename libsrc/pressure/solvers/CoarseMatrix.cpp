// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/CoarseMatrix.hpp"

#include <algorithm>
#include <tuple>

namespace isph {

template <class Weight>
void CoarseMatrixBuilder::build(const LevelMatrix<Weight>& fine, const RowSums& fineSums,
                                const Aggregation& groups, SymmetricMatrix& coarse,
                                RowSums& coarseSums)
{
    const std::size_t n = groups.size();
    coarse.rowStart.resize(n + 1);
    coarse.diagonal.resize(n);
    coarseSums.resize(n);
    // The parts are joined in order, so their number leaves no trace in the matrix.
    parts_.resize(fine.size() < kSerialRows ? 1 : threadCount());
    const auto parts = static_cast<int>(parts_.size());
#pragma omp parallel for schedule(static, 1) if (parts > 1)
    for (int p = 0; p < parts; ++p) {
        parts_[p].first = static_cast<Index>(n * p / parts);
        parts_[p].last = static_cast<Index>(n * (p + 1) / parts);
        gather(fine, fineSums, groups, parts_[p], coarse, coarseSums);
    }
    join(coarse);
}

template <class Weight>
void CoarseMatrixBuilder::gather(const LevelMatrix<Weight>& fine, const RowSums& fineSums,
                                 const Aggregation& groups, Part& part, SymmetricMatrix& coarse,
                                 RowSums& coarseSums)
{
    part.slot.assign(groups.size(), -1);
    part.column.clear(), part.value.clear();
    for (Index g = part.first; g < part.last; ++g) {
        const auto begin = static_cast<Index>(part.column.size());
        Real excess = 0;
        for (const Index i : groups[g]) {
            excess += fineSums.excess[i];
            for (PairIndex k = fine.rowStart[i]; k < fine.rowStart[i + 1]; ++k) {
                const Index other = groups.group[fine.column[k]];
                if (other == g) continue;
                const auto a_ij = static_cast<Real>(fine.offDiagonal[k]);
                if (other < 0) {  // the coarse correction is 0 there
                    excess -= a_ij;
                } else if (Index& slot = part.slot[other]; slot >= begin) {
                    part.value[slot] += a_ij;
                } else {
                    slot = static_cast<Index>(part.column.size());
                    part.column.push_back(other);
                    part.value.push_back(a_ij);
                }
            }
        }
        Real sum = 0, largest = 0;
        for (auto k = static_cast<std::size_t>(begin); k < part.value.size(); ++k) {
            sum -= part.value[k];
            largest = std::max(largest, -part.value[k]);
        }
        coarse.rowStart[g + 1] = static_cast<Index>(part.column.size()) - begin;
        coarse.diagonal[g] = excess + sum;
        coarseSums.excess[g] = excess;
        coarseSums.largest[g] = largest;
    }
}

void CoarseMatrixBuilder::join(SymmetricMatrix& coarse)
{
    coarse.rowStart[0] = 0;
    for (std::size_t g = 0; g < coarse.size(); ++g) coarse.rowStart[g + 1] += coarse.rowStart[g];
    coarse.column.resize(coarse.rowStart.back());
    coarse.offDiagonal.resize(coarse.rowStart.back());
    const auto parts = static_cast<int>(parts_.size());
#pragma omp parallel for schedule(static, 1) if (parts > 1)
    for (int p = 0; p < parts; ++p) {
        const PairIndex begin = coarse.rowStart[parts_[p].first];
        std::copy(parts_[p].column.begin(), parts_[p].column.end(), coarse.column.begin() + begin);
        std::copy(parts_[p].value.begin(), parts_[p].value.end(), coarse.offDiagonal.begin() + begin);
    }
}

void sortColumns(SymmetricMatrix& matrix)
{
    std::vector<std::pair<Index, Real>> row;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        const PairIndex begin = matrix.rowStart[i], end = matrix.rowStart[i + 1];
        row.clear();
        for (PairIndex k = begin; k < end; ++k)
            row.emplace_back(matrix.column[k], matrix.offDiagonal[k]);
        std::sort(row.begin(), row.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        for (PairIndex k = begin; k < end; ++k)
            std::tie(matrix.column[k], matrix.offDiagonal[k]) = row[k - begin];
    }
}

#define ISPH_INSTANTIATE(Weight)                                                                  \
    template void CoarseMatrixBuilder::build(const LevelMatrix<Weight>&, const RowSums&,          \
                                             const Aggregation&, SymmetricMatrix&, RowSums&);
ISPH_INSTANTIATE(float)
ISPH_INSTANTIATE(Real)
#undef ISPH_INSTANTIATE

}  // namespace isph
