// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WallLayers.hpp"
#include "case/WetSurface.hpp"

#include <algorithm>

namespace isph {

namespace {

Point lifted(const Vec<2>& x)
{
    return {{x[0], x[1], 0}};
}

/// Directed edges of a rectangle, for cutting others at it; tag -1.
void addFrame(std::vector<Edge>& edges, const BoundingBox& box)
{
    for (Edge e : Box(box.min, box.max, 2).contour(0)) {
        e.tag = -1;
        edges.push_back(e);
    }
}

}  // namespace

std::vector<Edge> wetEdges(const CaseGeometry& g, Real margin)
{
    // chords deviate less from their arcs than the probe reaches, so the probe tells the sides
    // apart
    const Real chord = 2e-4 * g.spacing, probe = 2e-3 * g.spacing;
    BoundingBox limits = g.domain;
    for (int d = 0; d < 2; ++d)
        if (!g.periodic[d]) limits.min[d] -= margin, limits.max[d] += margin;

    std::vector<Edge> edges;
    for (std::size_t w = 0; w < g.walls.size(); ++w) {
        const Wall& wall = g.walls[w];
        static const int faceOfTag[4] = {2, 1, 3, 0};  // bottom right top left -> 2 axis + end
        const bool isBox = wall.shape().box().has_value();
        for (Edge e : wall.shape().contour(chord)) {
            if (isBox && wall.isOpen(faceOfTag[e.tag])) continue;
            e.tag = static_cast<int>(w);
            edges.push_back(e);
        }
    }
    addFrame(edges, limits);
    const std::vector<Edge> bounding =
        boundaryOf(cutAtCrossings(edges, 1e-7 * g.spacing), probe,
                   [&](const Vec<2>& x) { return g.bodyDistance(g.wrapped(lifted(x))) < 0; });
    std::vector<Edge> wet;
    for (const Edge& e : bounding)
        if (e.tag >= 0 && limits.contains(lifted(0.5 * (e.a + e.b)), 1e-7 * g.spacing))
            wet.push_back(e);
    return wet;
}

std::vector<Point> wetPoints(const CaseGeometry& g, Real step)
{
    std::vector<Point> points;
    if (g.dimension == 3) {
        const WetSurface surface(g, 2 * g.spacing);
        for (std::size_t i = 0; i < surface.samples().size(); ++i)
            points.push_back(surface.samples()[i]);
        return points;
    }
    Real left = 0;  // to the next point; edges may be shorter than the step
    for (const Edge& e : wetEdges(g, 0)) {
        for (; left < e.length(); left += step)
            points.push_back(lifted(e.a + left / e.length() * e.along()));
        left -= e.length();
    }
    return points;
}

}  // namespace isph
