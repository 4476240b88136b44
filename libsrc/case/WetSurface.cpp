// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WetSurface.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real sampling = 0.25;  // of d0
constexpr Real probe = 2e-3;     // of d0: how far off a surface its two sides are asked for

struct Octree {
    int dimension;
    Real cell, band;
    const std::function<Real(const Point&)>& distance;
    const std::function<void(const Point&)>& f;

    /// A cube of 2^level cells along each side, within the number of cells that are left.
    void visit(const Point& origin, const std::array<std::int64_t, 3>& first, std::int64_t side,
               const std::array<std::int64_t, 3>& count) const
    {
        Point centre = origin;
        for (int d = 0; d < dimension; ++d) {
            if (first[d] >= count[d]) return;
            centre[d] += (static_cast<Real>(first[d]) + 0.5 * static_cast<Real>(side)) * cell;
        }
        const Real radius =
            0.5 * std::sqrt(static_cast<Real>(dimension)) * static_cast<Real>(side - 1) * cell;
        if (std::fabs(distance(centre)) > radius + band) return;
        if (side == 1) return f(centre);
        for (int octant = 0; octant < 1 << dimension; ++octant) {
            std::array<std::int64_t, 3> next = first;
            for (int d = 0; d < dimension; ++d) next[d] += (octant >> d & 1) * side / 2;
            visit(origin, next, side / 2, count);
        }
    }
};

}  // namespace

void forEachCellNear(const BoundingBox& box, int dimension, Real cell, Real band,
                     const std::function<Real(const Point&)>& distance,
                     const std::function<void(const Point&)>& f)
{
    if (box.empty()) return;
    std::array<std::int64_t, 3> count{1, 1, 1};
    std::int64_t side = 1;
    for (int d = 0; d < dimension; ++d) {
        count[d] = std::max<std::int64_t>(1, std::llround(std::ceil(box.size()[d] / cell - 1e-6)));
        while (side < count[d]) side *= 2;
    }
    Octree{dimension, cell, band, distance, f}.visit(box.min, {0, 0, 0}, side, count);
}

BoundingBox wallLimits(const CaseGeometry& g, Real margin)
{
    BoundingBox limits = g.domain;
    for (int d = 0; d < g.dimension; ++d)
        if (!g.periodic[d]) limits.min[d] -= margin, limits.max[d] += margin;
    return limits;
}

WetSurface::WetSurface(const CaseGeometry& g, Real reach)
    : g_(g), reach_(reach), samples_(0.5 * reach)
{
    for (std::size_t w = 0; w < g.walls.size(); ++w) sample(w);
}

bool WetSurface::wet(const Point& q, const Point& intoWater) const
{
    return g_.bodyDistance(g_.wrapped(q + probe * g_.spacing * intoWater)) > 0;
}

void WetSurface::sample(std::size_t w)
{
    const Wall& wall = g_.walls[w];
    const Real cell = sampling * g_.spacing;
    const BoundingBox limits = wallLimits(g_, reach_);
    BoundingBox box = limits;
    if (wall.shape().bounded())
        box = intersection(limits, wall.shape().bounds().grown(cell, g_.dimension));
    const auto distance = [&](const Point& x) { return wall.bodyDistance(x); };
    forEachCellNear(box, g_.dimension, cell, 0.5 * cell, distance, [&](const Point& x) {
        const Real f = distance(x);
        const Point q = wall.surfacePoint(x);
        if (norm(q - x) < 1e-9 * cell || !limits.contains(q, 1e-6 * cell)) return;
        if (!wet(q, (f < 0 ? 1 : -1) * unit(q - x))) return;
        samples_.add(q);
        sampleWall_.push_back(static_cast<Index>(w));
    });
}

WetSurface::Foot WetSurface::foot(const Point& x) const
{
    Foot best;
    Real nearestDry = std::numeric_limits<Real>::max();
    for (std::size_t w = 0; w < g_.walls.size(); ++w) {
        const Point q = g_.walls[w].surfacePoint(x);
        const Real distance = norm(q - x);
        if (distance >= best.distance) continue;
        if (distance > 0 && wet(q, (q - x) / distance))
            best = {q, distance, static_cast<Index>(w)};
        else
            nearestDry = std::min(nearestDry, distance);
    }
    if (nearestDry >= best.distance) return best.distance > reach_ ? Foot{} : best;
    // beside a dry surface a wet one may be nearer than what was found
    const Index s = samples_.nearest(x, std::min(best.distance, reach_));
    if (s >= 0) best = {samples_[s], norm(samples_[s] - x), sampleWall_[s]};
    return best.distance > reach_ ? Foot{} : best;
}

}  // namespace isph
