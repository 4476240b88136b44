// SPDX-License-Identifier: GPL-3.0-or-later
// What system/isphSchemes and constant/ say about the time step, read once.
#pragma once
#include "core/Vec.hpp"

#include <limits>

namespace isph {

enum class Stabilisation { none, relaxedDensity, constantAlpha };

/// Numbers of the scheme and of the water; lengths and times are physical, so a scaled twin of a
/// case scales with them.
template <int Dim>
struct Scheme {
    Real spacing = 0;                 ///< d0 [m]
    Real h0 = 0;                      ///< smoothing length in clear water [m]
    Real density = 1000;              ///< rho0 [kg/m3]
    Real viscosity = 1e-6;            ///< nu [m2/s]
    Vec<Dim> force{};                 ///< g + body force [m/s2]
    Real strongest = 0;  ///< |c| that counts near the surface, if above |g|    [theory (5.4)]
    /// Surface particles carry the water above them (6.9); the paper's do not
    bool surfaceCarries = true;

    Stabilisation stabilisation = Stabilisation::relaxedDensity;
    Real relaxationTime = 0.1;  ///< T of the density source [s]                      [theory (5.5)]
    Real alpha = 0.01;                ///< of constantAlpha, the paper's (16)
    Real speedFactor = 0.1;  ///< c_tau: the source repairs at most at this share of max|u|/d0
    Real shifting = 10;               ///< A of (7.1), 0 = none
    Real largestShift = 0.05;         ///< in local spacings
    Real dissipation = 16;            ///< c_r of (7.3)
    /// At the surface velocity differences dissipate with their smooth part
    bool wholeAtSurface = true;
    /// In local spacings                                [theory (7.4)]
    Real collisionDistance = 0.5;

    Real particleVolume() const { return Dim == 2 ? sqr(spacing) : cube(spacing); }
};

/// Weights of BDF2 and of the extrapolation for a step dt after a step dtOld.
///                                                                            [theory (3.1), (3.2)]
struct StepWeights {
    Real dt = 0;          ///< the step
    Real ratio = 1;       ///< omega = dt/dtOld, 0 in the first step (Euler)

    /// dt' = dt (1 + omega)/(1 + 2 omega)
    Real dtPrime() const { return dt * (1 + ratio) / (1 + 2 * ratio); }
    /// v* of the time derivative: ((1 + omega)^2 v^n - omega^2 v^(n-1))/(1 + 2 omega)
    Real now() const { return sqr(1 + ratio) / (1 + 2 * ratio); }
    Real before() const { return -sqr(ratio) / (1 + 2 * ratio); }
    /// (1 + omega) u^n - omega u^(n-1), what u will be at the new time
    auto extrapolated(const auto& u, const auto& uOld) const
    {
        return (1 + ratio) * u - ratio * uOld;
    }
};

}  // namespace isph
