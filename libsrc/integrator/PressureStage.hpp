// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/ProjectionStep.hpp"
#include "pressure/Components.hpp"
#include "pressure/PressureEquation.hpp"

namespace isph {

/// Assembles and solves the pressure equation of a step; its smaller arrays are used again.
template <int Dim>
class PressureStage {
public:
    /// rowFactor: multiplies the right-hand side of each water particle's row; empty: 1.
    /// out  fields.p of water and images [m2/s2], scene.water.p [Pa], the report of the solver
    template <class Medium>
    void solve(Scene<Dim>& scene, const Medium& medium, const PressureSource<Dim>& source,
               Span<const Real> rowFactor, Timers& timers, StepFields<Dim>& fields,
               StepReport& report);

private:
    PressureRows rows_;
    ComponentFinder components_;
    std::vector<Real> rhs_, unknown_;
    std::vector<char> anchored_;
};

}  // namespace isph
