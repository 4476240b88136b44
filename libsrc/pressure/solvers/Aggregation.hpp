// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of rows that become one row each on the next coarser level of the multigrid.
#pragma once
#include "pressure/solvers/LevelLoops.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace isph {

/// What grouping and the coarse matrix need to know of each row.
struct RowSums {
    LargeArray<Real> excess;   ///< diagonal + sum of off-diagonals: what ties the row to p = 0
    LargeArray<Real> largest;  ///< largest |a_ij| of the row

    void resize(std::size_t n) { excess.resize(n), largest.resize(n); }
};

/// The cell of a background grid that a row stands in. Rows of different spacing have grids of
/// their own, so keys of two rows are equal where they share grid and cell.
using CellKey = std::uint64_t;

/// Keys from places: cells of two spacings, of the row's own spacing rounded to powers of sqrt(2).
void cellKeys(const RowPlaces& places, LargeArray<CellKey>& keys);

/// The key in cells of twice the edge.
CellKey coarserKey(CellKey key);

/// Groups of rows, numbered in the order of their first rows.
class Aggregation {
public:
    LargeArray<Index> group;          ///< of every row; -1: none, the smoother alone solves the row
    LargeArray<Index> start, member;  ///< rows of each group, ascending

    std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
    Span<const Index> operator[](std::size_t g) const
    {
        return {member.data() + start[g], static_cast<std::size_t>(start[g + 1] - start[g])};
    }

    /// Rows of equal key, split into pieces that are connected by entries with
    /// |a_ij| >= strength max(largest_i, largest_j). So groups reach across no jump of the
    /// coefficient, no thin wall and no gap. Rows whose excess is most of their diagonal stay out.
    void byCells(const SymmetricMatrix& matrix, const RowSums& sums, Span<const CellKey> keys,
                 Real strength);
    /// Where no places are known: a row and its strong neighbours, as long as those are free
    /// (Vanek, Mandel & Brezina 1996, Computing 56, 179-196, algorithm 5.1). One thread.
    void byNeighbours(const SymmetricMatrix& matrix, const RowSums& sums, Real strength);

private:
    /// Rows that one thread unites, and pairs of strong neighbours of one cell of which one comes
    /// before them.
    struct Run {
        Index first = 0, last = 0;
        std::vector<std::array<Index, 2>> across;
    };
    void uniteRun(const SymmetricMatrix& matrix, const RowSums& sums, Span<const CellKey> keys,
                  Real strength, Run& run);
    void number();

    LargeArray<Index> root_;  ///< any one row of the piece; -1: the row stays out
    LargeArray<Index> next_;  ///< of each root: its number
    std::vector<Run> runs_;
};

}  // namespace isph
