// SPDX-License-Identifier: GPL-3.0-or-later
// Which particles form the free surface, and their pressure.           [theory (6.1), (6.2), (6.9)]
#pragma once
#include "operators/Corrections.hpp"

#include <cstdint>
#include <vector>

namespace isph {

enum class SurfaceRole : std::uint8_t {
    inner,   ///< no surface particle in its support
    near,    ///< has surface particles in its support
    surface  ///< lambda below the threshold: its pressure is known
};

/// lambda below which a particle belongs to the surface: 1.5 in 2-D, 2.25 in 3-D (Dim in the bulk).
template <int Dim>
constexpr Real surfaceThreshold() { return 0.75 * Dim; }

/// role[i] of the water particles and their images.
template <int Dim>
void findFreeSurface(const Points<Dim>& points, const PairList<Dim>& pairs,
                     const Corrections<Dim>& corrections, std::vector<SurfaceRole>& role);

/// A flat surface of a lattice: lambda of its first row, how much it rises for a particle of that
/// row that is moved inwards, by a spacing, and how much for all of it where the flow thickens its
/// rows so far that the water above the centres of the first is a spacing higher.
struct FlatSurface {
    Real lambda = 0, rise = 1, thickening = 1;
};

FlatSurface latticeSurface(const Kernel& kernel, int dimension, Real hOverSpacing);

/// p/rho0 of the surface particles [m2/s2], 0 of the others: that of the water above their centres,
///                                                                                            (6.9)
///   p_i/rho0 = s_i max(0, 1/2 + <b>/lambda_e' + 1/4 (b_i - <b>)/lambda_1') <-(c + g).n>,   b =
///   lambda - lambda_1
/// <> is the mean over the surface particles in the support.
/// forceGradient: c_i = (grad p)/rho0 - g at the new time, as far as it counts.
template <int Dim>
void surfacePressure(const FlatSurface& surface, Real spacingOverH, const Points<Dim>& points,
                     const PairList<Dim>& pairs, const Corrections<Dim>& corrections,
                     const std::vector<SurfaceRole>& role, Span<const Vec<Dim>> forceGradient,
                     const Vec<Dim>& force, std::vector<Real>& p);

}  // namespace isph
