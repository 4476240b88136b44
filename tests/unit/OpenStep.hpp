// SPDX-License-Identifier: GPL-3.0-or-later
// A step whose fields a test may change.
#pragma once
#include "integrator/DragImplicitStep.hpp"

namespace isph {

template <int Dim>
struct OpenStep : DragImplicitStep<Dim> {
    using DragImplicitStep<Dim>::DragImplicitStep;
    StepFields<Dim>& open() { return this->ProjectionStep<Dim>::fields_; }
};

}  // namespace isph
