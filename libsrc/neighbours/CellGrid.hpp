// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of equal edge over a cloud of points, for neighbour searches and for sorting.
#pragma once
#include "core/Vec.hpp"

#include <algorithm>
#include <vector>

namespace isph {

/// Points binned into cells; within a cell they stand in ascending order, so that whatever is summed
/// over them does not depend on the number of threads.
template <int Dim>
class CellGrid {
public:
    /// Bins the points. Cells are enlarged where the cloud is so wide that they would outnumber it by far.
    void build(Span<const Vec<Dim>> x, Real edge);

    bool empty() const { return point_.empty(); }
    Real edge() const { return edge_; }

    /// f(j) for every point in the cells that touch the ball around x; radius <= edge().
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

    /// Point numbers in the order of their cells: neighbours in space stand close in memory.
    const std::vector<Index>& order() const { return point_; }

private:
    Index cellOf(Real coordinate, int d) const
    {
        const Real c = (coordinate - origin_[d]) * inverseEdge_;
        return static_cast<Index>(std::clamp(c, Real(0), Real(count_[d] - 1)));
    }
    template <class F>
    void scanRow(Index row, Index first, Index last, F&& f) const
    {
        const Index end = start_[row + last + 1];
        for (Index k = start_[row + first]; k < end; ++k) f(point_[k]);
    }

    Vec<Dim> origin_{};
    Real edge_ = 0, inverseEdge_ = 0;
    std::array<Index, Dim> count_{};
    std::vector<Index> start_;   ///< of each cell in point_, and the end
    std::vector<Index> point_;
    std::vector<Index> cell_;    ///< of each point (kept between builds to save the allocation)
};

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace isph
