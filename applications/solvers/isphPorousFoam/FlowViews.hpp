// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "functionObjects/FlowView.hpp"
#include "integrator/ProjectionStep.hpp"

namespace isph {

/// The flow as function objects see it; made only when one is due.
template <int Dim>
FlowView flowView(const Scene<Dim>& scene, const StepFields<Dim>& fields, Real time);

}  // namespace isph
