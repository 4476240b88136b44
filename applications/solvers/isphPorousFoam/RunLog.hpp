// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells its user, in OpenFOAM's words where tools parse them.
#pragma once
#include "ReadScene.hpp"
#include "case/Time.hpp"
#include "core/Timers.hpp"
#include "integrator/ProjectionStep.hpp"

namespace isph {

/// Particles, scheme, soil zones; which parts are active, which are left out and why.
template <int Dim>
void logScene(const CaseFiles& files, const Scene<Dim>& scene);

/// "Courant Number mean: a max: b", "deltaT = ...", "Time = 0.05s" at the beginning of a step.
void logStepStart(const Time& time, Real meanCo, Real maxCo);

/// Solver, continuity and volume errors, progress, ExecutionTime at its end. Warns of a pressure
/// that did not converge; throws FatalError at the twentieth in a row.
class StepLog {
public:
    StepLog();
    void write(const Time& time, const StepReport& report);

private:
    double wallStart_;
    Real cumulative_ = 0;
    int notConverged_ = 0;
};

/// Corners of the box around the water, where a state is written.
template <int Dim>
void logExtent(const Water<Dim>& water);

/// Time per part of the step, particle-steps per second, peak memory.
void logTimings(const Timers& timers, std::size_t particles, Real particleSteps, double seconds);

}  // namespace isph
