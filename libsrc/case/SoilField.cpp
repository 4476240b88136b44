// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SoilField.hpp"

#include "core/LatticeSpline.hpp"

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
    : dimension_(g.dimension),
      spacing_(g.spacing),
      reach_(std::sqrt(Real(g.dimension)) * latticeSpline::kReach * g.spacing),
      least_(1),
      soilPoints_(g, soil.x, reach_),
      wallPoints_(g, walls.x, reach_),
      soilGrid_(reach_, soilPoints_.x),
      wallGrid_(reach_, wallPoints_.x),
      solid_(soil.solidVolume),
      wall_(walls.volume)
{
    for (Real v : solid_) least_ = std::min(least_, 1 - v / g.cellVolume());
}

/// W in 1/m^D.
Real SoilField::weight(const Point& r) const
{
    Real W = 1;
    for (int d = 0; d < dimension_; ++d) W *= latticeSpline::value(r[d] / spacing_) / spacing_;
    return W;
}

Real SoilField::porosity(const Point& x) const
{
    Real solid = 0, wall = 0;
    soilGrid_.forEachWithin(x, reach_, [&](Index k, const Point& r) {
        solid += solid_[soilPoints_.owner[k]] * weight(r);
    });
    if (solid == 0) return 1;
    wallGrid_.forEachWithin(x, reach_, [&](Index k, const Point& r) {
        wall += wall_[wallPoints_.owner[k]] * weight(r);
    });
    const Real leastOpen = 0.1;  // deep in a corner of walls there is little left to divide by
    return std::max(least_, 1 - solid / std::max(leastOpen, 1 - wall));
}

}  // namespace isph
