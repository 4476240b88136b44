// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SurfaceShape.hpp"

#include "case/PolygonShape.hpp"
#include "case/SurfaceReader.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {

TriangleTree treeOf(TriangleSurface surface)
{
    const std::vector<Point>& corners = surface.corners;
    Real volume = 0;
    for (const auto& t : surface.triangles)
        volume += dot(corners[t[0]], crossProduct(corners[t[1]], corners[t[2]]));
    if (volume < 0)  // inside out
        for (auto& t : surface.triangles) std::swap(t[1], t[2]);
    return TriangleTree(std::move(surface.corners), std::move(surface.triangles));
}

}  // namespace

SurfaceShape::SurfaceShape(const std::filesystem::path& file)
    : tree_(treeOf(SurfaceReader::select()->read(file)))
{
}

Real SurfaceShape::signedDistance(const Point& x) const
{
    return tree_.nearest(x).distance;
}

Point SurfaceShape::nearestPoint(const Point& x) const
{
    return tree_.nearest(x).point;
}

Point SurfaceShape::normal(const Point& x) const
{
    const TriangleTree::Foot foot = tree_.nearest(x);
    if (std::fabs(foot.distance) > 1e-9 * norm(tree_.bounds().size()))
        return (x - foot.point) / foot.distance;
    return unit(foot.normal);
}

std::unique_ptr<Shape> surfaceSection(const std::filesystem::path& file, std::optional<Real> z)
{
    const TriangleSurface surface = SurfaceReader::select()->read(file);
    const auto [low, high] =
        std::minmax_element(surface.corners.begin(), surface.corners.end(),
                            [](const Point& a, const Point& b) { return a[2] < b[2]; });
    const Real bottom = (*low)[2], top = (*high)[2], height = z.value_or(0.5 * (bottom + top));
    // edges of the section with the interior on their left: along normal x e_z, turned by a right
    // angle
    std::vector<Edge> edges;
    for (const auto& triangle : surface.triangles) {
        const Point corner[3] = {surface.corners[triangle[0]], surface.corners[triangle[1]],
                                 surface.corners[triangle[2]]};
        Vec<2> from, to;
        bool hasFrom = false, hasTo = false;
        for (int k = 0; k < 3; ++k) {
            const Point &a = corner[k], &c = corner[(k + 1) % 3];
            const bool below = a[2] < height, belowNext = c[2] < height;
            if (below == belowNext) continue;
            // the crossing depends on the edge alone, not on the triangle, so that pieces join
            const Point &lo = below ? a : c, &hi = below ? c : a;
            const Real s = (height - lo[2]) / (hi[2] - lo[2]);
            const Vec<2> at{{lo[0] + s * (hi[0] - lo[0]), lo[1] + s * (hi[1] - lo[1])}};
            (below ? to : from) = at;
            (below ? hasTo : hasFrom) = true;
        }
        if (hasFrom && hasTo && norm(to - from) > 0) edges.push_back({from, to, 0, false});
    }
    if (edges.empty())
        throw FatalError(
            fmt::format("the plane z = {} does not cut the surface \"{}\", which reaches from "
                        "z = {} to {}",
                        height, file.string(), bottom, top));
    if (enclosedArea(edges) < 0)
        for (Edge& e : edges) std::swap(e.a, e.b);
    return std::make_unique<PolygonShape>(std::move(edges), 2, 0, 0);
}

}  // namespace isph
