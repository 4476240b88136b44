// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/ExplicitDrag.hpp"

#include "core/Error.hpp"
#include "core/Parallel.hpp"

#include <fmt/ranges.h>

#include <cmath>
#include <limits>

namespace isph {

namespace {

/// Zone of the soil particle nearest to x, across periodic faces too.
template <int Dim>
const std::string& zoneAt(const Scene<Dim>& scene, const Vec<Dim>& x)
{
    const Soil<Dim>& soil = scene.soil;
    std::size_t nearest = 0;
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t k = 0; k < soil.size(); ++k) {
        Vec<Dim> r = soil.x[k] - x;
        for (int d = 0; d < Dim; ++d)
            if (scene.box.periodic[d])
                r[d] -= scene.box.length(d) * std::round(r[d] / scene.box.length(d));
        if (normSqr(r) < least) least = normSqr(r), nearest = k;
    }
    return soil.names[static_cast<std::size_t>(soil.zone[nearest])];
}

}  // namespace

Real explicitDragLimit(const SoilZone& zone)
{
    // At the face of the zone, where it resists most at once
    const Real eps = 1 - (1 - zone.porosity) / 2;
    return 2 * zone.model->inertiaCoefficient(eps) / (eps * zone.resistance.linear);
}

template <int Dim>
void requireStableDrag(const Scene<Dim>& scene, const StepFields<Dim>& fields,
                       Span<const Vec<Dim>> v, Real dt)
{
    if (!scene.porous) return;
    const auto& soil = fields.soil;
    const Index n = fields.points.water;
    const auto rate = [&](Index i) {
        return soil.mobility[i] * (soil.linear[i] + soil.quadratic[i] * norm(v[i]));
    };
    const Real most = orderedMax(n, 0, rate);
    if (most * dt <= 2) return;
    Index i = 0;
    while (rate(i) < most) ++i;
    throw FatalError(
        fmt::format("The explicit drag of projection paper is unstable: the step is {:.4g} s, but "
                    "in the zone {} it is stable\n"
                    "only below 2/(k (a + b|v|)) = {:.4g} s, with k = eps/C_r = {:.4g}, a = {:.4g} "
                    "1/s, b|v| = {:.4g} 1/s at ({:.6g}).\n"
                    "Take smaller steps (deltaT and maxDeltaT in system/controlDict), or choose in "
                    "system/isphSchemes\n"
                    "paperCoeffs {{ drag semiImplicit; }} or projection dragImplicit.",
                    dt, zoneAt(scene, scene.water.x[i]), 2 / most, soil.mobility[i], soil.linear[i],
                    soil.quadratic[i] * norm(v[i]), fmt::join(scene.water.x[i].c, " ")));
}

template void requireStableDrag(const Scene<2>&, const StepFields<2>&, Span<const Vec<2>>, Real);
template void requireStableDrag(const Scene<3>&, const StepFields<3>&, Span<const Vec<3>>, Real);

}  // namespace isph
