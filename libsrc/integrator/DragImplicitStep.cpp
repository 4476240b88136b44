// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/DragImplicitStep.hpp"

#include "integrator/Corrector.hpp"
#include "integrator/Predictor.hpp"
#include "integrator/Shifting.hpp"

#include <cmath>

namespace isph {

namespace {
constexpr Real kSoilPorosity = 0.9;      // below it water is pulled into voids of the soil   (5.6)
constexpr Real kLeastSupport = 0.75;     // lambda/Dim for that
constexpr Real kFullSupport = 0.95;      // lambda/Dim above which a thin spot is no surface
constexpr int kRepeats = 3;              // pressure solves of a first step

/// sum_j V_j W_ij on a full lattice of spacing d0.
template <int Dim>
Real fillingOfLattice(const Kernel& kernel, Real hOverSpacing)
{
    const int m = static_cast<int>(std::ceil(kernel.supportRadius() * hOverSpacing));
    Real sum = 0;
    for (int a = -m; a <= m; ++a)
        for (int b = -m; b <= m; ++b)
            for (int c = (Dim == 3 ? -m : 0); c <= (Dim == 3 ? m : 0); ++c) {
                const Real q = std::sqrt(Real(a * a + b * b + c * c)) / hOverSpacing;
                Real w = 0, slope = 0;
                if (q < kernel.supportRadius())
                    kernel.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
                sum += w;
            }
    return sum * kernel.normalisation(Dim) / std::pow(hOverSpacing, Dim);
}
}  // namespace

template <int Dim>
DragImplicitStep<Dim>::DragImplicitStep(Scene<Dim>& scene, Timers& timers)
    : scene_(scene), timers_(timers), guard_(scene.wallCloud, scene.scheme.spacing),
      latticeFilling_(fillingOfLattice<Dim>(*scene.kernel, scene.scheme.h0 / scene.scheme.spacing))
{
    fields_.noSlip = scene.noSlip;
}

template <int Dim>
StepReport DragImplicitStep<Dim>::advance(Real dt, Real dtOld)
{
    StepReport report;
    const StepWeights weights{dt, dtOld > 0 ? dt / dtOld : 0};
    move(weights, report);
    look();
    if (scene_.porous) {
        const auto& u = scene_.water.u;
        auto& soil = fields_.soil;
        fields_.resistance.resize(fields_.points.fluid);
        parallelFor(fields_.points.water, [&](Index i) {
            fields_.resistance[i] = soil.linear[i] + soil.quadratic[i] * soil.porosity[i] * norm(u[i]);
        });
        fields_.points.refresh(fields_.resistance);
        project(WaterInSoil<Dim>{weights.dtPrime(), soil, fields_.resistance}, weights, report);
    } else {
        project(ClearWater<Dim>{weights.dtPrime()}, weights, report);
    }
    const auto timer = timers_.scope("collisions and shifting");
    collide<Dim>(scene_.scheme, fields_, scene_.wallCloud.normal, scene_.wallCloud.depth, scene_.water);
    report.continuity = shift(*scene_.kernel, scene_.scheme, dt, fields_, scene_.water);
    return report;
}

template <int Dim>
void DragImplicitStep<Dim>::move(const StepWeights& weights, StepReport& report)
{
    const auto timer = timers_.scope("move");
    Water<Dim>& water = scene_.water;
    parallelFor(water.size(), [&](Index i) {
        water.x[i] += weights.dt * (water.u[i] + Real(0.5) * weights.ratio * (water.u[i] - water.uOld[i]));
    });
    report.putBack = guard_.keepOut(water.x);
    if (scene_.box.any())
        parallelFor(water.size(), [&](Index i) { water.x[i] = scene_.box.wrap(water.x[i]); });
}

template <int Dim>
void DragImplicitStep<Dim>::look()
{
    const Water<Dim>& water = scene_.water;
    const Scheme<Dim>& scheme = scene_.scheme;
    Points<Dim>& points = fields_.points;
    auto& soil = fields_.soil;
    if (scene_.porous) {
        const auto timer = timers_.scope("porosity");
        scene_.porous->evaluate(water.x, soil);
    } else {
        soil.porosity.assign(water.size(), 1);
    }
    {
        const auto timer = timers_.scope("neighbours");
        layPoints<Dim>(water, soil.porosity, scene_.wallCloud, scene_.box, scheme.spacing, scheme.h0,
                       scene_.kernel->supportRadius(), points);
        dryWalls(scene_.wallCloud, scheme.spacing, scheme.h0, points);
        fields_.pairs.build(points, *scene_.kernel);
    }
    const auto timer = timers_.scope("corrections and surface");
    fields_.corrections.compute(points, fields_.pairs);
    findFreeSurface(points, fields_.pairs, fields_.corrections, fields_.role);
    if (scene_.porous) {
        const auto refresh = [&](auto& field) { field.resize(points.fluid), points.refresh(field); };
        refresh(soil.porosity), refresh(soil.share), refresh(soil.mobility), refresh(soil.normal);
    }
}

template <int Dim>
template <class Medium>
void DragImplicitStep<Dim>::project(const Medium& medium, const StepWeights& weights, StepReport& report)
{
    {
        const auto timer = timers_.scope("predictor");
        predict(scene_.water, medium, scene_.scheme, weights, fields_);
    }
    densitySource(medium, report);
    // The surface rows use the force gradient of the step before; a first step has to find it.
    const int repeats = weights.ratio == 0 ? kRepeats : 1;
    const Water<Dim> before = repeats > 1 ? scene_.water : Water<Dim>{};
    for (int k = 0; k < repeats; ++k) {
        if (k > 0) scene_.water.u = before.u, scene_.water.uOld = before.uOld;
        solvePressure(medium, report);
        const auto timer = timers_.scope("corrector");
        correct(medium, scene_.scheme, fields_, scene_.water);
    }
}

/// Divergence that brings the filling of space back to the lattice's: eps dn s^2/T.     (5.5), (5.6)
template <int Dim>
void DragImplicitStep<Dim>::densitySource(const auto& medium, StepReport& report)
{
    const Scheme<Dim>& scheme = scene_.scheme;
    const Water<Dim>& water = scene_.water;
    const Index n = fields_.points.water;
    const Real U = std::sqrt(orderedMax(n, 0, [&](Index i) { return normSqr(water.u[i]); }));
    Real rate = 0;
    if (scheme.stabilisation == Stabilisation::relaxedDensity)
        rate = std::min(1 / scheme.relaxationTime, scheme.speedFactor * U / scheme.spacing);
    if (scheme.stabilisation == Stabilisation::constantAlpha) rate = scheme.alpha / medium.dt;
    divergence_.resize(n);
    std::vector<Real> error(n, 0);
    const auto& c = fields_.corrections;
    parallelFor(n, [&](Index i) {
        const Real surplus = c.filling[i] - latticeFilling_;
        const Real lambda = c.lambda[i] / Dim;
        const SurfaceRole role = fields_.role[i];
        const bool pullsInSoil = medium.porosity(i) < kSoilPorosity && lambda > kLeastSupport
                              && role != SurfaceRole::surface;
        const bool acts = surplus > 0 || pullsInSoil || role == SurfaceRole::inner || lambda > kFullSupport;
        divergence_[i] = acts ? medium.porosity(i) * sqr(medium.damping(i)) * rate * surplus : 0;
        if (role == SurfaceRole::inner) error[i] = sqr(surplus);
    });
    report.densityError = std::sqrt(orderedSum(n, [&](Index i) { return error[i]; }) / std::max<Index>(1, n));
}

template <int Dim>
void DragImplicitStep<Dim>::solvePressure(const auto& medium, StepReport& report)
{
    const Points<Dim>& points = fields_.points;
    Water<Dim>& water = scene_.water;
    {
        const auto timer = timers_.scope("pressure assembly");
        rows_.number(fields_.role, points.water);
        const PressureSource<Dim> source{fields_.v, water.forceGradient, divergence_, scene_.scheme.force};
        assemble(points, fields_.pairs, fields_.corrections, fields_.role, medium, source, rows_, matrix_,
                 rhs_, anchored_);
    }
    const auto timer = timers_.scope("pressure solve");
    unknown_.resize(rows_.size());
    parallelFor(rows_.size(), [&](Index r) { unknown_[r] = water.p[rows_.particle[r]] / scene_.scheme.density; });
    report.pressure = scene_.solver->solve(matrix_, rhs_, unknown_);
    report.unknowns = rows_.size();
    ++report.pressureSolves;
    report.surfaceParticles = points.water - static_cast<Index>(rows_.size());
    fields_.p.resize(points.fluid);
    parallelFor(points.water, [&](Index i) {
        fields_.p[i] = rows_.row[i] < 0 ? 0 : unknown_[rows_.row[i]];
        water.p[i] = scene_.scheme.density * fields_.p[i];
    });
    points.refresh(fields_.p);
}

template class DragImplicitStep<2>;
template class DragImplicitStep<3>;

}  // namespace isph
