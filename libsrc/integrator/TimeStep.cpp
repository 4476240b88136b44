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
constexpr Real kCollapse = 1e-5;  // of the calm step: no flow is that fast
constexpr Real kGrowth = 1.2;                               // BDF2 is zero-stable below 2.4
constexpr Real kFarthest = 1;        // spacings that water may move in a step whose size is given
// H0^2/nu: BDF2 with extrapolated friction, 4/(3 nu max eigenvalue)
constexpr Real kDiffusion = 0.14;

template <int Dim>
Real largestViscosity(const Scheme<Dim>& scheme, Span<const Real> eddyViscosity)
{
    return scheme.viscosity +
           orderedMax(eddyViscosity.size(), 0, [&](Index i) { return eddyViscosity[i]; });
}
}  // namespace

template <int Dim>
CourantNumber courantRate(const Scheme<Dim>& scheme, const Water<Dim>& water,
                          Span<const Real> porosity)
{
    const auto rate = [&](Index i) {
        const Real root = Dim == 2 ? std::sqrt(porosity[i]) : std::cbrt(porosity[i]);
        return norm(water.u[i]) * root / scheme.spacing;
    };
    const std::size_t n = water.size();
    return {orderedSum(n, rate) / static_cast<Real>(std::max<std::size_t>(n, 1)),
            orderedMax(n, 0, rate)};
}

template <int Dim>
Real stepSize(const Scheme<Dim>& scheme, Real maxCo, Real maxDeltaT, Real first, Real dtOld,
              Real courant, Span<const Real> eddyViscosity, Real courantAtStart)
{
    Real calm = maxDeltaT;
    const Real f = norm(scheme.force), nu = largestViscosity(scheme, eddyViscosity);
    if (f > 0) calm = std::min(calm, kForceLimit * std::sqrt(scheme.h0 / f));
    if (nu > 0) calm = std::min(calm, kViscousLimit * sqr(scheme.h0) / nu);
    const Real dt = std::min(calm, dtOld > 0 ? kGrowth * dtOld : first);
    if (!(courant > 0)) return dt;
    calm = std::min(calm, first);
    if (courantAtStart > 0) calm = std::min(calm, maxCo / courantAtStart);
    if (maxCo / courant < kCollapse * calm)
        throw FatalError(fmt::format(
            "The step collapsed: the water moves {:g} spacings per second, so that maxCo {:g} asks "
            "for {:g} s.\n"
            "The flow has become unstable; the last time folder holds the last good state.",
            courant, maxCo, maxCo / courant));
    return std::min(dt, maxCo / courant);
}

template <int Dim>
void requireStableStep(const Scheme<Dim>& scheme, Real dt, Real courant,
                       Span<const Real> eddyViscosity)
{
    const auto stop = [&](const std::string& why, Real limit) {
        throw FatalError(fmt::format(
            "deltaT {:g} s is too large: {}.\nThe limit is {:.4g} s here. Take a smaller "
            "deltaT in system/controlDict, or adjustTimeStep yes.",
            dt, why, limit));
    };
    const Real nu = largestViscosity(scheme, eddyViscosity);
    if (courant * dt > kFarthest)
        stop(fmt::format("the fastest water moves {:.4g} spacings in a step, Courant number {:g} "
                         "is the limit",
                         courant * dt, kFarthest),
             kFarthest / courant);
    if (nu * dt > kDiffusion * sqr(scheme.h0))
        stop(fmt::format("friction with nu = {:g} m2/s is stable up to {:g} h0^2/nu", nu,
                         kDiffusion),
             kDiffusion * sqr(scheme.h0) / nu);
}

template <int Dim>
void requireFinite(const Water<Dim>& water, Real time, Real dt)
{
    const std::size_t n = water.size();
    const auto bad = [&](Index i) {
        return !(std::isfinite(normSqr(water.x[i])) && std::isfinite(normSqr(water.u[i])) &&
                 std::isfinite(water.p[i]));
    };
    if (orderedMax(n, 0, [&](Index i) { return bad(i) ? 1.0 : 0.0; }) == 0) return;
    for (Index i = 0; i < static_cast<Index>(n); ++i)
        if (bad(i)) {
            std::string place;
            for (int d = 0; d < Dim; ++d)
                place += fmt::format("{}{:g}", d ? " " : "", water.x[i][d]);
            throw FatalError(
                fmt::format("The state is no longer finite at time {:g} s (step {:g} s): water "
                            "particle {} at ({}).\n"
                            "The last time folder holds the last good state. Smaller steps (maxCo, "
                            "maxDeltaT) may help.",
                            time, dt, water.id[i], place));
        }
}

#define ISPH_INSTANTIATE(Dim)                                                                    \
    template CourantNumber courantRate(const Scheme<Dim>&, const Water<Dim>&, Span<const Real>); \
    template Real stepSize(const Scheme<Dim>&, Real, Real, Real, Real, Real, Span<const Real>,   \
                           Real);                                                                \
    template void requireStableStep(const Scheme<Dim>&, Real, Real, Span<const Real>);           \
    template void requireFinite(const Water<Dim>&, Real, Real);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
