// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/RegionChecks.hpp"

#include <fmt/core.h>

namespace isph {

namespace {

constexpr Real allowedDepth = 0.02;  // of d0: round-off and the chords of arcs
constexpr Real leastClearance =
    0.2;  // of d0: a particle that belongs beside a wall keeps about 0.5

std::string text(const Point& x)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", x[0], x[1], x[2]);
}

const Wall& deepestWall(const CaseGeometry& g, const Point& x)
{
    const Wall* deepest = &g.walls.front();
    for (const Wall& wall : g.walls)
        if (wall.bodyDistance(x) < deepest->bodyDistance(x)) deepest = &wall;
    return *deepest;
}

[[noreturn]] void failInWall(const CaseGeometry& g, const Point& x, Real depth,
                             const std::string& kind, const std::string& name, const Location& at)
{
    const Wall& wall = deepestWall(g, x);
    const std::string side = wall.fluidInside() ? "outside" : "inside";
    throw FatalIOError(
        fmt::format(
            "the {} region {} overlaps the wall {} ({} line {}): at {} it is {:.3g} m inside the "
            "wall's "
            "body\nThe body is what lies {} the wall's shape (fluid {}); take the body out of the "
            "region with a difference, or turn the wall round with fluid {}.",
            kind, name, wall.name(), wall.location().file, wall.location().line, text(x), depth,
            side, wall.fluidInside() ? "inside" : "outside", side),
        at.file, at.line);
}

[[noreturn]] void failOutside(const CaseGeometry& g, const Point& x, const std::string& kind,
                              const std::string& name, const Location& at)
{
    throw FatalIOError(
        fmt::format(
            "the {} region {} reaches outside the domain, for instance to {}; the domain is "
            "{} to {}",
            kind, name, text(x), text(g.domain.min), text(g.domain.max)),
        at.file, at.line);
}

}  // namespace

void checkInside(const CaseGeometry& g, const std::vector<Point>& points, const std::string& kind,
                 const std::string& name, const Shape& shape, const Location& at)
{
    const Real d0 = g.spacing;
    if (const auto box = shape.box(); box && shape.bounded()) {
        const BoundingBox b = shape.bounds();
        for (const Point& corner : {b.min, b.max})
            if (!g.domain.contains(corner, 1e-6 * d0)) failOutside(g, corner, kind, name, at);
    }
    for (const Point& x : points)
        if (!g.domain.contains(x, 1e-6 * d0)) failOutside(g, x, kind, name, at);
    if (g.walls.empty()) return;
    for (const Point& x : points)
        if (const Real f = g.bodyDistance(x); f < leastClearance * d0)
            failInWall(g, x, 0.5 * d0 - f, kind, name, at);
    // slivers that hold no particle
    const Real step = d0 / (g.dimension == 2 ? 4 : 2);
    forEachCell(intersection(shape.bounds(), g.domain), g.dimension, step,
                [&](const Point& x, Real) {
                    if (shape.signedDistance(x) > -allowedDepth * d0) return;
                    const Real f = g.bodyDistance(x);
                    if (f < -allowedDepth * d0) failInWall(g, x, -f, kind, name, at);
                });
}

}  // namespace isph
