// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WallCandidates.hpp"

#include "case/PointGrid.hpp"
#include "case/SoilField.hpp"
#include "case/WetSurface.hpp"
#include "core/Parallel.hpp"

#include <algorithm>

namespace isph {

namespace {

/// Cells of a box along one of its axes.
struct AxisCells {
    std::vector<Real> at, size;
    std::vector<char> inside;  ///< within the box, not in a layer around it

    void add(Real x, Real s, bool in)
    {
        at.push_back(x);
        size.push_back(s);
        inside.push_back(in);
    }
};

/// True if the face of the box lies on a periodic face of the domain: it is no wall.
bool onPeriodicFace(const OrientedBox& box, const CaseGeometry& g, int d, bool high)
{
    if (!g.periodic[d] || std::fabs(box.rotation[d][d] - 1) > 1e-12) return false;
    const Real face = box.origin[d] + (high ? box.length[d] : 0);
    return std::fabs(face - (high ? g.domain.max[d] : g.domain.min[d])) < 1e-6 * g.spacing;
}

AxisCells tankAxis(const Wall& wall, const OrientedBox& box, const CaseGeometry& g, int d,
                   int layers)
{
    AxisCells axis;
    const Real length = box.length[d];
    const int n = std::max(1, static_cast<int>(std::lround(length / g.spacing)));
    if (!wall.isOpen(2 * d) && !onPeriodicFace(box, g, d, false))
        for (int k = layers - 1; k >= 0; --k) axis.add(-(k + 0.5) * g.spacing, g.spacing, false);
    for (int i = 0; i < n; ++i) axis.add((i + 0.5) * length / n, length / n, true);
    if (!wall.isOpen(2 * d + 1) && !onPeriodicFace(box, g, d, true))
        for (int k = 0; k < layers; ++k) axis.add(length + (k + 0.5) * g.spacing, g.spacing, false);
    return axis;
}

/// Layers at exact depths from both ends, and in between what fills the rest evenly.
AxisCells solidAxis(const OrientedBox& box, const CaseGeometry& g, int d, int layers)
{
    AxisCells axis;
    const Real length = box.length[d];
    const int n = std::max(1, static_cast<int>(std::lround(length / g.spacing)));
    const bool thin = n <= 2 * layers || onPeriodicFace(box, g, d, false);
    const int rim = thin ? 0 : layers;
    const Real rest = length - 2 * rim * g.spacing;
    const int middle = n - 2 * rim;
    for (int k = 0; k < rim; ++k) axis.add((k + 0.5) * g.spacing, g.spacing, true);
    for (int k = 0; k < middle; ++k)
        axis.add(rim * g.spacing + (k + 0.5) * rest / middle, rest / middle, true);
    for (int k = rim - 1; k >= 0; --k) axis.add(length - (k + 0.5) * g.spacing, g.spacing, true);
    return axis;
}

/// Points of a wall's layer at one depth.
class Shell {
public:
    Shell(const Wall& wall, const CaseGeometry& g, const BoundingBox& limits, Real depth)
        : wall_(wall), g_(g), limits_(limits), depth_(depth)
    {
    }

    void add(const Point& x) { x_.push_back(onShell(x)); }
    const std::vector<Point>& points() const { return x_; }

    void spread()
    {
        for (int sweep = 0; sweep < 60; ++sweep)
            if (step() < 2e-3 * g_.spacing) return;
    }

private:
    /// Unit vector from x towards the water, along the shortest way to the wall's surface.
    Point towardsWater(const Point& x) const
    {
        const Point way = wall_.surfacePoint(x) - x;
        if (norm(way) > 1e-9 * g_.spacing) return (wall_.bodyDistance(x) < 0 ? 1 : -1) * unit(way);
        return (wall_.fluidInside() ? -1 : 1) * wall_.shape().normal(x);
    }

    Point onShell(const Point& x) const { return wall_.surfacePoint(x) - depth_ * towardsWater(x); }

    /// Repulsion by a surface kernel, along the shell; the longest move.
    Real step()
    {
        const Real h = 1.5 * g_.spacing;
        const PackingKernel kernel{2};
        const PeriodicPoints all(g_, x_, 2 * h);
        const PointGrid grid(2 * h, all.x);
        std::vector<Point> next(x_.size());
        parallelForDynamic(x_.size(), [&](Index i) {
            Point by;
            grid.forEachWithin(x_[i], 2 * h, [&](Index, const Point& r) {
                if (normSqr(r) > 0) by += kernel.slope(norm(r), h) * r;
            });
            by *= 0.15 * sqr(h) * sqr(g_.spacing);
            const Real most = 0.1 * g_.spacing;
            if (norm(by) > most) by *= most / norm(by);
            const Point to = onShell(x_[i] + by);
            next[i] = limits_.contains(to) ? to : x_[i];
        });
        Real longest = 0;
        for (std::size_t i = 0; i < x_.size(); ++i)
            longest = std::max(longest, norm(next[i] - x_[i]));
        x_ = std::move(next);
        return longest;
    }

    const Wall& wall_;
    const CaseGeometry& g_;
    const BoundingBox& limits_;
    Real depth_;
    std::vector<Point> x_;
};

}  // namespace

WallCandidates boxCandidates(const Wall& wall, const CaseGeometry& g, int layers)
{
    const OrientedBox box = *wall.shape().box();
    AxisCells axis[3];
    for (int d = 0; d < 3; ++d)
        axis[d] =
            wall.fluidInside() ? tankAxis(wall, box, g, d, layers) : solidAxis(box, g, d, layers);
    WallCandidates found;
    found.exact = true;
    for (std::size_t k = 0; k < axis[2].at.size(); ++k)
        for (std::size_t j = 0; j < axis[1].at.size(); ++j)
            for (std::size_t i = 0; i < axis[0].at.size(); ++i) {
                const bool inside = axis[0].inside[i] && axis[1].inside[j] && axis[2].inside[k];
                if (inside == wall.fluidInside()) continue;
                found.x.push_back(box.toGlobal({{axis[0].at[i], axis[1].at[j], axis[2].at[k]}}));
                found.volume.push_back(axis[0].size[i] * axis[1].size[j] * axis[2].size[k]);
            }
    return found;
}

WallCandidates shellCandidates(const Wall& wall, const CaseGeometry& g, int layers)
{
    const Real d0 = g.spacing, thickness = layers * d0;
    const BoundingBox limits = wallLimits(g, thickness);
    BoundingBox box = limits;
    if (wall.shape().bounded() && !wall.fluidInside())
        box = intersection(limits, wall.shape().bounds());
    std::vector<Shell> shells;
    for (int k = 0; k < layers; ++k) shells.emplace_back(wall, g, limits, (k + 0.5) * d0);
    for (int d = 0; d < 3; ++d)  // whole cells from the corner of the domain
        box.min[d] = g.domain.min[d] + std::floor((box.min[d] - g.domain.min[d]) / d0 + 1e-9) * d0;
    const auto distance = [&](const Point& x) { return wall.bodyDistance(x); };
    forEachCellNear(box, 3, d0, thickness, distance, [&](const Point& x) {
        const Real depth = -distance(x);
        const int k = static_cast<int>(std::floor(depth / d0));
        if (depth >= 0 && k < layers && limits.contains(x)) shells[k].add(x);
    });
    WallCandidates found;
    for (Shell& shell : shells) {
        shell.spread();
        found.x.insert(found.x.end(), shell.points().begin(), shell.points().end());
    }
    found.volume.assign(found.x.size(), g.cellVolume());
    return found;
}

}  // namespace isph
