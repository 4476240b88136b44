// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Aggregation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace isph {

namespace {
/// Jacobi alone reduces the error of a row by this where its excess is as many times the sum of its
/// off-diagonals; a coarse row would gain nothing.
constexpr Real kDominance = 4;
/// Edge of a cell over the spacing: 2.4 takes more iterations, 1.6 more setup.
constexpr Real kCellEdge = 2;
/// Bits of a coordinate in a key; the four bits above three coordinates hold the grid's number.
constexpr int kBits = 20;
constexpr CellKey kMask = (CellKey{1} << kBits) - 1;
constexpr int kGridBit = 3 * kBits, kGrids = 16;

bool staysOut(const SymmetricMatrix& matrix, const RowSums& sums, Index i)
{
    const Real offDiagonals = matrix.diagonal[i] - sums.excess[i];
    return sums.largest[i] == 0 || sums.excess[i] > kDominance * offDiagonals;
}

/// The lowest row of i's piece; paths are halved on the way.
Index find(LargeArray<Index>& root, Index i)
{
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
}
}  // namespace

void cellKeys(const RowPlaces& places, LargeArray<CellKey>& keys)
{
    const std::size_t n = places.spacing.size();
    const int dim = places.dimension;
    Vec<3> lowest;
    for (int d = 0; d < dim; ++d)
        lowest[d] = -orderedMax(n, -std::numeric_limits<Real>::max(),
                                [&](Index i) { return -places.coordinate[i * dim + d]; });
    const Real finest = -orderedMax(n, -std::numeric_limits<Real>::max(),
                                    [&](Index i) { return -places.spacing[i]; });
    std::array<Real, kGrids> edge;
    for (int grid = 0; grid < kGrids; ++grid)
        edge[grid] = kCellEdge * finest * std::exp2(0.5 * grid);
    keys.resize(n);
    forRows(n, [&](Index i) {
        const auto nearest =
            static_cast<int>(std::lround(2 * std::log2(places.spacing[i] / finest)));
        const int grid = std::min(nearest, kGrids - 1);
        CellKey key = 0;
        for (int d = 0; d < dim; ++d) {
            const Real cell = (places.coordinate[i * dim + d] - lowest[d]) / edge[grid];
            key = key << kBits | std::min(static_cast<CellKey>(cell), kMask);
        }
        keys[i] = key | static_cast<CellKey>(grid) << kGridBit;
    });
}

CellKey coarserKey(CellKey key)
{
    constexpr CellKey coordinates = (CellKey{1} << kGridBit) - 1;
    constexpr CellKey highest = CellKey{1} << (kBits - 1);
    constexpr CellKey carried = highest | highest << kBits | highest << 2 * kBits;
    return (key & ~coordinates) | ((key & coordinates) >> 1 & ~carried);
}

/// Unites each row of the run with the strong neighbours of its cell before it: rows are read as
/// they lie in memory, and half of each where columns ascend.
void Aggregation::uniteRun(const SymmetricMatrix& matrix, const RowSums& sums,
                           Span<const CellKey> keys, Real strength, Run& run)
{
    run.across.clear();
    const Index* const column = matrix.column.data();
    for (Index i = run.first; i < run.last; ++i) {
        root_[i] = staysOut(matrix, sums, i) ? -1 : i;
        if (root_[i] < 0) continue;
        Index root = i;
        for (PairIndex k = matrix.rowStart[i], end = matrix.rowStart[i + 1]; k < end; ++k) {
            const Index j = column[k];
            if (j > i && matrix.ascending) break;
            if (keys[j] != keys[i] || j > i) continue;
            const Real strong = strength * std::max(sums.largest[i], sums.largest[j]);
            if (!(-static_cast<Real>(matrix.offDiagonal[k]) >= strong)) continue;
            if (j < run.first) {
                if (!staysOut(matrix, sums, j)) run.across.push_back({i, j});
            } else if (root_[j] >= 0) {
                const Index other = find(root_, j);
                root_[std::max(root, other)] = std::min(root, other);
                root = std::min(root, other);
            }
        }
    }
}

