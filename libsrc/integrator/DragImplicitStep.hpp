// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "boundaries/WallGuard.hpp"
#include "core/Timers.hpp"
#include "integrator/Scene.hpp"
#include "integrator/StepFields.hpp"
#include "pressure/PressureEquation.hpp"

namespace isph {

/// What a step tells the log.
struct StepReport {
    SolverReport pressure;
    std::size_t unknowns = 0;
    Real continuity = 0;        ///< rms of div u times dt
    Real densityError = 0;      ///< rms of the filling at inner particles, less the lattice's
    Index surfaceParticles = 0;
    Index putBack = 0;          ///< particles the wall guard returned
    int pressureSolves = 0;
};

/// The default projection: drag implicit in predictor, pressure equation and corrector alike.
/// The order of a step is that of docs/theory section 3.
template <int Dim>
class DragImplicitStep {
public:
    DragImplicitStep(Scene<Dim>& scene, Timers& timers);

    /// Advances the water by dt after a step dtOld (0: the first one, by Euler).
    StepReport advance(Real dt, Real dtOld);

    /// Porosity, neighbours and surface at the particles' places, without a step (for output at t = 0).
    void look();

    const StepFields<Dim>& fields() const { return fields_; }

private:
    void move(const StepWeights& weights, StepReport& report);
    template <class Medium>
    void project(const Medium& medium, const StepWeights& weights, StepReport& report);
    void densitySource(const auto& medium, StepReport& report);
    void solvePressure(const auto& medium, StepReport& report);

    Scene<Dim>& scene_;
    Timers& timers_;
    WallGuard<Dim> guard_;
    StepFields<Dim> fields_;
    PressureRows rows_;
    SymmetricMatrix matrix_;
    std::vector<Real> rhs_, unknown_, divergence_;
    std::vector<char> anchored_;
    Real latticeFilling_;
};

extern template class DragImplicitStep<2>;
extern template class DragImplicitStep<3>;

}  // namespace isph
