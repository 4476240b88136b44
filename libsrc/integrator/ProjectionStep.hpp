// SPDX-License-Identifier: GPL-3.0-or-later
// What every projection shares: where the particles stand, and what a step tells the log.
#pragma once
#include "boundaries/WallGuard.hpp"
#include "core/Timers.hpp"
#include "integrator/Filling.hpp"
#include "integrator/Scene.hpp"
#include "integrator/StepFields.hpp"

namespace isph {

struct StepReport {
    SolverReport pressure;
    std::size_t unknowns = 0;
    Real continuity = 0;        ///< rms of dt div u at inner particles
    Real densityError = 0;      ///< rms of the filling at inner particles, less the lattice's
    Index surfaceParticles = 0;
    Index putBack = 0;          ///< particles that the wall guard returned
};

template <int Dim>
class ProjectionStep {
public:
    ProjectionStep(Scene<Dim>& scene, Timers& timers);
    virtual ~ProjectionStep() = default;

    /// Advances the water by dt after a step dtOld (0: there was none, the first step is Euler's).
    virtual StepReport advance(Real dt, Real dtOld) = 0;

    /// Porosity, neighbours, corrections and surface where the particles stand now.
    void look();

    /// Gives the arrays of the pressure equation back until the next step.
    virtual void release() = 0;

    /// Gives pairs and corrections back until the next look: makes room where a state is written.
    void rest() { fields_.pairs.release(), fields_.corrections = {}; }

    const StepFields<Dim>& fields() const { return fields_; }

protected:
    /// nu_T of water and images, of scenes with a turbulence model.                      (8.1)
    void eddies();

    Scene<Dim>& scene_;
    Timers& timers_;
    WallGuard<Dim> guard_;
    StepFields<Dim> fields_;
    LatticeSums lattice_;   ///< of spacing d0
};

extern template class ProjectionStep<2>;
extern template class ProjectionStep<3>;

}  // namespace isph