void Aggregation::byCells(const SymmetricMatrix& matrix, const RowSums& sums,
                          Span<const CellKey> keys, Real strength)
{
    const std::size_t n = matrix.size();
    root_.resize(n);
    runs_.resize(n < kSerialRows ? 1 : threadCount());
    const auto runs = static_cast<int>(runs_.size());
#pragma omp parallel for schedule(static, 1) if (runs > 1)
    for (int r = 0; r < runs; ++r) {
        runs_[r].first = static_cast<Index>(n * r / runs);
        runs_[r].last = static_cast<Index>(n * (r + 1) / runs);
        uniteRun(matrix, sums, keys, strength, runs_[r]);
    }
    for (const Run& run : runs_)
        for (const auto& [i, j] : run.across) {
            const Index a = find(root_, i), b = find(root_, j);
            root_[std::max(a, b)] = std::min(a, b);
        }
    number();
}

void Aggregation::byNeighbours(const SymmetricMatrix& matrix, const RowSums& sums, Real strength)
{
    const auto n = static_cast<Index>(matrix.size());
    constexpr Index out = -1, free = -2;
    root_.resize(n);
    for (Index i = 0; i < n; ++i) root_[i] = staysOut(matrix, sums, i) ? out : free;
    const auto forStrong = [&](Index i, auto&& f) {
        for (PairIndex k = matrix.rowStart[i]; k < matrix.rowStart[i + 1]; ++k) {
            const Index j = matrix.column[k];
            const Real a_ij = -static_cast<Real>(matrix.offDiagonal[k]);
            if (a_ij >= strength * std::max(sums.largest[i], sums.largest[j])) f(j, a_ij);
        }
    };
    for (Index i = 0; i < n; ++i) {  // whole neighbourhoods
        bool allFree = root_[i] == free;
        if (allFree) forStrong(i, [&](Index j, Real) { allFree &= root_[j] == free; });
        if (!allFree) continue;
        root_[i] = i;
        forStrong(i, [&](Index j, Real) { root_[j] = i; });
    }
    next_.assign(n, free);
    for (Index i = 0; i < n; ++i) {  // the rest joins its strongest neighbour's
        if (root_[i] != free) continue;
        Real strongest = 0;
        forStrong(i, [&](Index j, Real a_ij) {
            if (root_[j] >= 0 && a_ij > strongest) strongest = a_ij, next_[i] = root_[j];
        });
    }
    for (Index i = 0; i < n; ++i)
        if (next_[i] != free) root_[i] = next_[i];
    for (Index i = 0; i < n; ++i) {  // what is left of a neighbourhood
        if (root_[i] != free) continue;
        root_[i] = i;
        forStrong(i, [&](Index j, Real) {
            if (root_[j] == free) root_[j] = i;
        });
    }
    number();
}

void Aggregation::number()
{
    const auto n = static_cast<Index>(root_.size());
    next_.assign(n, -1);  // the number of each root
    group.resize(n);
    Index groups = 0;
    for (Index i = 0; i < n; ++i) {
        if (root_[i] < 0) {
            group[i] = -1;
            continue;
        }
        root_[i] = root_[root_[i]];  // the lowest row of the piece: it comes first
        Index& number = next_[root_[i]];
        if (number < 0) number = groups++;
        group[i] = number;
    }
    start.assign(groups + 2, 0);  // counted one place ahead, so that filling moves it into place
    for (Index i = 0; i < n; ++i)
        if (group[i] >= 0) ++start[group[i] + 2];
    for (Index g = 0; g < groups; ++g) start[g + 2] += start[g + 1];
    member.resize(start.back());
    for (Index i = 0; i < n; ++i)
        if (group[i] >= 0) member[start[group[i] + 1]++] = i;
    start.pop_back();
}

}  // namespace isph
