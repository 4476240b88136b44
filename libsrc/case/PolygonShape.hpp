// SPDX-License-Identifier: GPL-3.0-or-later
// Regions bounded by straight edges in x-y, extruded along z in 3-D.
#pragma once
#include "case/Shape.hpp"

namespace isph {

class PolygonShape : public Shape {
public:
    /// Edges with the interior on their left, which close. z range: used in 3-D.
    PolygonShape(std::vector<Edge> edges, int dimension, Real zMin, Real zMax);
    /// The polygon through the points in either sense.
    static std::unique_ptr<PolygonShape> through(const std::vector<Vec<2>>& points, int dimension,
                                                 Real zMin, Real zMax);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    BoundingBox bounds() const override;
    std::optional<Real> volume() const override;
    std::vector<Edge> contour(Real) const override { return edges_; }

private:
    struct Foot {
        Vec<2> point;
        Real signedDistance;
    };
    Foot footInPlane(const Point& x) const;

    std::vector<Edge> edges_;
    int dimension_;
    Real zMin_, zMax_;
};

/// True if two edges of a closed loop cross or touch other than at shared ends.
bool crossesItself(const std::vector<Edge>& loop);

}  // namespace isph
