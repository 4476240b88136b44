// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/CompositeShapes.hpp"

#include <algorithm>

namespace isph {

CompositeShape::CompositeShape(Kind kind, std::vector<std::unique_ptr<Shape>> parts, int dimension)
    : kind_(kind), parts_(std::move(parts)), dimension_(dimension)
{
}

std::pair<const Shape*, Real> CompositeShape::decisive(const Point& x) const
{
    const Shape* best = parts_.front().get();
    Real bestSign = 1, value = best->signedDistance(x);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
        const Real sign = kind_ == Kind::subtract ? -1 : 1, f = sign * parts_[k]->signedDistance(x);
        if (kind_ == Kind::unite ? f < value : f > value)
            best = parts_[k].get(), bestSign = sign, value = f;
    }
    return {best, bestSign};
}

Real CompositeShape::signedDistance(const Point& x) const
{
    const auto [part, sign] = decisive(x);
    return sign * part->signedDistance(x);
}

/// Steps to the surface of the decisive part until it is the composite's; where parts meet at an
/// edge the steps alternate between them and close in on it.
Point CompositeShape::nearestPoint(const Point& x) const
{
    Point p = x;
    for (int step = 0; step < 40; ++step) {
        p = decisive(p).first->nearestPoint(p);
        if (std::fabs(signedDistance(p)) < 1e-12 * (1 + norm(p))) break;
    }
    return p;
}

Point CompositeShape::normal(const Point& x) const
{
    const Point p = nearestPoint(x), away = x - p;
    const auto [part, sign] = decisive(p);
    const Point n = sign * part->normal(p);
    // beside an edge the direction to x is between the normals of the parts
    if (norm(away) < 1e-9 * (1 + norm(p))) return n;
    return signedDistance(x) < 0 ? -unit(away) : unit(away);
}

BoundingBox CompositeShape::bounds() const
{
    BoundingBox b = parts_.front()->bounds();
    for (std::size_t k = 1; k < parts_.size(); ++k) {
        const BoundingBox other = parts_[k]->bounds();
        if (kind_ == Kind::unite) {
            b.include(other.min);
            b.include(other.max);
        }
        if (kind_ == Kind::intersect) b = intersection(b, other);
    }
    return b;
}

bool CompositeShape::bounded() const
{
    if (kind_ == Kind::subtract) return parts_.front()->bounded();
    const auto is = [](const auto& part) { return part->bounded(); };
    return kind_ == Kind::unite ? std::all_of(parts_.begin(), parts_.end(), is)
                                : std::any_of(parts_.begin(), parts_.end(), is);
}

std::optional<Real> CompositeShape::volume() const
{
    if (dimension_ == 3) return std::nullopt;
    return enclosedArea(contour(1e-5 * norm(bounds().size())));
}

std::vector<Edge> CompositeShape::contour(Real tolerance) const
{
    std::vector<Edge> edges;
    for (const auto& part : parts_)
        for (const Edge& e : part->contour(tolerance)) edges.push_back(e);
    const Real scale = norm(bounds().size());
    return boundaryOf(cutAtCrossings(edges, 1e-10 * scale), std::max(4 * tolerance, 1e-8 * scale),
                      [&](const Vec<2>& x) {
                          return signedDistance({{x[0], x[1], 0}}) < 0;
                      });
}

RotatedShape::RotatedShape(std::unique_ptr<Shape> shape, const Mat<3>& rotation,
                           const Point& origin, int dimension)
    : shape_(std::move(shape)), rotation_(rotation), origin_(origin), dimension_(dimension)
{
}

BoundingBox RotatedShape::bounds() const
{
    const BoundingBox inner = shape_->bounds();
    BoundingBox b;
    for (int corner = 0; corner < 8; ++corner) {
        Point x;
        for (int d = 0; d < 3; ++d) x[d] = corner >> d & 1 ? inner.max[d] : inner.min[d];
        b.include(forth(x));
    }
    if (dimension_ == 2) b.min[2] = b.max[2] = 0;
    return b;
}

std::optional<OrientedBox> RotatedShape::box() const
{
    std::optional<OrientedBox> b = shape_->box();
    if (!b) return b;
    b->origin = forth(b->origin);
    b->rotation = rotation_ * b->rotation;
    return b;
}

std::vector<Edge> RotatedShape::contour(Real tolerance) const
{
    std::vector<Edge> edges = shape_->contour(tolerance);
    const auto turn = [&](const Vec<2>& x) {
        const Point y = forth({{x[0], x[1], 0}});
        return Vec<2>{{y[0], y[1]}};
    };
    for (Edge& e : edges) e.a = turn(e.a), e.b = turn(e.b);
    return edges;
}

Mat<3> rotationAbout(const Point& axis, Real angle)
{
    const Point k = unit(axis);
    const Mat<3> cross{{Point{{0, -k[2], k[1]}}, Point{{k[2], 0, -k[0]}}, Point{{-k[1], k[0], 0}}}};
    return Mat<3>::identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * (cross * cross);
}

}  // namespace isph
