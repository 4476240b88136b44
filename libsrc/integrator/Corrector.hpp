// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// Darcy velocity after pressure, gravity and drag:                                  [theory (3.6)]
///   v_i = s_i w_i - sum_j V_j { beta_ij [(p_j - p_i)/rho + B_ij - g.(x_j - x_i)]
///                               - (s_i - s_ij)/2 ((w_i + w_j).n)(n.x_ij) } L_i gradW_ij
///         + beta_i (I - L_i A_i) g
/// over water partners; B_ij is what the speed in pores takes of the pressure (3.13). The last term
/// is the gravity that a blended gradient does not see: drops and sprays fall freely. The carried
/// pore velocity u = v/eps and its history are updated in `water`, as is c = (grad p)/rho - g,
/// which the next step's pressure equation uses near the surface.
template <int Dim, class Medium>
void correct(const Medium& medium, const Scheme<Dim>& scheme, StepFields<Dim>& fields,
             Water<Dim>& water);

}  // namespace isph
