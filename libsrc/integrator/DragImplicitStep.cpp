// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/DragImplicitStep.hpp"

#include "integrator/Corrector.hpp"
#include "integrator/FaceCarry.hpp"
#include "integrator/FaceCrossing.hpp"
#include "integrator/FaceFilter.hpp"
#include "integrator/Predictor.hpp"
#include "integrator/Shifting.hpp"
#include "integrator/SolidsDivergence.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kSoilPorosity = 0.9;      // below it water is pulled into voids of the soil   (5.6)
constexpr Real kLeastSupport = 0.75;     // lambda/Dim for that
constexpr Real kFullSupport = 0.95;      // lambda/Dim above which a thin spot is no surface
constexpr Real kNewest = 0.2;           // share of the newest force in the mean of the past ones
constexpr Real kRepairing = 0.01;        // Courant number that repairs packings one by one (5.12)
constexpr int kRepeats = 10;             // pressure solves of a first step under gravity
}  // namespace

template <int Dim>
DragImplicitStep<Dim>::DragImplicitStep(Scene<Dim>& scene, Timers& timers)
    : ProjectionStep<Dim>(scene, timers),
      flat_(latticeSurface(*scene.kernel, Dim, scene.scheme.h0 / scene.scheme.spacing))
{
}

template <int Dim>
StepReport DragImplicitStep<Dim>::advance(Real dt, Real dtOld)
{
    StepReport report;
    const StepWeights weights{dt, dtOld > 0 ? dt / dtOld : 0};
    if (scene_.porous) knowPorosity();
    move(weights, report);
    this->look();
    if (scene_.turbulence) this->eddies();
    if (scene_.porous) {
        drag();
        if (weights.ratio > 0)
            crossFaces(*scene_.porous, scene_.box, scene_.scheme.spacing, weights, fields_,
                       scene_.water);
        carryThroughFaces(scene_.water, weights, fields_);
        project(WaterInSoil<Dim>{weights.dtPrime(), fields_.soil, fields_.resistance,
                                 scene_.scheme.spacing, fields_.face.v, fields_.face.carriesDarcy},
                weights, report);
        keepPorosity();
    } else {
        project(ClearWater<Dim>{weights.dtPrime()}, weights, report);
    }
    const auto timer = timers_.scope("collisions and shifting");
    collide<Dim>(scene_.scheme, fields_, scene_.wallCloud.normal, scene_.wallCloud.depth,
                 scene_.water);
    report.continuity = shift(*scene_.kernel, scene_.scheme, dt, fields_, scene_.water);
    return report;
}

/// Velocities without a history belong to the porosity where the particles stand.
template <int Dim>
void DragImplicitStep<Dim>::knowPorosity()
{
    Water<Dim>& water = scene_.water;
    if (water.porosity.size() == water.size()) return;
    scene_.porous->evaluate(water.x, fields_.soil);
    water.porosity = water.porosityOld = fields_.soil.porosity;
}

/// Of the velocities that the step found.
template <int Dim>
void DragImplicitStep<Dim>::keepPorosity()
{
    Water<Dim>& water = scene_.water;
    water.porosityOld.swap(water.porosity);
    std::copy_n(fields_.soil.porosity.begin(), water.size(), water.porosity.begin());
}

template <int Dim>
void DragImplicitStep<Dim>::move(const StepWeights& weights, StepReport& report)
{
    const auto timer = timers_.scope("move");
    Water<Dim>& water = scene_.water;
    parallelFor(water.size(), [&](Index i) {
        water.x[i] +=
            weights.dt * (water.u[i] + Real(0.5) * weights.ratio * (water.u[i] - water.uOld[i]));
    });
    report.putBack = this->guard_.keepOut(water.x);
    if (scene_.box.any())
        parallelFor(water.size(), [&](Index i) { water.x[i] = scene_.box.wrap(water.x[i]); });
}

/// r_i = a_i + b_i |v_i| of the step's start.                                             (3.4)
template <int Dim>
void DragImplicitStep<Dim>::drag()
{
    const Points<Dim>& points = fields_.points;
    const Water<Dim>& water = scene_.water;
    auto& soil = fields_.soil;
    fields_.resistance.resize(points.fluid);
    parallelFor(points.water, [&](Index i) {
        fields_.resistance[i] =
            soil.linear[i] + soil.quadratic[i] * water.porosity[i] * norm(water.u[i]);
    });
    points.refresh(fields_.resistance);
}

