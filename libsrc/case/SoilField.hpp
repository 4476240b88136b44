// SPDX-License-Identifier: GPL-3.0-or-later
// The smoothed porosity that soil particles make, as the solver will see it.
#pragma once
#include "case/Fill.hpp"
#include "case/PointGrid.hpp"
#include "case/WallLayers.hpp"

#include <algorithm>
#include <numbers>

namespace isph {

/// Wendland C2, W = sigma/h^D (1 - q/2)^4 (1 + 2 q), q = r/h < 2; for laying particles out.
struct PackingKernel {
    int dimension;

    Real sigma() const { return (dimension == 2 ? 7.0 / 4.0 : 21.0 / 16.0) / std::numbers::pi; }
    Real w(Real r, Real h) const
    {
        const Real q = r / h, t = std::max(0.0, 1 - 0.5 * q);
        return sigma() / (dimension == 2 ? sqr(h) : cube(h)) * sqr(sqr(t)) * (1 + 2 * q);
    }
    /// (dW/dr)/r
    Real slope(Real r, Real h) const
    {
        const Real t = std::max(0.0, 1 - 0.5 * r / h);
        return -5 * sigma() * cube(t) / (dimension == 2 ? sqr(sqr(h)) : sqr(sqr(h)) * h);
    }
};

/// Points and their images across the periodic faces, as far as `reach` beyond them.
struct PeriodicPoints {
    std::vector<Point> x;
    std::vector<Index> owner;
    std::vector<Point> shift;  ///< x = that of the owner + shift
    PeriodicPoints(const CaseGeometry& geometry, const std::vector<Point>& points, Real reach);
};

/// eps(x) = 1 - [sum_k solidVolume_k W(x - x_k)]/[1 - sum_w V_w W(x - x_w)]: soil goes on in walls
/// and across periodic faces.                                                       [theory (4.10)]
class SoilField {
public:
    SoilField(const CaseGeometry& geometry, const SoilParticles& soil, const WallParticles& walls);
    Real porosity(const Point& x) const;

private:
    Real weight(const Point& r) const;

    int dimension_;
    Real spacing_, reach_, least_;
    PeriodicPoints soilPoints_, wallPoints_;
    CellRows soilGrid_, wallGrid_;
    std::vector<Real> solid_, wall_;
};

}  // namespace isph
