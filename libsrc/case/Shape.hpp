// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies and regions of a case: signed distance, normal, volume, and in 2-D their contour.
#pragma once
#include "case/Contour.hpp"
#include "core/Vec.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isph {

using Point = Vec<3>;  // 2-D shapes are cross-sections in the plane z = 0

struct BoundingBox {
    static constexpr Real far = std::numeric_limits<Real>::max();
    Point min{{far, far, far}};
    Point max{{-far, -far, -far}};

    Point size() const { return max - min; }
    bool empty() const { return !(min[0] <= max[0] && min[1] <= max[1] && min[2] <= max[2]); }
    void include(const Point& x);
    BoundingBox grown(Real by, int dimension) const;
    bool contains(const Point& x, Real tolerance = 0) const;
};
BoundingBox intersection(const BoundingBox& a, const BoundingBox& b);

/// A box in a frame of its own: x = origin + R (local coordinates in [0, length]).
struct OrientedBox {
    Point origin;
    Mat<3> rotation = Mat<3>::identity();  ///< columns are the box's axes
    Point length;

    Point toGlobal(const Point& local) const { return origin + rotation * local; }
    Point toLocal(const Point& x) const { return transpose(rotation) * (x - origin); }
};

/// A set of points with a surface. Distances in metres, negative inside.
class Shape {
public:
    virtual ~Shape() = default;

    /// Distance to the surface, negative inside. Exact for the simple shapes; for unions,
    /// differences and intersections its sign and zero are exact and |value| is at most the
    /// distance.
    virtual Real signedDistance(const Point& x) const = 0;
    /// The point of the surface nearest to x.
    virtual Point nearestPoint(const Point& x) const = 0;
    /// Unit normal of the surface at the point nearest to x, out of the shape.
    virtual Point normal(const Point& x) const;
    /// A box around the shape; around what of it matters where it is not bounded.
    virtual BoundingBox bounds() const = 0;
    virtual bool bounded() const { return true; }
    /// Volume [m3], in 2-D area [m2], where a formula gives it.
    virtual std::optional<Real> volume() const { return std::nullopt; }
    /// The shape as a box, if it is one.
    virtual std::optional<OrientedBox> box() const { return std::nullopt; }
    /// 2-D: the boundary, interior on the left; arcs as chords that deviate by at most `tolerance`.
    virtual std::vector<Edge> contour(Real tolerance) const = 0;
};

/// What a shape's dictionary does not say itself.
struct ShapeContext {
    int dimension = 2;
    BoundingBox domain;
    std::filesystem::path caseDir;  ///< surfaces are sought from here
};

/// The shape that `dict` describes: type
/// box|circle|cylinder|sphere|polygon|halfSpace|surface|union| difference|intersection, its keys,
/// and an optional rotation { angle; axis; origin; }. Keys named in `others` belong to the caller.
/// Throws FatalIOError (unknown type or key, bad sizes).
std::unique_ptr<Shape> readShape(const Dictionary& dict, const ShapeContext& context,
                                 const std::vector<Key>& others = {});

/// Names that `type` may have.
std::vector<std::string> shapeTypes();
/// The keys of a type, for lists and checks.
Schema shapeKeys(const std::string& type, int dimension);

/// Midpoint quadrature of  int_bounds clamp(1/2 - f(x)/step, 0, 1) dx: the volume where f < 0, with
/// f a distance, to second order in `step`.
template <class Distance>
Real measure(const BoundingBox& bounds, int dimension, Real step, Distance&& f);

}  // namespace isph

#include "case/ShapeMeasure.hpp"