template <int Dim>
template <class Medium>
void DragImplicitStep<Dim>::project(const Medium& medium, const StepWeights& weights,
                                    StepReport& report)
{
    {
        const auto timer = timers_.scope("predictor");
        predict(scene_.water, scene_.wallCloud, medium, scene_.scheme, weights, fields_);
        if constexpr (Medium::hasSoil)
            filterAtFaces(scene_.water, medium, scene_.scheme, weights, fields_);
    }
    densitySource(medium, report);
    // The surface rows use the force gradient of the step before; a first step has to find it.
    const int repeats = weights.ratio == 0 && norm(scene_.scheme.force) > 0 ? kRepeats : 1;
    std::vector<Vec<Dim>> u, uOld;
    if (repeats > 1) u = scene_.water.u, uOld = scene_.water.uOld;
    for (int k = 0; k < repeats; ++k) {
        if (k > 0) scene_.water.u = u, scene_.water.uOld = uOld;
        expectForce(weights.ratio);
        surfacePressure<Dim>(flat_, scene_.scheme.spacing / scene_.scheme.h0, fields_.points,
                             fields_.pairs, fields_.corrections, fields_.role,
                             scene_.water.forceGradient, scene_.scheme.force, fields_.p);
        const PressureSource<Dim> source{fields_.v,   scene_.water.forceGradient,
                                         divergence_, scene_.scheme.force,
                                         fields_.p,   scene_.scheme.strongest};
        pressure_.solve(scene_, medium, source, {}, timers_, fields_, report);
        const auto timer = timers_.scope("corrector");
        correct(medium, scene_.scheme, fields_, scene_.water);
    }
    if (weights.ratio == 0)
        scene_.water.forceGradientOld = scene_.water.forceGradient;  // no force before
}

/// c_i becomes what it will be at the new time, near the surface no more than the strongest force
/// of the case; the corrector sets it anew. The force of the last step enters the mean of the past
/// ones.                                                                                      (5.4)
template <int Dim>
void DragImplicitStep<Dim>::expectForce(Real ratio)
{
    Water<Dim>& water = scene_.water;
    const Real strongest = std::max(scene_.scheme.strongest, norm(scene_.scheme.force));
    parallelFor(water.size(), [&](Index i) {
        Vec<Dim>&c = water.forceGradient[i], &past = water.forceGradientOld[i];
        past += kNewest * (c - past);
        if (fields_.role[i] == SurfaceRole::inner) return;
        c = atMost(c + (ratio * kNewest / (1 - kNewest)) * (c - past), strongest);
    });
}

/// Divergence that brings the filling of space back to the lattice's, eps dn s^2/T, less the volume
/// that moving solids give way by.                                                (5.5), (5.6)
template <int Dim>
void DragImplicitStep<Dim>::densitySource(const auto& medium, StepReport& report)
{
    const Scheme<Dim>& scheme = scene_.scheme;
    const Water<Dim>& water = scene_.water;
    const Index n = fields_.points.water;
    const Real U = internalSpeed(water.u);
    Real rate = 0;
    if (scheme.stabilisation == Stabilisation::relaxedDensity)
        rate = std::min(1 / scheme.relaxationTime, scheme.speedFactor * U / scheme.spacing);
    if (scheme.stabilisation == Stabilisation::constantAlpha) rate = scheme.alpha / medium.dt;
    divergence_.resize(n);
    LargeArray<Real> error(n), surplusOf;
    fillingSurplus(fields_, medium, lattice_,
                   std::min(Real(1), U * medium.dt / (kRepairing * scheme.spacing)), surplusOf);
    const auto& c = fields_.corrections;
    parallelForDynamic(n, [&](Index i) {
        const Real lambda = c.lambda[i] / Dim;
        const SurfaceRole role = fields_.role[i];
        const Real surplus = surplusOf[i];
        const bool pullsInSoil = medium.porosity(i) < kSoilPorosity && lambda > kLeastSupport
                              && role != SurfaceRole::surface;
        const bool acts =
            surplus > 0 || pullsInSoil || role == SurfaceRole::inner || lambda > kFullSupport;
        const Real wanted = acts ? medium.porosity(i) * sqr(medium.damping(i)) * rate * surplus : 0;
        divergence_[i] = wanted - solidsDivergence(fields_, i);
        error[i] = role == SurfaceRole::inner ? sqr(surplus) : 0;
    });
    report.densityError =
        std::sqrt(orderedSum(n, [&](Index i) { return error[i]; }) / std::max<Index>(1, n));
}

template class DragImplicitStep<2>;
template class DragImplicitStep<3>;

}  // namespace isph
