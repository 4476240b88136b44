// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/PolygonShape.hpp"

#include <algorithm>

namespace isph {

PolygonShape::PolygonShape(std::vector<Edge> edges, int dimension, Real zMin, Real zMax)
    : edges_(std::move(edges)), dimension_(dimension), zMin_(zMin), zMax_(zMax)
{
}

std::unique_ptr<PolygonShape> PolygonShape::through(const std::vector<Vec<2>>& points,
                                                    int dimension, Real zMin, Real zMax)
{
    std::vector<Edge> edges = loopOf(points);
    if (enclosedArea(edges) < 0)
        edges = loopOf(std::vector<Vec<2>>(points.rbegin(), points.rend()));
    return std::make_unique<PolygonShape>(std::move(edges), dimension, zMin, zMax);
}

PolygonShape::Foot PolygonShape::footInPlane(const Point& x) const
{
    const Vec<2> p{{x[0], x[1]}};
    Foot best{{}, std::numeric_limits<Real>::max()};
    for (const Edge& e : edges_) {
        const Vec<2> foot = nearestOn(e, p);
        const Real distance = norm(foot - p);
        if (distance < best.signedDistance) best = {foot, distance};
    }
    if (encloses(edges_, p)) best.signedDistance = -best.signedDistance;
    return best;
}

Real PolygonShape::signedDistance(const Point& x) const
{
    const Real plane = footInPlane(x).signedDistance;
    if (dimension_ == 2) return plane;
    const Real end = std::max(zMin_ - x[2], x[2] - zMax_);
    return std::hypot(std::max(plane, 0.0), std::max(end, 0.0)) +
           std::min(std::max(plane, end), 0.0);
}

Point PolygonShape::nearestPoint(const Point& x) const
{
    const Foot foot = footInPlane(x);
    const Point side{
        {foot.point[0], foot.point[1], dimension_ == 2 ? 0 : std::clamp(x[2], zMin_, zMax_)}};
    if (dimension_ == 2 || foot.signedDistance > 0) return side;
    const Real end = std::max(zMin_ - x[2], x[2] - zMax_);
    if (end < foot.signedDistance) return side;
    return {{x[0], x[1], x[2] - zMin_ < zMax_ - x[2] ? zMin_ : zMax_}};
}

BoundingBox PolygonShape::bounds() const
{
    BoundingBox b;
    for (const Edge& e : edges_) b.include({{e.a[0], e.a[1], 0}});
    if (dimension_ == 3) b.min[2] = zMin_, b.max[2] = zMax_;
    return b;
}

std::optional<Real> PolygonShape::volume() const
{
    return enclosedArea(edges_) * (dimension_ == 2 ? 1 : zMax_ - zMin_);
}

bool crossesItself(const std::vector<Edge>& loop)
{
    Real shortest = std::numeric_limits<Real>::max();
    for (const Edge& e : loop) shortest = std::min(shortest, e.length());
    return cutAtCrossings(loop, 1e-9 * shortest).size() != loop.size();
}

}  // namespace isph
