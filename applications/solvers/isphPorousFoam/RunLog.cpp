// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunLog.hpp"

#include "core/Log.hpp"
#include "integrator/ExplicitDrag.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include <sys/resource.h>

namespace isph {

namespace {

constexpr int kMostNotConverged = 20;   // steps in a row

const char* describe(Stabilisation type)
{
    switch (type) {
        case Stabilisation::relaxedDensity: return "relaxedDensity";
        case Stabilisation::constantAlpha: return "constantAlpha";
        case Stabilisation::none: break;
    }
    return "none";
}

struct Parts {
    std::vector<std::string> active, leftOut;
    void add(bool used, const std::string& name, const std::string& why)
    {
        (used ? active : leftOut).push_back(used || why.empty() ? name : name + " (" + why + ")");
    }
};

/// The step that explicit drag bears, where the scheme has it.
template <int Dim>
void logExplicitDrag(const CaseFiles& files, const Scene<Dim>& scene)
{
    const bool paper = readProjection(files.schemes) == Projection::paper;
    if (!paper || !scene.porous || readPaperDrag(files.schemes) != PaperDrag::explicitly) return;
    for (const SoilZone& zone : scene.porous->zones())
        info("Explicit drag in zone {}: stable for steps below {:.4g} s, less where water is fast",
             zone.name, explicitDragLimit(zone));
}

/// The most memory that this process has held [bytes].
double peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

template <int Dim>
void logScene(const CaseFiles& files, const Scene<Dim>& scene)
{
    const Scheme<Dim>& scheme = scene.scheme;
    info("Particles: {} water, {} wall, {} soil; d0 = {:g} m, {} dimensions", scene.water.size(),
         scene.walls.size(), scene.soil.size(), scheme.spacing, Dim);
    info("Kernel: {}, h/d0 = {:g}", schemeKeys().get<std::string>(files.schemes, "kernel"),
         scheme.h0 / scheme.spacing);
    info("Water: rho = {:g} kg/m3, nu = {:g} m2/s, g + body force = ({:g}) m/s2", scheme.density,
         scheme.viscosity, fmt::join(scheme.force.c, " "));
    info("Projection: {}", schemeKeys().get<std::string>(files.schemes, "projection"));
    info("Stabilisation: {}, relaxation time {:g} s", describe(scheme.stabilisation),
         scheme.relaxationTime);
    info("Pressure solver: {}",
         SolverControls::keys().get<std::string>(files.solution.subDict("pressure"), "solver"));
    if (scene.porous) {
        info("Soil:");
        for (const SoilZone& zone : scene.porous->zones())
            info("{}", describe(zone.name, *zone.model, scheme.viscosity));
    }
    logExplicitDrag(files, scene);
    if (scene.turbulence) info("Turbulence: {}", scene.turbulence->formula());

    Parts parts;
    const bool hasZones = !files.porousZones.keywords().empty();
    parts.add(true, "water", "");
    parts.add(scene.walls.size() > 0, "walls", "no walls.vtp");
    parts.add(!scene.wallCloud.noSlip.empty() || !scene.wallCloud.wallLaw.empty(), "wall friction",
              "all walls slip");
    parts.add(scene.box.any(), "periodic images", "no periodic direction");
    parts.add(scene.porous != nullptr, "porous media",
              hasZones ? "no soil particles" : "no constant/porousZones");
    parts.add(scene.turbulence != nullptr, "turbulence", "laminar");
    parts.add(files.hasErosion, "erosion", "no constant/erosionProperties");
    parts.add(scheme.stabilisation != Stabilisation::none, "density stabilisation", "type none");
    const bool paper = readProjection(files.schemes) == Projection::paper;
    parts.add(scheme.shifting > 0 && !paper, "shifting",
              paper ? "projection paper" : "coefficient 0");
    parts.add(scheme.dissipation > 0 && !paper, "dissipation",
              paper ? "projection paper" : "coefficient 0");
    parts.add(Dim == 3, "z direction", "2-D");
    info("Active: {}", fmt::join(parts.active, ", "));
    info("Left out: {}\n",
         parts.leftOut.empty() ? "nothing" : fmt::format("{}", fmt::join(parts.leftOut, ", ")));
}

void logStepStart(const Time& time, Real meanCo, Real maxCo)
{
    info("Courant Number mean: {:.6g} max: {:.6g}", meanCo, maxCo);
    info("deltaT = {:.8g}", time.deltaT());
    info("Time = {}s\n", fmt::format("{:.10g}", time.value()));
}

StepLog::StepLog() : wallStart_(wallSeconds()) {}

void StepLog::write(const Time& time, const StepReport& report)
{
    const SolverReport& p = report.pressure;
    info("{}:  Solving for p, Initial residual = {:.6g}, Final residual = {:.6g}, No Iterations {}",
         p.solver, p.initialResidual, p.finalResidual, p.iterations);
    if (!p.remark.empty()) info("{}: {}", p.solver, p.remark);
    cumulative_ += report.continuity;
    info("time step continuity errors : sum local = {:.6g}, global = {:.6g}, cumulative = {:.6g}",
         report.continuity, report.densityError, cumulative_);
    info("unknowns {}  surface particles {}  put back by walls {}", report.unknowns,
         report.surfaceParticles, report.putBack);
    if (p.converged) {
        notConverged_ = 0;
    } else {
        ++notConverged_;
        warning(
            "the pressure did not converge at time {:g} s: residual {:g} after {} iterations ({} "
            "of {} "
            "steps in a row)",
            time.value(), p.finalResidual, p.iterations, notConverged_, kMostNotConverged);
        if (notConverged_ >= kMostNotConverged)
            throw FatalError(
                fmt::format("The pressure did not converge in {} steps in a row, residual {:g} at "
                            "time {:g} s.\n"
                            "Raise maxIter or choose another solver in system/isphSolution.",
                            kMostNotConverged, p.finalResidual, time.value()));
    }
    info("Progress = {:.2f} %  time left = {:.0f} s", time.progress(), time.secondsLeft());
    info("ExecutionTime = {:.2f} s  ClockTime = {:.0f} s\n", cpuSeconds(),
         wallSeconds() - wallStart_);
}

template <int Dim>
void logExtent(const Water<Dim>& water)
{
    Vec<Dim> low = water.x.front(), high = low;
    for (const Vec<Dim>& x : water.x)
        for (int d = 0; d < Dim; ++d)
            low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
    info("Extent of the water: ({:.6g}) to ({:.6g})\n", fmt::join(low.c, " "),
         fmt::join(high.c, " "));
}

void logTimings(const Timers& timers, std::size_t particles, Real particleSteps, double seconds)
{
    info("Time of the parts of the run:");
    std::vector<Timers::Part> parts = timers.parts();
    std::sort(parts.begin(), parts.end(),
              [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
    for (const auto& part : parts)
        info("    {:<26} {:>10.3f} s {:>6.1f} %", part.name, part.seconds,
             100 * part.seconds / seconds);
    info("    {:<26} {:>10.3f} s", "run", seconds);
    info("Particle-steps per second: {:.4g}", particleSteps / seconds);
    const double memory = peakMemory();
    info("Peak memory: {:.1f} MB for {} particles, {:.2f} kB each\n", 1e-6 * memory, particles,
         1e-3 * memory / static_cast<double>(particles));
}

template void logScene(const CaseFiles&, const Scene<2>&);
template void logScene(const CaseFiles&, const Scene<3>&);
template void logExtent(const Water<2>&);
template void logExtent(const Water<3>&);

}  // namespace isph
