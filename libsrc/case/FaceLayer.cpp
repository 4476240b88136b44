// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/FaceLayer.hpp"

#include "case/PointGrid.hpp"
#include "case/SoilField.hpp"
#include "core/Parallel.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real roundOff = 1e-7;    // of a spacing
constexpr Real fits = 0.1;         // of a spacing: how far from the middle is right
constexpr Real beside = 2.5;       // spacings: neighbours in the layer
constexpr Real leastSlope = 0.05;  // of a distance; less midway between two faces
constexpr Real rate = 0.2;         // of the repulsion, in spacings
constexpr Real longestStep = 0.1;  // in spacings
constexpr Real settled = 1e-3;     // in spacings
constexpr Real margin = 0.4;       // in spacings: what is kept from other faces of the part
constexpr int mostSweeps = 200;
constexpr int mostPasses = 20;  // one on a plane, more where an acute corner turns the way

}  // namespace

Point steepest(const std::function<Real(const Point&)>& distance, const Point& x,
               const CaseGeometry& g)
{
    Point n;
    for (int d = 0; d < g.dimension; ++d) {
        Point e;
        e[d] = 1e-3 * g.spacing;
        n[d] = (distance(x + e) - distance(x - e)) / (2 * e[d]);
    }
    return norm(n) > leastSlope ? unit(n) : Point{};
}

Point movedToLevel(const std::function<Real(const Point&)>& distance, Point x, Real level,
                   const CaseGeometry& g)
{
    for (int pass = 0; pass < mostPasses; ++pass) {
        const Real error = distance(x) - level;
        if (std::fabs(error) < roundOff * g.spacing) break;
        x -= error * steepest(distance, x, g);
    }
    return x;
}

FaceLayer::FaceLayer(const CaseGeometry& geometry, Distance outside, Distance own, Real spacing)
    : g_(geometry), outside_(std::move(outside)), own_(std::move(own)), spacing_(spacing)
{
}

bool FaceLayer::holds(const Point& x) const
{
    const Real f = outside_(x);
    if (f > 0 || f < -(1 - roundOff) * spacing_) return false;
    const Point beyond = g_.wrapped(x + (0.5 * spacing_ - f) * steepest(outside_, x, g_));
    return outside_(beyond) > 0.25 * spacing_;
}

Point FaceLayer::atDepth(const Point& x, Real depth) const
{
    return movedToLevel(outside_, x, -depth * spacing_, g_);
}

std::vector<char> FaceLayer::laid(std::vector<Point>& x) const
{
    std::vector<char> moves = misfits(x);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (moves[i]) x[i] = atDepth(x[i], 0.5);
    for (int sweep = 0; sweep < mostSweeps; ++sweep)
        if (step(x, moves) < settled * spacing_) break;
    return moves;
}

/// Those that do not stand right and their neighbours: some do by chance where a lattice and a face
/// cross.
std::vector<char> FaceLayer::misfits(const std::vector<Point>& x) const
{
    PointGrid wrong(beside * spacing_);
    for (const Point& at : x)
        if (std::fabs(outside_(at) + 0.5 * spacing_) > fits * spacing_) wrong.add(at);
    std::vector<char> misfit;
    misfit.reserve(x.size());
    for (const Point& at : x) misfit.push_back(wrong.nearest(at, beside * spacing_) >= 0);
    return misfit;
}

/// Repulsion along the layer by (1 - r/R)^2, which unlike a kernel's gradient holds pairs apart at
/// any distance; the longest move.
Real FaceLayer::step(std::vector<Point>& x, const std::vector<char>& moves) const
{
    const Real reach = beside * spacing_;
    const PeriodicPoints all(g_, x, reach);
    const CellRows grid(reach, all.x);
    std::vector<Point> next = x;
    parallelForDynamic(x.size(), [&](Index i) {
        if (!moves[i]) return;
        Point by;
        grid.forEachWithin(
            x[i], reach, [&](Index, const Point& r) { by -= sqr(1 - norm(r) / reach) * unit(r); });
        by *= rate * spacing_;
        by *= std::min(1.0, longestStep * spacing_ / std::max(norm(by), 1e-300));
        const Point to = atDepth(x[i] + by, 0.5);
        if (own_(to) < std::max(own_(x[i]), -margin * spacing_)) next[i] = to;
    });
    Real longest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) longest = std::max(longest, norm(next[i] - x[i]));
    x = std::move(next);
    return longest;
}

}  // namespace isph
