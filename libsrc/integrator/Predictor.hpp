// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// Velocity before pressure, gravity and drag act:                                   [theory (3.3)]
///   w_i = eps_i (c0 u_i^n + c1 u_i^(n-1)) + k_i dt' (viscosity + dissipation of the extrapolated
///   v)
/// In soil its first part is that of (3.12), which fields.v brings in, as fields.face.v does the
/// extrapolated v.
/// viscosity    sum_j V_j nu_ij F_ij (v_j - v_i) 2 Dim/(lambda_i + lambda_j), nu_ij that of two
///              media (nu + nu_T)/eps in series; walls take part where they do not slip.
/// dissipation  - sum_j 2 V_j F_ij c_r |v_ij.x_ij| (v_ij.e_ij) e_ij, quadratic in velocity
///              differences; not across the face of soil, nor where friction resolves the shear.
///                                                                            [theory (7.3), (7.8)]
/// out          fields.v of water and images.
template <int Dim, class Medium>
void predict(const Water<Dim>& water, const WallCloud<Dim>& walls, const Medium& medium,
             const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields);

}  // namespace isph
