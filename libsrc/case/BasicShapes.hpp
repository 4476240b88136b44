// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes, cylinders, spheres and half-spaces.
#pragma once
#include "case/Shape.hpp"

namespace isph {

/// Axis-aligned box; in 2-D a rectangle.
class Box : public Shape {
public:
    Box(const Point& min, const Point& max, int dimension);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    BoundingBox bounds() const override { return {min_, max_}; }
    std::optional<Real> volume() const override;
    std::optional<OrientedBox> box() const override;
    /// Tags: 0 bottom, 1 right, 2 top, 3 left.
    std::vector<Edge> contour(Real tolerance) const override;

private:
    Point min_, max_;
    int dimension_;
};

/// Ball; in 2-D a disc.
class Sphere : public Shape {
public:
    Sphere(const Point& centre, Real radius, int dimension);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    BoundingBox bounds() const override;
    std::optional<Real> volume() const override;
    std::vector<Edge> contour(Real tolerance) const override;

private:
    Point centre_;
    Real radius_;
    int dimension_;
};

/// Circular cylinder between two points of its axis (3-D).
class Cylinder : public Shape {
public:
    Cylinder(const Point& point1, const Point& point2, Real radius);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    BoundingBox bounds() const override;
    std::optional<Real> volume() const override;
    std::vector<Edge> contour(Real) const override { return {}; }

private:
    /// Distance along the axis from point1 and the vector from the axis.
    struct Polar {
        Real along, radius;
        Point outward;
    };
    Polar polar(const Point& x) const;

    Point point1_, axis_;
    Real length_, radius_;
};

/// The points behind a plane: (x - point).normal < 0. Bounded for practical purposes by `limits`.
class HalfSpace : public Shape {
public:
    HalfSpace(const Point& point, const Point& normal, const BoundingBox& limits, int dimension);

    Real signedDistance(const Point& x) const override { return dot(x - point_, normal_); }
    Point nearestPoint(const Point& x) const override { return x - signedDistance(x) * normal_; }
    Point normal(const Point&) const override { return normal_; }
    BoundingBox bounds() const override { return limits_; }
    bool bounded() const override { return false; }
    std::vector<Edge> contour(Real tolerance) const override;

private:
    Point point_, normal_;
    BoundingBox limits_;
};

}  // namespace isph
