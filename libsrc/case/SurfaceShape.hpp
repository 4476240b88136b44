// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces of triangles from STL, OBJ and VTP files.
#pragma once
#include "case/TriangleTree.hpp"

namespace isph {

/// The inside of a closed surface (3-D).
class SurfaceShape : public Shape {
public:
    /// errors  FatalError: no such file, unknown format, no triangles, or a surface that is not
    /// closed
    ///         (names the file and the number of open edges)
    explicit SurfaceShape(const std::filesystem::path& file);

    Real signedDistance(const Point& x) const override;
    Point nearestPoint(const Point& x) const override;
    Point normal(const Point& x) const override;
    BoundingBox bounds() const override { return tree_.bounds(); }
    std::optional<Real> volume() const override { return tree_.volume(); }
    std::vector<Edge> contour(Real) const override { return {}; }

private:
    TriangleTree tree_;
};

/// The section of a closed surface by the plane z, by default through its middle, as a 2-D shape.
std::unique_ptr<Shape> surfaceSection(const std::filesystem::path& file, std::optional<Real> z);

}  // namespace isph
