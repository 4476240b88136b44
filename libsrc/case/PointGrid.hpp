// SPDX-License-Identifier: GPL-3.0-or-later
// Points sorted into cells, for the searches that lay particles out (the solver has lists of
// pairs).
#pragma once
#include "case/Shape.hpp"

#include <algorithm>
#include <unordered_map>

namespace isph {

class PointGrid {
public:
    explicit PointGrid(Real cell) : cell_(cell) {}
    PointGrid(Real cell, const std::vector<Point>& points) : cell_(cell)
    {
        for (const Point& x : points) add(x);
    }

    void add(const Point& x)
    {
        cells_[key(at(x))].push_back(static_cast<Index>(points_.size()));
        points_.push_back(x);
    }
    std::size_t size() const { return points_.size(); }
    const Point& operator[](std::size_t i) const { return points_[i]; }

    /// f(i, x_i - x) for all points within `radius`, always in the same order.
    template <class F>
    void forEachWithin(const Point& x, Real radius, F&& f) const
    {
        const auto low = at(x - Point{{radius, radius, radius}}),
                   high = at(x + Point{{radius, radius, radius}});
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t i = low[0]; i <= high[0]; ++i) {
                    const auto cell = cells_.find(key({i, j, k}));
                    if (cell == cells_.end()) continue;
                    for (Index p : cell->second) {
                        const Point r = points_[p] - x;
                        if (normSqr(r) <= sqr(radius)) f(p, r);
                    }
                }
    }

    /// The nearest point within `radius` (of equals the first), or -1.
    Index nearest(const Point& x, Real radius) const
    {
        Index best = -1;
        Real least = sqr(radius) * (1 + 1e-12);
        forEachWithin(x, radius, [&](Index i, const Point& r) {
            if (normSqr(r) < least || (normSqr(r) == least && i < best))
                least = normSqr(r), best = i;
        });
        return best;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell at(const Point& x) const
    {
        Cell c;
        for (int d = 0; d < 3; ++d) c[d] = static_cast<std::int64_t>(std::floor(x[d] / cell_));
        return c;
    }
    static std::uint64_t key(const Cell& c)
    {
        std::uint64_t k = 0;  // 21 bits a direction
        for (int d = 0; d < 3; ++d) k = k << 21 | (static_cast<std::uint64_t>(c[d]) & 0x1fffff);
        return k;
    }

    Real cell_;
    std::vector<Point> points_;
    std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

/// Points that stay as they are, sorted into the cells of their bounding box: faster to search than
/// a PointGrid, in the same order.
class CellRows {
public:
    CellRows(Real cell, const std::vector<Point>& points);

    /// f(i, x_i - x) for all points within `radius`, always in the same order.
    template <class F>
    void forEachWithin(const Point& x, Real radius, F&& f) const
    {
        Index low[3], high[3];
        for (int d = 0; d < 3; ++d) {
            low[d] = cellOf(x[d] - radius, d);
            high[d] = cellOf(x[d] + radius, d);
        }
        for (Index k = low[2]; k <= high[2]; ++k)
            for (Index j = low[1]; j <= high[1]; ++j) {
                const std::size_t row = (static_cast<std::size_t>(k) * n_[1] + j) * n_[0];
                for (Index p = start_[row + low[0]]; p < start_[row + high[0] + 1]; ++p) {
                    const Point r = points_[p] - x;
                    if (normSqr(r) <= sqr(radius)) f(order_[p], r);
                }
            }
    }

private:
    /// Along d, kept within the box.
    Index cellOf(Real x, int d) const
    {
        return static_cast<Index>(
            std::clamp((x - min_[d]) / cell_, 0.0, static_cast<Real>(n_[d] - 1)));
    }

    Real cell_;
    Point min_;
    Index n_[3] = {1, 1, 1};
    std::vector<Index> start_;  ///< of each cell in points_
    std::vector<Point> points_;
    std::vector<Index> order_;
};

}  // namespace isph
