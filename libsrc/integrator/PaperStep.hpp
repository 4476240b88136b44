// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/PressureStage.hpp"
#include "integrator/SchemeKeys.hpp"

namespace isph {

/// The paper's own projection, for comparison: `projection paper;`.                     [theory 10]
///   v*      = v^n + dt k (nu_E lap v + g - a v - b|v|v)     (5), drag explicit; or semi-implicit:
///             [v^n + dt k (nu_E lap v + g)]/(1 + dt k (a + b|v|))
///   lap p   = rho/(k dt) [ div v* + alpha (eps - <rho>/rho0)/dt ]                (15), (16), of i
///   alone v^(n+1) = v* - dt k (grad p)/rho,   x += dt (u^n + u^(n+1))/2
/// with k = eps/C_r, <rho> the apparent density, gravity in the predictor and gradients
/// uncorrected. Where it fails: explicit drag is unstable for dt > 2/(k (a + b|v|)), fine soil at
/// any usual step, and ends in an error there; semi-implicit drag balances a v with (1 + k dt a)
/// grad p, so that Darcy flow depends on the step; water at rest
/// over soil is not at rest; a sealed box with soil has no solution.
template <int Dim>
class PaperStep : public ProjectionStep<Dim> {
public:
    PaperStep(Scene<Dim>& scene, PaperDrag drag, Timers& timers);
    StepReport advance(Real dt, Real dtOld) override;
    void release() override { pressure_ = {}; }

private:
    using ProjectionStep<Dim>::scene_;
    using ProjectionStep<Dim>::timers_;
    using ProjectionStep<Dim>::fields_;

    void coefficients();
    void predict(Real dt);
    void densityTerm(Real dt, StepReport& report);
    void correctAndMove(Real dt);

    PaperDrag drag_;
    PressureStage<Dim> pressure_;
    std::vector<Real> mobility_, inverseMobility_, divergence_;
};

extern template class PaperStep<2>;
extern template class PaperStep<3>;

}  // namespace isph
