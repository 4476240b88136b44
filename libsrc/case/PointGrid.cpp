// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/PointGrid.hpp"

namespace isph {

CellRows::CellRows(Real cell, const std::vector<Point>& points) : cell_(cell)
{
    BoundingBox box;
    for (const Point& x : points) box.include(x);
    if (points.empty()) box.include(Point{});
    min_ = box.min;
    const auto number = [&](int d) { return std::floor(box.size()[d] / cell_) + 1; };
    // few points far apart get larger cells
    const Real most = 4096 + 8 * static_cast<Real>(points.size());
    while (number(0) * number(1) * number(2) > most) cell_ *= 1.5;
    for (int d = 0; d < 3; ++d) n_[d] = static_cast<Index>(number(d));

    const auto at = [&](const Point& x) {
        return (static_cast<std::size_t>(cellOf(x[2], 2)) * n_[1] + cellOf(x[1], 1)) * n_[0] +
               cellOf(x[0], 0);
    };
    start_.assign(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2] + 1, 0);
    for (const Point& x : points) ++start_[at(x) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    points_.resize(points.size());
    order_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Index p = next[at(points[i])]++;
        points_[p] = points[i];
        order_[p] = static_cast<Index>(i);
    }
}

}  // namespace isph
