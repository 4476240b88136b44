// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SoilField.hpp"

#include <algorithm>

namespace isph {

PeriodicPoints::PeriodicPoints(const CaseGeometry& g, const std::vector<Point>& points, Real reach)
    : x(points)
{
    for (std::size_t i = 0; i < points.size(); ++i) owner.push_back(static_cast<Index>(i));
    shift.resize(points.size());
    for (int d = 0; d < g.dimension; ++d) {
        if (!g.periodic[d]) continue;
        const Real length = g.domain.max[d] - g.domain.min[d];
        const std::size_t count = x.size();
        for (std::size_t i = 0; i < count; ++i)
            for (Real period : {-length, length}) {
                Point by = shift[i];
                by[d] += period;
                const Point image = points[owner[i]] + by;
                if (image[d] < g.domain.min[d] - reach || image[d] > g.domain.max[d] + reach)
                    continue;
                x.push_back(image);
                owner.push_back(owner[i]);
                shift.push_back(by);
            }
    }
}

SoilField::SoilField(const CaseGeometry& g, const SoilParticles& soil, const WallParticles& walls)
    : kernel_{g.dimension},
      h_(1.5 * g.spacing),
      least_(1),
      soilPoints_(g, soil.x, 2 * h_),
      wallPoints_(g, walls.x, 2 * h_),
      soilGrid_(2 * h_, soilPoints_.x),
      wallGrid_(2 * h_, wallPoints_.x),
      solid_(soil.solidVolume),
      wall_(walls.volume)
{
    for (Real v : solid_) least_ = std::min(least_, 1 - v / g.cellVolume());
}

Real SoilField::porosity(const Point& x) const
{
    Real solid = 0, wall = 0;
    soilGrid_.forEachWithin(x, 2 * h_, [&](Index k, const Point& r) {
        solid += solid_[soilPoints_.owner[k]] * kernel_.w(norm(r), h_);
    });
    if (solid == 0) return 1;
    wallGrid_.forEachWithin(x, 2 * h_, [&](Index k, const Point& r) {
        wall += wall_[wallPoints_.owner[k]] * kernel_.w(norm(r), h_);
    });
    const Real leastOpen = 0.1;  // deep in a corner of walls there is little left to divide by
    return std::max(least_, 1 - solid / std::max(leastOpen, 1 - wall));
}

}  // namespace isph
