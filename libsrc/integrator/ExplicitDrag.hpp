// SPDX-License-Identifier: GPL-3.0-or-later
// The step that drag in an explicit predictor bears.                                [theory (10.2)]
#pragma once
#include "integrator/Scene.hpp"
#include "integrator/StepFields.hpp"

namespace isph {

/// Explicit drag multiplies a velocity by 1 - k dt (a + b|v|) in a step, k = eps/C_r: it grows and
/// changes its sign every step where dt > 2/(k (a + b|v|)). This is the least limit of water at
/// rest in a zone [s], that of its surface, where k is larger than inside and the drag already
/// full; infinite where a = 0.
Real explicitDragLimit(const SoilZone& zone);

/// in   v  superficial velocity of the water particles [m/s], and of images behind them
/// Throws FatalError that names limit, step, zone, a, place and remedies where a particle is beyond
/// it.
template <int Dim>
void requireStableDrag(const Scene<Dim>& scene, const StepFields<Dim>& fields,
                       Span<const Vec<Dim>> v, Real dt);

}  // namespace isph
