// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes made of shapes: unions, differences, intersections, rotations.
#pragma once
#include "case/Shape.hpp"

namespace isph {

class CompositeShape : public Shape {
public:
    enum class Kind { unite, subtract, intersect };  ///< subtract: the first without the others
    CompositeShape(Kind kind, std::vector<std::unique_ptr<Shape>> parts, int dimension);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    Point normal(const Point& x) const override;
    BoundingBox bounds() const override;
    bool bounded() const override;
    /// In 2-D from the contour.
    std::optional<Real> volume() const override;
    std::vector<Edge> contour(Real tolerance) const override;

private:
    /// The part whose surface is the composite's next to x, and +1 or -1 for its orientation.
    std::pair<const Shape*, Real> decisive(const Point& x) const;

    Kind kind_;
    std::vector<std::unique_ptr<Shape>> parts_;
    int dimension_;
};

/// x -> origin + R (x - origin) applied to a shape.
class RotatedShape : public Shape {
public:
    RotatedShape(std::unique_ptr<Shape> shape, const Mat<3>& rotation, const Point& origin,
                 int dimension);

    Real signedDistance(const Point& x) const override { return shape_->signedDistance(back(x)); }
    Point nearestPoint(const Point& x) const override
    {
        return forth(shape_->nearestPoint(back(x)));
    }
    Point normal(const Point& x) const override { return rotation_ * shape_->normal(back(x)); }
    BoundingBox bounds() const override;
    bool bounded() const override { return shape_->bounded(); }
    std::optional<Real> volume() const override { return shape_->volume(); }
    std::optional<OrientedBox> box() const override;
    std::vector<Edge> contour(Real tolerance) const override;

private:
    Point forth(const Point& x) const { return origin_ + rotation_ * (x - origin_); }
    Point back(const Point& x) const { return origin_ + transpose(rotation_) * (x - origin_); }

    std::unique_ptr<Shape> shape_;
    Mat<3> rotation_;
    Point origin_;
    int dimension_;
};

/// Rotation by `angle` [rad] about an axis (Rodrigues' formula).
Mat<3> rotationAbout(const Point& axis, Real angle);

}  // namespace isph
