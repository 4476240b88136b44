// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/CoarseMatrix.hpp"

#include <algorithm>
#include <tuple>

namespace isph {

void CoarseMatrixBuilder::build(const SymmetricMatrix& fine, const RowSums& fineSums,
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

namespace {
constexpr Index kSelf = 0, kUngrouped = 1, kOthers = 2;  // places in the row at hand
constexpr Index kFour = 4;                               // entries of a row are a multiple of it
constexpr std::size_t kWide = 20;                        // entries of a row
}  // namespace

/// Sums the rows of group g into part.column and part.value; returns how many places it took.
Index CoarseMatrixBuilder::sumRow(const SymmetricMatrix& fine, const Aggregation& groups, Index g,
                                  Index base, Part& part)
{
    std::size_t most = kOthers;
    for (const Index i : groups[g]) most += fine.rowStart[i + 1] - fine.rowStart[i];
    if (part.value.size() < most) part.column.resize(2 * most), part.value.resize(2 * most);
    part.slot[g + 1] = base + kSelf;
    part.slot[0] = base + kUngrouped;
    part.value[kSelf] = part.value[kUngrouped] = 0;
    Index entries = kOthers;
    for (const Index i : groups[g])
        for (PairIndex k = fine.rowStart[i]; k < fine.rowStart[i + 1]; ++k) {
            const Index other = groups.group[fine.column[k]];
            Index& slot = part.slot[other + 1];
            if (slot < base) {
                slot = base + entries;
                part.column[entries] = other;
                part.value[entries++] = 0;
            }
            part.value[slot - base] += static_cast<Real>(fine.offDiagonal[k]);
        }
    return entries;
}

void CoarseMatrixBuilder::gather(const SymmetricMatrix& fine, const RowSums& fineSums,
                                 const Aggregation& groups, Part& part, SymmetricMatrix& coarse,
                                 RowSums& coarseSums)
{
    part.slot.assign(groups.size() + 1, -1);
    const bool leads = &part == &parts_.front();
    LargeArray<Index>& columns = leads ? coarse.column : part.columns;
    LargeArray<float>& values = leads ? coarse.offDiagonal : part.values;
    columns.clear(), values.clear();
    const std::size_t rows = leads ? groups.size() : part.last - part.first;
    // The wide rows of particles make coarse ones of less than half their entries, rows of cells
    // about as many.
    const std::size_t entriesOfRow = fine.column.size() / fine.size();
    const std::size_t room = rows * ((entriesOfRow > kWide ? entriesOfRow / 2 : entriesOfRow) + 1);
    columns.reserve(room), values.reserve(room);
    Index base = 0;  // slots count on from row to row, so that none need be reset
    for (Index g = part.first; g < part.last; ++g) {
        const Index entries = sumRow(fine, groups, g, base, part);
        Real excess = -part.value[kUngrouped];  // the coarse correction is 0 there
        for (const Index i : groups[g]) excess += fineSums.excess[i];
        Real sum = 0, largest = 0;
        for (Index e = kOthers; e < entries; ++e) {
            const auto rounded = static_cast<float>(part.value[e]);
            values.push_back(rounded);
            sum -= static_cast<Real>(rounded);
            largest = std::max(largest, -static_cast<Real>(rounded));
        }
        const auto column = part.column.begin();
        columns.insert(columns.end(), column + kOthers, column + entries);
        const Index filling = (kOthers - entries) & (kFour - 1);
        columns.insert(columns.end(), filling, g);
        values.insert(values.end(), filling, 0);
        coarse.rowStart[g + 1] = entries - kOthers + filling;
        coarse.diagonal[g] = excess + sum;
        coarseSums.excess[g] = excess;
        coarseSums.largest[g] = largest;
        base += entries;
    }
}

void CoarseMatrixBuilder::join(SymmetricMatrix& coarse)
{
    coarse.ascending = false;
    coarse.rowStart[0] = 0;
    for (std::size_t g = 0; g < coarse.size(); ++g) coarse.rowStart[g + 1] += coarse.rowStart[g];
    coarse.column.resize(coarse.rowStart.back());
    coarse.offDiagonal.resize(coarse.rowStart.back());
    const auto parts = static_cast<int>(parts_.size());
#pragma omp parallel for schedule(static, 1) if (parts > 1)
    for (int p = 1; p < parts; ++p) {
        const PairIndex begin = coarse.rowStart[parts_[p].first];
        std::copy(parts_[p].columns.begin(), parts_[p].columns.end(),
                  coarse.column.begin() + begin);
        std::copy(parts_[p].values.begin(), parts_[p].values.end(),
                  coarse.offDiagonal.begin() + begin);
        parts_[p] = {};
    }
}

void sortColumns(SymmetricMatrix& matrix)
{
    std::vector<std::pair<Index, float>> row;
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

}  // namespace isph
