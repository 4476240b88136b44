// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Shifting.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

template <int Dim>
Real internalSpeed(const std::vector<Vec<Dim>>& u)
{
    const std::size_t n = u.size();
    const Vec<Dim> mean = orderedSum(n, [&](Index i) { return u[i]; }) / std::max<Real>(1, static_cast<Real>(n));
    return std::sqrt(orderedMax(n, 0, [&](Index i) { return normSqr(u[i] - mean); }));
}

namespace {
constexpr Real kTensile = 0.2;             // [Monaghan 2000], power 4
constexpr Real kLeastSupport = 0.4;        // lambda/Dim below which nothing is shifted
constexpr Real kSoilShare = 0.05;
constexpr Real kEdge = 1e-12;              // of W(s_i): rounding decides about pairs at the edge of the support
constexpr Real kSurfaceCollision = 0.95;   // in local spacings: between particles of the surface

/// grad u, row d = grad of component d, from water partners with their correction.
template <int Dim>
Mat<Dim> gradient(const StepFields<Dim>& fields, const std::vector<Vec<Dim>>& u, Index i)
{
    Mat<Dim> sum;
    fields.pairs.forWater(i, [&](const auto& pair) {
        sum += outer(fields.points.volume[pair.j] * (u[pair.j] - u[i]), pair.gradW());
    });
    return sum * fields.corrections.Lwater[i];   // L is symmetric
}
}  // namespace

template <int Dim>
Real shift(const Kernel& kernel, const Scheme<Dim>& scheme, Real dt, const StepFields<Dim>& fields,
           Water<Dim>& water)
{
    const Points<Dim>& points = fields.points;
    const Index n = points.water;
    const Real qLattice = scheme.spacing / scheme.h0;
    Real w = 0, slope = 0;
    kernel.evaluate(Span<const Real>(&qLattice, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
    const Real wLattice = w * kernel.normalisation(Dim);   // W(s_i) h_i^D
    std::vector<Vec<Dim>> u(water.u), uOld(water.uOld), dx(n), change(n), changeOld(n);
    // Water beside soil sees the Darcy velocity, which is continuous across the face; pores are swifter.
    const auto& porosity = fields.soil.porosity;
    parallelFor(n, [&](Index i) { u[i] *= porosity[i], uOld[i] *= porosity[i]; });
    u.resize(points.fluid), uOld.resize(points.fluid);
    points.refresh(u), points.refresh(uOld);
    std::vector<Real> divergence(n, 0);
    parallelForDynamic(n, [&](Index i) {
        const Real lambda = fields.corrections.lambda[i];
        const Mat<Dim> gradU = gradient(fields, u, i);
        if (fields.role[i] == SurfaceRole::inner) divergence[i] = sqr(dt * trace(gradU));
        const bool inSoil = !fields.soil.share.empty() && fields.soil.share[i] > kSoilShare;
        if (scheme.shifting == 0 || lambda < kLeastSupport * Dim || inSoil) return;
        const Real h = points.h[i], WLattice = wLattice / (Dim == 2 ? sqr(h) : cube(h));
        Vec<Dim> concentration, normal;
        Real U2 = 0, wall = 0;
        fields.pairs.forAll(i, [&](const auto& pair) {
            const Real V = points.volume[pair.j];
            concentration += (V * (1 + kTensile * sqr(sqr(pair.W / WLattice)))) * pair.gradW();
            if (pair.j < points.fluid) {
                normal += (V * (fields.corrections.lambda[pair.j] - lambda)) * pair.gradW();
                if (pair.W > kEdge * WLattice) U2 = std::max(U2, normSqr(u[i] - u[pair.j]));
            } else {
                wall += V;
            }
        });
        // Where a surface meets a wall its tangent is not known; water would be pumped up the wall.
        if (wall > 0 && fields.role[i] == SurfaceRole::surface) return;
        Vec<Dim> step = (-scheme.shifting * h * dt * std::sqrt(U2)) * concentration;
        if (fields.role[i] != SurfaceRole::inner) {
            const Vec<Dim> e = unit(normal);
            step -= dot(step, e) * e;
        }
        const Real most = scheme.largestShift * scheme.spacing * h / scheme.h0, length = norm(step);
        if (length > most) step *= most / length;
        dx[i] = step;
        change[i] = (1 / porosity[i]) * (gradU * step);
        changeOld[i] = (1 / porosity[i]) * (gradient(fields, uOld, i) * step);
    });
    parallelFor(n, [&](Index i) {
        water.x[i] += dx[i];
        water.u[i] += change[i];
        water.uOld[i] += changeOld[i];
    });
    return std::sqrt(orderedSum(n, [&](Index i) { return divergence[i]; }) / std::max<Index>(1, n));
}

template <int Dim>
void collide(const Scheme<Dim>& scheme, const StepFields<Dim>& fields, Span<const Vec<Dim>> wallNormal,
             Span<const Real> wallDepth, Water<Dim>& water)
{
    const Points<Dim>& points = fields.points;
    std::vector<Vec<Dim>> u(water.u);
    u.resize(points.fluid);
    points.refresh(u);
    parallelForDynamic(points.water, [&](Index i) {
        const Real spacing = scheme.spacing * points.h[i] / scheme.h0;
        const bool surface = fields.role[i] == SurfaceRole::surface;
        Vec<Dim> change;
        fields.pairs.forWater(i, [&](const auto& pair) {
            const bool both = surface && fields.role[pair.j] == SurfaceRole::surface;
            const Real reach = (both ? kSurfaceCollision : scheme.collisionDistance) * spacing;
            const Real r2 = normSqr(pair.x_ij), approach = dot(u[i] - u[pair.j], pair.x_ij);
            if (r2 < reach * reach && approach < 0 && r2 > 0)
                change -= (Real(0.5) * approach / r2) * pair.x_ij;
        });
        fields.pairs.forWalls(i, [&](const auto& pair) {
            const Index k = pair.j - points.fluid;
            const Real height = dot(pair.x_ij, wallNormal[k]) - wallDepth[k];   // above the wall surface
            const Real beside = normSqr(pair.x_ij - dot(pair.x_ij, wallNormal[k]) * wallNormal[k]);
            const Real approach = dot(u[i] + change, wallNormal[k]);
            const Real wallReach = (scheme.collisionDistance - Real(0.25)) * scheme.spacing;
            if (wallDepth[k] < scheme.spacing && height < wallReach && approach < 0
                && beside < sqr(Real(0.75) * scheme.spacing))
                change -= approach * wallNormal[k];
        });
        water.u[i] += change;
        water.uOld[i] += change;
    });
}

template Real internalSpeed(const std::vector<Vec<2>>&);
template Real internalSpeed(const std::vector<Vec<3>>&);
template Real shift(const Kernel&, const Scheme<2>&, Real, const StepFields<2>&, Water<2>&);
template Real shift(const Kernel&, const Scheme<3>&, Real, const StepFields<3>&, Water<3>&);
template void collide(const Scheme<2>&, const StepFields<2>&, Span<const Vec<2>>, Span<const Real>, Water<2>&);
template void collide(const Scheme<3>&, const StepFields<3>&, Span<const Vec<3>>, Span<const Real>, Water<3>&);

}  // namespace isph
