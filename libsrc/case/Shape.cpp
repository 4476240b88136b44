// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Shape.hpp"

#include <algorithm>

namespace isph {

void BoundingBox::include(const Point& x)
{
    for (int d = 0; d < 3; ++d) {
        min[d] = std::min(min[d], x[d]);
        max[d] = std::max(max[d], x[d]);
    }
}

BoundingBox BoundingBox::grown(Real by, int dimension) const
{
    BoundingBox b = *this;
    for (int d = 0; d < dimension; ++d) b.min[d] -= by, b.max[d] += by;
    return b;
}

bool BoundingBox::contains(const Point& x, Real tolerance) const
{
    for (int d = 0; d < 3; ++d)
        if (x[d] < min[d] - tolerance || x[d] > max[d] + tolerance) return false;
    return true;
}

BoundingBox intersection(const BoundingBox& a, const BoundingBox& b)
{
    BoundingBox c;
    for (int d = 0; d < 3; ++d) {
        c.min[d] = std::max(a.min[d], b.min[d]);
        c.max[d] = std::min(a.max[d], b.max[d]);
    }
    return c;
}

Point Shape::normal(const Point& x) const
{
    const Point p = nearestPoint(x), away = x - p;
    const Real distance = norm(away), scale = 1e-9 * (1 + norm(p));
    if (distance > scale) return signedDistance(x) < 0 ? -unit(away) : unit(away);
    // on the surface: the direction of growing distance, by central differences a little further
    // out
    const Real step = 1e-6 * norm(bounds().size());
    Point gradient;
    for (int d = 0; d < 3; ++d) {
        Point e;
        e[d] = step;
        gradient[d] = signedDistance(x + e) - signedDistance(x - e);
    }
    return unit(gradient);
}

}  // namespace isph
