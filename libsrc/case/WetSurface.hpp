// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the walls' surfaces that water can touch, in three dimensions.
#pragma once
#include "case/CaseGeometry.hpp"
#include "case/PointGrid.hpp"

namespace isph {

/// Where walls meet (a caisson on its floor), the surfaces between the two bodies are dry.
class WetSurface {
public:
    /// Feet are found up to `reach` away from a surface.
    WetSurface(const CaseGeometry& geometry, Real reach);

    struct Foot {
        Point point;
        Real distance = std::numeric_limits<Real>::max();
        Index wall = -1;  ///< -1: none within reach
    };
    /// The nearest wet point to x, which is in a wall's body. Exact where the nearest surface is
    /// wet, else one of points d0/4 apart.
    Foot foot(const Point& x) const;
    /// Points of the surface, d0/4 apart.
    const PointGrid& samples() const { return samples_; }

private:
    void sample(std::size_t wall);
    bool wet(const Point& q, const Point& intoWater) const;

    const CaseGeometry& g_;
    Real reach_;
    PointGrid samples_;
    std::vector<Index> sampleWall_;
};

/// Calls f(centre) for the cells of size `cell` in `box` where |distance| may be below `band`: an
/// octree descends only where the surface can be. |distance| must not exceed the true one.
void forEachCellNear(const BoundingBox& box, int dimension, Real cell, Real band,
                     const std::function<Real(const Point&)>& distance,
                     const std::function<void(const Point&)>& f);

/// The domain, grown by `margin` in directions that are not periodic.
BoundingBox wallLimits(const CaseGeometry& geometry, Real margin);

}  // namespace isph
