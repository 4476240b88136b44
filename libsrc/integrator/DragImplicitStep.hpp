// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/PressureStage.hpp"
#include "integrator/ProjectionStep.hpp"

namespace isph {

/// The default projection: drag implicit in predictor, pressure equation and corrector alike.
/// The order of a step is that of docs/theory section 3.
template <int Dim>
class DragImplicitStep : public ProjectionStep<Dim> {
public:
    DragImplicitStep(Scene<Dim>& scene, Timers& timers);
    StepReport advance(Real dt, Real dtOld) override;
    void release() override { pressure_ = {}; }

private:
    using ProjectionStep<Dim>::scene_;
    using ProjectionStep<Dim>::timers_;
    using ProjectionStep<Dim>::fields_;
    using ProjectionStep<Dim>::lattice_;

    void knowPorosity();
    void keepPorosity();
    void move(const StepWeights& weights, StepReport& report);
    void drag();
    template <class Medium>
    void project(const Medium& medium, const StepWeights& weights, StepReport& report);
    void expectForce(Real ratio);
    void densitySource(const auto& medium, StepReport& report);
    PressureStage<Dim> pressure_;
    FlatSurface flat_;
    std::vector<Real> divergence_;         ///< wanted after the step [1/s]
};

extern template class DragImplicitStep<2>;
extern template class DragImplicitStep<3>;

}  // namespace isph
