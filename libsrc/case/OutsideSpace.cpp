// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/OutsideSpace.hpp"

#include "case/PointGrid.hpp"

#include <algorithm>

namespace isph {

namespace {

void addCell(OutsideSpace& space, const Point& centre, Real volume, const CaseGeometry& g,
             const std::function<Real(const Point&)>& outside)
{
    const Real half = 0.5 * g.spacing;
    const int parts = 1 << g.dimension;
    Real share[8], sum = 0;
    Point at[8];
    for (int p = 0; p < parts; ++p) {
        at[p] = centre;
        for (int d = 0; d < g.dimension; ++d) at[p][d] += (p >> d & 1 ? 0.5 : -0.5) * half;
        share[p] = std::clamp(0.5 + outside(g.wrapped(at[p])) / half, 0.0, 1.0);
        sum += share[p];
    }
    if (sum > parts - 1e-6) {
        space.x.push_back(centre);
        space.volume.push_back(volume);
        return;
    }
    for (int p = 0; p < parts; ++p) {
        if (share[p] == 0) continue;
        space.x.push_back(at[p]);
        space.volume.push_back(share[p] * volume / parts);
    }
}

}  // namespace

OutsideSpace outsideSpace(const CaseGeometry& g, const std::vector<Point>& points, Real reach,
                          const std::function<Real(const Point&)>& outside)
{
    OutsideSpace space;
    BoundingBox box;
    for (const Point& x : points) box.include(x);
    const PointGrid near(reach, points);
    box = box.grown(reach, g.dimension);
    for (int d = 0; d < g.dimension; ++d) {  // whole cells from the corner of the domain
        const Real d0 = g.spacing;
        box.min[d] = g.domain.min[d] + std::floor((box.min[d] - g.domain.min[d]) / d0) * d0;
        box.max[d] = box.min[d] + std::ceil((box.max[d] - box.min[d]) / d0) * d0;
    }
    // the middle of a cell is at most so far from a place with something outside
    const Real deep = -0.5 * std::sqrt(static_cast<Real>(g.dimension)) * g.spacing;
    forEachCell(box, g.dimension, g.spacing * (1 + 1e-9), [&](const Point& x, Real volume) {
        if (outside(g.wrapped(x)) < deep) return;
        if (near.nearest(x, reach) >= 0) addCell(space, x, volume, g, outside);
    });
    return space;
}

}  // namespace isph
