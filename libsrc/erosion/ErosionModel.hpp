// SPDX-License-Identifier: GPL-3.0-or-later
// When water takes a grain away from the bed.                                         [theory 9]
#pragma once
#include "core/Types.hpp"
#include "selection/ModelTable.hpp"

#include <string>

namespace isph {

/// The law of one bed material. It judges; others find the bed and move its particles.
class ErosionModel {
public:
    static constexpr const char* family = "erosionModel";
    using Table = ModelTable<ErosionModel>;
    static Table& table();
    /// The model that constant/erosionProperties names: erosionModel <type>; <type>Coeffs {...}.
    static std::unique_ptr<ErosionModel> select(const Dictionary& erosionProperties);

    virtual ~ErosionModel() = default;

    /// The speed of the water along the bed, at the grain, above which a grain is taken away.
    /// in   slopeDownFlow[N] theta [rad], the angle of the bed below the horizontal in the
    ///      direction of the flow: positive where the water runs downslope;  rho [kg/m3] of the
    ///      water;  g = |g| [m/s2]
    /// out  uLimit[N] [m/s], overwritten, >= 0
    virtual void threshold(Span<const Real> slopeDownFlow, Real rho, Real g,
                           Span<Real> uLimit) const = 0;
    /// Density of the grains [kg/m3].
    virtual Real solidDensity() const = 0;
    /// Diameter of the grains [m].
    virtual Real grainDiameter() const = 0;
    /// The formula in one line with its coefficients, for the log.
    virtual std::string formula() const = 0;
};

}  // namespace isph
