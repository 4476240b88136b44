// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/PaperStep.hpp"

#include "integrator/ExplicitDrag.hpp"
#include "integrator/SolidsDivergence.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

template <int Dim>
PaperStep<Dim>::PaperStep(Scene<Dim>& scene, PaperDrag drag, Timers& timers)
    : ProjectionStep<Dim>(scene, timers), drag_(drag)
{
}

template <int Dim>
StepReport PaperStep<Dim>::advance(Real dt, Real)
{
    StepReport report;
    this->look();
    if (scene_.turbulence) this->eddies();
    coefficients();
    predict(dt);
    densityTerm(dt, report);
    // Uncorrected divergence; gravity is in the predictor and nothing is deferred.
    std::fill(fields_.corrections.L.begin(), fields_.corrections.L.end(), Mat<Dim>::identity());
    const std::vector<Vec<Dim>> nothing(scene_.water.size());
    const PressureSource<Dim> source{fields_.v, nothing, divergence_, Vec<Dim>{}};
    pressure_.solve(scene_, ClearWater<Dim>{dt}, source, inverseMobility_, timers_, fields_,
                    report);
    correctAndMove(dt);
    report.putBack = this->guard_.keepOut(scene_.water.x);
    return report;
}

/// k_i = eps/C_r and 1/k_i, 1 in clear water.
template <int Dim>
void PaperStep<Dim>::coefficients()
{
    const Index n = fields_.points.water;
    mobility_.assign(n, 1), inverseMobility_.assign(n, 1);
    if (!scene_.porous) return;
    parallelFor(n, [&](Index i) {
        mobility_[i] = fields_.soil.mobility[i];
        inverseMobility_[i] = 1 / mobility_[i];
    });
}

template <int Dim>
void PaperStep<Dim>::predict(Real dt)
{
    const auto timer = timers_.scope("predictor");
    const Points<Dim>& points = fields_.points;
    const auto& soil = fields_.soil;
    const Scheme<Dim>& scheme = scene_.scheme;
    std::vector<Vec<Dim>> v(points.fluid);
    parallelFor(points.water, [&](Index i) { v[i] = soil.porosity[i] * scene_.water.u[i]; });
    points.refresh(v);
    if (drag_ == PaperDrag::explicitly) requireStableDrag<Dim>(scene_, fields_, v, dt);
    const WallCloud<Dim>& walls = scene_.wallCloud;
    fields_.v.resize(points.fluid);
    parallelForDynamic(points.water, [&](Index i) {
        Vec<Dim> laplacian;
        fields_.pairs.forWater(i, [&](const auto& pair) {
            laplacian += (points.volume[pair.j] * pair.F()) * (v[pair.j] - v[i]);
        });
        if (!walls.noSlip.empty())
            fields_.pairs.forWalls(i, [&](const auto& pair) {
                const Index k = pair.j - points.fluid;
                if (walls.noSlip[k])
                    laplacian -= points.volume[pair.j] * pair.F() *
                                 walls.slip(k, pair.x_ij, v[i], soil.porosity[i], scheme.spacing);
            });
        const Real nu =
            scheme.viscosity + (fields_.eddyViscosity.empty() ? 0 : fields_.eddyViscosity[i]);
        const Real r = scene_.porous ? soil.linear[i] + soil.quadratic[i] * norm(v[i]) : 0;
        const Real kdt = mobility_[i] * dt;
        const Vec<Dim> rate = (nu / soil.porosity[i]) * laplacian + scheme.force;
        fields_.v[i] = drag_ == PaperDrag::explicitly ? v[i] + kdt * (rate - r * v[i])
                                                      : (v[i] + kdt * rate) / (1 + kdt * r);
    });
    points.refresh(fields_.v);
}

/// - alpha (eps - <rho>/rho0)/dt as a wanted divergence, against the sum of a full lattice; at the
/// surface, where the sum lacks partners, compression alone.                                   (16)
template <int Dim>
void PaperStep<Dim>::densityTerm(Real dt, StepReport& report)
{
    const Scheme<Dim>& scheme = scene_.scheme;
    const Real alpha = scheme.stabilisation == Stabilisation::constantAlpha ? scheme.alpha
                       : scheme.stabilisation == Stabilisation::relaxedDensity
                           ? dt / scheme.relaxationTime
                           : 0;
    const Index n = fields_.points.water;
    divergence_.resize(n);
    std::vector<Real> error(n, 0);
    parallelForDynamic(n, [&](Index i) {
        const Real eps = fields_.soil.porosity[i];
        // <rho>/(eps rho0) - 1
        const Real surplus = fields_.corrections.filling[i] - this->lattice_.filling;
        const bool inner = fields_.role[i] == SurfaceRole::inner;
        divergence_[i] =
            (inner || surplus > 0 ? alpha / dt * eps * surplus : 0) - solidsDivergence(fields_, i);
        if (inner) error[i] = sqr(surplus);
    });
    report.densityError =
        std::sqrt(orderedSum(n, [&](Index i) { return error[i]; }) / std::max<Index>(1, n));
}

template <int Dim>
void PaperStep<Dim>::correctAndMove(Real dt)
{
    const auto timer = timers_.scope("corrector");
    const Points<Dim>& points = fields_.points;
    Water<Dim>& water = scene_.water;
    parallelForDynamic(points.water, [&](Index i) {
        Vec<Dim> gradient;
        fields_.pairs.forWater(i, [&](const auto& pair) {
            gradient += points.volume[pair.j] * (fields_.p[pair.j] - fields_.p[i]) * pair.gradW();
        });
        const Vec<Dim> v = fields_.v[i] - (dt * mobility_[i]) * gradient;
        water.forceGradient[i] = gradient - scene_.scheme.force;
        water.uOld[i] = water.u[i];
        water.u[i] = v / fields_.soil.porosity[i];
    });
    water.porosity.clear(), water.porosityOld.clear();   // this scheme carries u alone
    parallelFor(points.water, [&](Index i) {
        water.x[i] = scene_.box.wrap(water.x[i] + (Real(0.5) * dt) * (water.u[i] + water.uOld[i]));
    });
}

template class PaperStep<2>;
template class PaperStep<3>;

}  // namespace isph
