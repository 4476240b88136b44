// SPDX-License-Identifier: GPL-3.0-or-later
// Which particles form the free surface.                                        [theory (6.1), (6.2)]
#pragma once
#include "operators/Corrections.hpp"

#include <cstdint>
#include <vector>

namespace isph {

enum class SurfaceRole : std::uint8_t {
    inner,   ///< no surface particle in its support
    near,    ///< has surface particles in its support
    surface  ///< lambda below the threshold: its pressure is that of the air, 0
};

/// lambda below which a particle belongs to the surface: 1.5 in 2-D, 2.25 in 3-D (Dim in the bulk).
template <int Dim>
constexpr Real surfaceThreshold() { return 0.75 * Dim; }

/// role[i] of the water particles and their images.
template <int Dim>
void findFreeSurface(const Points<Dim>& points, const PairList<Dim>& pairs,
                     const Corrections<Dim>& corrections, std::vector<SurfaceRole>& role);

}  // namespace isph
