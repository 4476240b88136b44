// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of equal edge over a cloud of points, for neighbour searches and for sorting.
#pragma once
#include "core/Vec.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isph {

/// Points binned into cells; within a cell they stand in ascending order, so that whatever is
/// summed over them does not depend on the number of threads.
template <int Dim>
class CellGrid {
public:
    /// Bins the points. Cells are enlarged where the cloud is so wide that they would outnumber it
    /// by far. Their faces stand at multiples of the edge, so that clouds binned with one edge have
    /// one order. Along x they are cut into slices, which shortens the runs of forEachRun and
    /// lengthens no list of them.
    void build(Span<const Vec<Dim>> x, Real edge, int slices = 1);

    bool empty() const { return point_.empty(); }

    /// f(j) for every point in the cells that touch the cube of this half width around x.
    template <class F>
    void forEachNear(const Vec<Dim>& x, Real radius, F&& f) const
    {
        std::array<Index, Dim> low, high;
        for (int d = 0; d < Dim; ++d) {
            low[d] = cellOf(x[d] - radius, d);
            high[d] = cellOf(x[d] + radius, d);
        }
        if constexpr (Dim == 2) {
            for (Index b = low[1]; b <= high[1]; ++b) scanRow(b * count_[0], low[0], high[0], f);
        } else {
            for (Index c = low[2]; c <= high[2]; ++c)
                for (Index b = low[1]; b <= high[1]; ++b)
                    scanRow((c * count_[1] + b) * count_[0], low[0], high[0], f);
        }
    }

    /// f(first, last) for runs of order() that together hold every point within `radius` of x, and
    /// few others: rows of cells that the ball touches, each no longer than its chord.
    template <class F>
    void forEachRun(const Vec<Dim>& x, Real radius, F&& f) const
    {
        const Real most = radius * radius * (1 + kSlack);
        const auto row = [&](Index number, Real beside2) {
            if (beside2 > most) return;
            const Real chord = std::sqrt(most - beside2);
            const Index first = start_[number + cellOf(x[0] - chord, 0)];
            const Index last = start_[number + cellOf(x[0] + chord, 0) + 1];
            if (first < last) f(first, last);
        };
        const Index low1 = cellOf(x[1] - radius, 1), high1 = cellOf(x[1] + radius, 1);
        if constexpr (Dim == 2) {
            for (Index b = low1; b <= high1; ++b) row(b * count_[0], sqr(beside(x[1], b, 1)));
        } else {
            const Index low2 = cellOf(x[2] - radius, 2), high2 = cellOf(x[2] + radius, 2);
            for (Index c = low2; c <= high2; ++c) {
                const Real beside2 = sqr(beside(x[2], c, 2));
                for (Index b = low1; b <= high1; ++b)
                    row((c * count_[1] + b) * count_[0], beside2 + sqr(beside(x[1], b, 1)));
            }
        }
    }

    /// Point numbers in the order of their cells: neighbours in space stand close in memory.
    const std::vector<Index>& order() const { return point_; }

private:
    /// Share of a radius squared that rounding may take from a distance to a cell.
    static constexpr Real kSlack = 1e-9;

    /// Distance from a coordinate to the cells of number c in direction d, 0 within.
    Real beside(Real coordinate, Index c, int d) const
    {
        const Real low = origin_[d] + static_cast<Real>(c) * edge_[d];
        return std::max({low - coordinate, coordinate - (low + edge_[d]), Real(0)});
    }
    Index cellOf(Real coordinate, int d) const
    {
        const Real c = (coordinate - origin_[d]) * inverseEdge_[d];
        return static_cast<Index>(std::clamp(c, Real(0), Real(count_[d] - 1)));
    }
    template <class F>
    void scanRow(Index row, Index first, Index last, F&& f) const
    {
        const Index end = start_[row + last + 1];
        for (Index k = start_[row + first]; k < end; ++k) f(point_[k]);
    }

    Vec<Dim> origin_{}, edge_{}, inverseEdge_{};
    std::array<Index, Dim> count_{};
    std::vector<Index> start_;   ///< of each cell in point_, and the end
    std::vector<Index> point_;
    std::vector<Index> cell_;    ///< of each point (kept between builds to save the allocation)
};

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace isph
