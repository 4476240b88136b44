// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/BasicShapes.hpp"

#include <algorithm>
#include <numbers>

namespace isph {

namespace {
constexpr Real pi = std::numbers::pi;
Vec<2> flat(const Point& x)
{
    return {{x[0], x[1]}};
}
Point anyUnit()
{
    return {{1, 0, 0}};
}
}  // namespace

// ---- Box

Box::Box(const Point& min, const Point& max, int dimension)
    : min_(min), max_(max), dimension_(dimension)
{
    if (dimension_ == 2) min_[2] = max_[2] = 0;
}

Real Box::signedDistance(const Point& x) const
{
    Point outside;
    Real deepest = -std::numeric_limits<Real>::max();
    for (int d = 0; d < dimension_; ++d) {
        const Real q = std::max(min_[d] - x[d], x[d] - max_[d]);
        outside[d] = std::max(q, 0.0);
        deepest = std::max(deepest, q);
    }
    return norm(outside) + std::min(deepest, 0.0);
}

Point Box::nearestPoint(const Point& x) const
{
    Point p = x;
    bool inside = true;
    for (int d = 0; d < dimension_; ++d) {
        p[d] = std::clamp(x[d], min_[d], max_[d]);
        inside = inside && p[d] == x[d];
    }
    if (!inside) return p;
    int face = 0;
    bool low = true;
    Real least = std::numeric_limits<Real>::max();
    for (int d = 0; d < dimension_; ++d) {
        if (x[d] - min_[d] < least) least = x[d] - min_[d], face = d, low = true;
        if (max_[d] - x[d] < least) least = max_[d] - x[d], face = d, low = false;
    }
    p[face] = low ? min_[face] : max_[face];
    return p;
}

std::optional<Real> Box::volume() const
{
    Real v = 1;
    for (int d = 0; d < dimension_; ++d) v *= max_[d] - min_[d];
    return v;
}

std::optional<OrientedBox> Box::box() const
{
    OrientedBox b;
    b.origin = min_;
    b.length = max_ - min_;
    return b;
}

std::vector<Edge> Box::contour(Real) const
{
    std::vector<Edge> edges =
        loopOf({flat(min_), {{max_[0], min_[1]}}, flat(max_), {{min_[0], max_[1]}}});
    for (int k = 0; k < 4; ++k) edges[k].tag = k;
    return edges;
}

// ---- Sphere

Sphere::Sphere(const Point& centre, Real radius, int dimension)
    : centre_(centre), radius_(radius), dimension_(dimension)
{
    if (dimension_ == 2) centre_[2] = 0;
}

Real Sphere::signedDistance(const Point& x) const
{
    return norm(x - centre_) - radius_;
}

Point Sphere::nearestPoint(const Point& x) const
{
    const Point r = x - centre_;
    return centre_ + radius_ * (norm(r) > 0 ? unit(r) : anyUnit());
}

BoundingBox Sphere::bounds() const
{
    BoundingBox b{centre_, centre_};
    return b.grown(radius_, dimension_);
}

std::optional<Real> Sphere::volume() const
{
    return dimension_ == 2 ? pi * sqr(radius_) : 4 * pi / 3 * cube(radius_);
}

std::vector<Edge> Sphere::contour(Real tolerance) const
{
    return circleEdges(flat(centre_), radius_, tolerance);
}

// ---- Cylinder

Cylinder::Cylinder(const Point& point1, const Point& point2, Real radius)
    : point1_(point1), axis_(unit(point2 - point1)), length_(norm(point2 - point1)), radius_(radius)
{
}

Cylinder::Polar Cylinder::polar(const Point& x) const
{
    const Point r = x - point1_;
    const Real along = dot(r, axis_);
    const Point across = r - along * axis_;
    const Real radius = norm(across);
    if (radius > 1e-12 * radius_) return {along, radius, across / radius};
    const Point other = std::fabs(axis_[0]) < 0.9 ? Point{{1, 0, 0}} : Point{{0, 1, 0}};
    return {along, 0, unit(other - dot(other, axis_) * axis_)};
}

Real Cylinder::signedDistance(const Point& x) const
{
    const Polar p = polar(x);
    const Real side = p.radius - radius_, end = std::max(-p.along, p.along - length_);
    return std::hypot(std::max(side, 0.0), std::max(end, 0.0)) + std::min(std::max(side, end), 0.0);
}

Point Cylinder::nearestPoint(const Point& x) const
{
    const Polar p = polar(x);
    Real along = std::clamp(p.along, 0.0, length_), radius = std::min(p.radius, radius_);
    if (along == p.along && radius == p.radius) {  // inside: to the nearest of side and ends
        const Real side = radius_ - p.radius, low = p.along, high = length_ - p.along;
        if (side <= low && side <= high)
            radius = radius_;
        else
            along = low <= high ? 0 : length_;
    }
    return point1_ + along * axis_ + radius * p.outward;
}

BoundingBox Cylinder::bounds() const
{
    BoundingBox b;
    for (const Point& end : {point1_, point1_ + length_ * axis_})
        for (int sign : {-1, 1}) {
            Point corner = end;
            for (int d = 0; d < 3; ++d)
                corner[d] += sign * radius_ * std::sqrt(std::max(0.0, 1 - sqr(axis_[d])));
            b.include(corner);
        }
    return b;
}

std::optional<Real> Cylinder::volume() const
{
    return pi * sqr(radius_) * length_;
}

// ---- HalfSpace

HalfSpace::HalfSpace(const Point& point, const Point& normal, const BoundingBox& limits,
                     int dimension)
    : point_(point), normal_(normal), limits_(limits)
{
    if (dimension == 2) point_[2] = normal_[2] = 0;
    normal_ = unit(normal_);
}

std::vector<Edge> HalfSpace::contour(Real) const
{
    // the rectangle of the limits, cut by the plane
    const std::vector<Edge> frame = Box(limits_.min, limits_.max, 2).contour(0);
    std::vector<Vec<2>> kept;
    for (const Edge& e : frame) {
        const Real a = signedDistance({{e.a[0], e.a[1], 0}}),
                   b = signedDistance({{e.b[0], e.b[1], 0}});
        if (a <= 0) kept.push_back(e.a);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(e.a + a / (a - b) * e.along());
    }
    return kept.size() < 3 ? std::vector<Edge>{} : loopOf(kept);
}

}  // namespace isph
