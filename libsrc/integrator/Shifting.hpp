// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// U = max |u - mean u|: how fast the water moves in itself, the same for any observer, so that a
/// falling drop is at rest [m/s].
template <int Dim>
Real internalSpeed(const std::vector<Vec<Dim>>& u);

/// Evens out the particles without moving the flow:                           [theory (7.1), (7.2)]
///   d_i = - A h_i dt U_i sum_j V_j [1 + 0.2 (W_ij/W(s_i))^4] gradW_ij,   |d|, |dx| <= 0.05 s_i
///   dx_i = d_i - <d>_i of inner particles but in tips between walls, d_i of others
/// with U_i the largest velocity difference to a neighbour in water [m/s] and <d> the mean over
/// neighbours. At and near the surface particles move along it only; those of the surface with a
/// wall in their support stay, as do those with lambda < 0.4 Dim. Inside soil nothing is shifted:
/// it would drain the pores.
///   u += dx.grad u + |dx|^2/(2 Dim) lap u, and its history; the Laplacian (7.7) of inner
///        particles clear of walls
/// Returns the rms of div u at inner particles, times dt: the continuity error of the step.
template <int Dim>
Real shift(const Kernel& kernel, const Scheme<Dim>& scheme, Real dt, const StepFields<Dim>& fields,
           Water<Dim>& water);

/// Water particles nearer than the collision distance that approach lose the approach in equal
/// parts, and water that approaches a wall nearer than that loses the normal velocity. Between two
/// particles of the surface the distance is 0.95 local spacings.                     [theory (7.4)]
template <int Dim>
void collide(const Scheme<Dim>& scheme, const StepFields<Dim>& fields,
             Span<const Vec<Dim>> wallNormal, Span<const Real> wallDepth, Water<Dim>& water);

}  // namespace isph
