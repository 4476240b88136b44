// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// U = max |u - mean u|: how fast the water moves in itself, the same for any observer, so that a
/// falling drop is at rest [m/s].
template <int Dim>
Real internalSpeed(const std::vector<Vec<Dim>>& u);

/// Evens out the particles without moving the flow:                              [theory (7.1), (7.2)]
///   dx_i = - A h_i dt U sum_j V_j [1 + 0.2 (W_ij/W(s_i))^4] gradW_ij,   |dx| <= 0.05 s_i
/// Surface particles stay; those near the surface move along it only, and not where lambda < 0.6 Dim.
/// u and its history follow by dx.grad u. Inside soil nothing is shifted: it would drain the pores.
/// Returns the rms of div u at inner particles, times dt: the continuity error of the step.
template <int Dim>
Real shift(const Kernel& kernel, const Scheme<Dim>& scheme, Real dt, const StepFields<Dim>& fields,
           Water<Dim>& water);

/// Water particles nearer than the collision distance that approach lose the approach in equal parts,
/// and water that approaches a wall nearer than that loses the normal velocity.         [theory (7.4)]
template <int Dim>
void collide(const Scheme<Dim>& scheme, const StepFields<Dim>& fields, Span<const Vec<Dim>> wallNormal,
             Span<const Real> wallDepth, Water<Dim>& water);

}  // namespace isph
