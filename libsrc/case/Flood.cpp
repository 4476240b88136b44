// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Flood.hpp"

#include <algorithm>

namespace isph {

namespace {

/// Faces of the domain on which an open face of a box lies.
std::array<bool, 6> openFaces(const CaseGeometry& g)
{
    std::array<bool, 6> open{};
    for (const Wall& wall : g.walls) {
        const auto box = wall.shape().box();
        if (!box) continue;
        for (int face : wall.openFaces()) {
            Point outward;  // in the frame of the box
            outward[face / 2] = face % 2 ? 1 : -1;
            const Point n = box->rotation * outward;
            for (int d = 0; d < g.dimension; ++d)
                if (std::fabs(n[d]) > 0.5) open[2 * d + (n[d] > 0)] = true;
        }
    }
    return open;
}

}  // namespace

Flood::Flood(const CaseGeometry& g, const std::vector<Point>& water, const Point& up, Real passage)
    : g_(g), up_(up), clearance_(0.5 * passage), faceOpen_(openFaces(g))
{
    std::size_t cells = 1;
    for (int d = 0; d < g.dimension; ++d) {
        const Real length = g.domain.max[d] - g.domain.min[d];
        count_[d] = std::max<std::int64_t>(1, std::llround(2 * length / g.spacing));
        size_[d] = length / static_cast<Real>(count_[d]);
        cells *= static_cast<std::size_t>(count_[d]);
    }
    visited_.assign(cells, 0);
    level_ = -std::numeric_limits<Real>::max();
    for (const Point& x : water) level_ = std::max(level_, dot(x, up_) + 0.5 * g.spacing);
    start(water);
    spread();
}

std::size_t Flood::number(const Cell& c) const
{
    return static_cast<std::size_t>((c[2] * count_[1] + c[1]) * count_[0] + c[0]);
}

Flood::Cell Flood::cellOf(const Point& x) const
{
    Cell c{0, 0, 0};
    for (int d = 0; d < g_.dimension; ++d)
        c[d] = std::clamp<std::int64_t>(
            static_cast<std::int64_t>(std::floor((x[d] - g_.domain.min[d]) / size_[d])), 0,
            count_[d] - 1);
    return c;
}

Point Flood::centre(const Cell& c) const
{
    Point x;
    for (int d = 0; d < g_.dimension; ++d)
        x[d] = g_.domain.min[d] + (static_cast<Real>(c[d]) + 0.5) * size_[d];
    return x;
}

bool Flood::passable(const Cell& c) const
{
    const Point x = centre(c);
    return dot(x, up_) <= level_ && g_.bodyDistance(x) > clearance_;
}

bool Flood::inGrid(Cell& c, bool& leaks) const
{
    for (int d = 0; d < g_.dimension; ++d) {
        if (c[d] >= 0 && c[d] < count_[d]) continue;
        if (!g_.periodic[d]) {
            leaks = !faceOpen_[2 * d + (c[d] > 0)];
            return false;
        }
        c[d] = (c[d] + count_[d]) % count_[d];
    }
    return true;
}

/// All passable cells beside a particle, as far as the passage is wide.
void Flood::start(const std::vector<Point>& water)
{
    const auto reach = static_cast<std::int64_t>(std::ceil(2 * clearance_ / g_.spacing)) + 2;
    for (const Point& x : water) {
        const Cell home = cellOf(x);
        if (visited_[number(home)]) continue;  // another particle began there
        const std::int64_t reachZ = g_.dimension == 3 ? reach : 0;
        for (std::int64_t k = -reachZ; k <= reachZ; ++k)
            for (std::int64_t j = -reach; j <= reach; ++j)
                for (std::int64_t i = -reach; i <= reach; ++i) {
                    Cell c{home[0] + i, home[1] + j, home[2] + k};
                    bool leaks = false;
                    if (!inGrid(c, leaks) || visited_[number(c)] || !passable(c)) continue;
                    visited_[number(c)] = 1;
                    front_.push_back(c);
                }
    }
}

void Flood::spread()
{
    while (!front_.empty()) {
        const Cell at = front_.back();
        front_.pop_back();
        for (int d = 0; d < g_.dimension; ++d)
            for (int step : {-1, 1}) {
                Cell c = at;
                c[d] += step;
                bool leaks = false;
                if (!inGrid(c, leaks)) {
                    if (leaks && !leak_) leak_ = centre(at);
                    continue;
                }
                if (visited_[number(c)] || !passable(c)) continue;
                visited_[number(c)] = 1;
                front_.push_back(c);
            }
    }
}

bool Flood::reached(const Point& x) const
{
    return g_.domain.contains(x) && visited_[number(cellOf(x))] != 0;
}

}  // namespace isph
