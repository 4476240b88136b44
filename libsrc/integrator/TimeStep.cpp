// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/TimeStep.hpp"

#include "core/Error.hpp"
#include "core/Parallel.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

namespace isph {

namespace {
constexpr Real kForceLimit = 0.25, kViscousLimit = 0.125;   // [Morris et al. 1997]
constexpr Real kCollapse = 1e-5;                            // of the other limits: no flow is that fast
constexpr Real kGrowth = 1.2;                               // BDF2 is zero-stable below 2.4
}  // namespace

template <int Dim>
CourantNumber courantRate(const Scheme<Dim>& scheme, const Water<Dim>& water, Span<const Real> porosity)
{
    const auto rate = [&](Index i) {
        const Real root = Dim == 2 ? std::sqrt(porosity[i]) : std::cbrt(porosity[i]);
        return norm(water.u[i]) * root / scheme.spacing;
    };
    const std::size_t n = water.size();
    return {orderedSum(n, rate) / static_cast<Real>(std::max<std::size_t>(n, 1)), orderedMax(n, 0, rate)};
}

template <int Dim>
Real stepSize(const Scheme<Dim>& scheme, Real maxCo, Real maxDeltaT, Real first, Real dtOld, Real courant,
              Span<const Real> eddyViscosity)
{
    Real dt = std::min(maxDeltaT, dtOld > 0 ? kGrowth * dtOld : first);
    const Real f = norm(scheme.force);
    if (f > 0) dt = std::min(dt, kForceLimit * std::sqrt(scheme.h0 / f));
    const Real nu = scheme.viscosity
                  + orderedMax(eddyViscosity.size(), 0, [&](Index i) { return eddyViscosity[i]; });
    if (nu > 0) dt = std::min(dt, kViscousLimit * sqr(scheme.h0) / nu);
    if (courant > 0 && maxCo / courant < kCollapse * dt)
        throw FatalError(fmt::format(
            "The step collapsed: the water moves {:g} spacings per second, so that maxCo {:g} asks for {:g} s.\n"
            "The flow has become unstable; the last time folder holds the last good state.",
            courant, maxCo, maxCo / courant));
    return courant > 0 ? std::min(dt, maxCo / courant) : dt;
}

template <int Dim>
void requireFinite(const Water<Dim>& water, Real time, Real dt)
{
    const std::size_t n = water.size();
    const auto bad = [&](Index i) {
        return !(std::isfinite(normSqr(water.x[i])) && std::isfinite(normSqr(water.u[i])) && std::isfinite(water.p[i]));
    };
    if (orderedMax(n, 0, [&](Index i) { return bad(i) ? 1.0 : 0.0; }) == 0) return;
    for (Index i = 0; i < static_cast<Index>(n); ++i)
        if (bad(i)) {
            std::string place;
            for (int d = 0; d < Dim; ++d) place += fmt::format("{}{:g}", d ? " " : "", water.x[i][d]);
            throw FatalError(fmt::format(
                "The state is no longer finite at time {:g} s (step {:g} s): water particle {} at ({}).\n"
                "The last time folder holds the last good state. Smaller steps (maxCo, maxDeltaT) may help.",
                time, dt, water.id[i], place));
        }
}

#define ISPH_INSTANTIATE(Dim)                                                                           \
    template CourantNumber courantRate(const Scheme<Dim>&, const Water<Dim>&, Span<const Real>);        \
    template Real stepSize(const Scheme<Dim>&, Real, Real, Real, Real, Real, Span<const Real>);         \
    template void requireFinite(const Water<Dim>&, Real, Real);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
