// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// The force c of the last step as a particle feels it that has crossed a face of soil since:
///   c += (r_before - r_now) (v.n) n                                               [theory (5.13)]
/// for inner particles. What accelerates the water, c + r v, is continuous through a face; drag
/// jumps.
/// in      x of the new time, u and porosities of the last step; soil, roles and resistance now
/// in out  water.forceGradient
template <int Dim>
void crossFaces(const PorousField<Dim>& field, const PeriodicBox<Dim>& box, Real spacing,
                const StepWeights& weights, const StepFields<Dim>& fields, Water<Dim>& water);

}  // namespace isph
