// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// Smooths the predictor's velocity beside faces of soil:                            [theory (7.6)]
///   w_i -= k_i dt' sum_j V_j F_ij 2 Dim/(lambda_i + lambda_j) nu_f (v_ij - (grad v_i + grad v_j)
///          x_ij/2)
/// over partners of the same zone, both of which are inner and have partners in another zone; nu_f
/// is up to h0^2/(250 dt'). There the divergence and the gradient are not each other's adjoint, and
/// noise that the projection cannot see grows by up to a per cent a step, whatever the step.
/// in and out   fields.v of water and images.
template <int Dim>
void filterAtFaces(const Water<Dim>& water, const WaterInSoil<Dim>& medium,
                   const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields);

}  // namespace isph
