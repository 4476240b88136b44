// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of a smooth wall whose boundary layer is thinner than a particle.
//                                                                        [theory (6.10), (6.11)]
#pragma once
#include "core/Types.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

/// Shear stress over density, u*^2 [m2/s2], at a smooth wall where water at `height` [m] above it
/// moves along it with `speed` [m/s].                                              [theory (6.10)]
///   u/u* = 8.3 (y u*/nu)^(1/7), or y u*/nu where that is less
inline Real wallStress(Real speed, Real height, Real nu)
{
    constexpr Real factor = 8.3, exponent = 1.0 / 7;   // [Werner & Wengle 1993]
    const Real inverse = 1 / (1 + exponent);
    const Real turbulent =
        std::pow(speed / factor, inverse) * std::pow(nu / height, exponent * inverse);
    return std::max(nu * speed / height, sqr(turbulent));
}

/// What water at `height` [m] takes of the stress, per metre of depth [1/m]: all of it within a
/// particle's `spacing` [m], evenly, with a ramp over half a spacing, so that a particle on its way
/// is not kicked.                                                                  [theory (6.11)]
inline Real wallLayer(Real height, Real spacing)
{
    constexpr Real outer = 1.25, ramp = 0.5;   // of the spacing
    return std::clamp((outer - height / spacing) / ramp, Real(0), Real(1)) / spacing;
}

}  // namespace isph
