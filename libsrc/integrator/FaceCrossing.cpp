// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/FaceCrossing.hpp"

namespace isph {

template <int Dim>
void crossFaces(const PorousField<Dim>& field, const PeriodicBox<Dim>& box, Real spacing,
                const StepWeights& weights, const StepFields<Dim>& fields, Water<Dim>& water)
{
    const PorousState<Dim>& soil = fields.soil;
    parallelForDynamic(fields.points.water, [&](Index i) {
        if (fields.role[i] != SurfaceRole::inner) return;
        const Vec<Dim> &u = water.u[i], &uOld = water.uOld[i];
        const Vec<Dim> moved = weights.dt * (u + Real(0.5) * weights.ratio * (u - uOld));   // (3.2)
        // The depth is that of a flat face (4.15), twice as much is enough for any.
        if (soil.depth[i] * spacing > 2 * norm(moved)) return;
        const Index before = field.zoneAt(box.wrap(water.x[i] - moved));
        if (before == soil.zone[i]) return;
        const Vec<Dim> v = water.porosity[i] * u, n = unit(soil.normal[i]);
        const Resistance law =
            before == kClearWater ? Resistance{} : field.zones()[before].resistance;
        const Real r = law.linear + law.quadratic * norm(v);
        water.forceGradient[i] += ((r - fields.resistance[i]) * dot(v, n)) * n;
    });
}

template void crossFaces(const PorousField<2>&, const PeriodicBox<2>&, Real, const StepWeights&,
                         const StepFields<2>&, Water<2>&);
template void crossFaces(const PorousField<3>&, const PeriodicBox<3>&, Real, const StepWeights&,
                         const StepFields<3>&, Water<3>&);

}  // namespace isph
