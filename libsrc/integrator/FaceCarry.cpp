// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/FaceCarry.hpp"

namespace isph {

template <int Dim>
void carryThroughFaces(const Water<Dim>& water, const StepWeights& weights, StepFields<Dim>& fields)
{
    const Points<Dim>& points = fields.points;
    const PorousState<Dim>& soil = fields.soil;
    FaceFields<Dim>& face = fields.face;
    fields.v.resize(points.fluid), face.v.resize(points.fluid),
        face.carriesDarcy.resize(points.fluid);
    parallelFor(points.water, [&](Index i) {
        const bool rigid = soil.solidsFlux.empty() || normSqr(soil.solidsFlux[i]) == 0;
        face.carriesDarcy[i] = rigid && fields.role[i] != SurfaceRole::surface;
        const Vec<Dim> n = face.carriesDarcy[i] ? unit(soil.normal[i]) : Vec<Dim>{};
        const auto carried = [&](Real now, Real before) {
            const Vec<Dim> u = now * water.u[i], uOld = before * water.uOld[i];
            const Vec<Dim> change = (water.porosity[i] - soil.porosity[i]) * u
                                  + (water.porosityOld[i] - soil.porosity[i]) * uOld;
            return soil.porosity[i] * (u + uOld) + dot(change, n) * n;
        };
        fields.v[i] = carried(weights.now(), weights.before());
        face.v[i] = carried(1 + weights.ratio, -weights.ratio);
    });
    points.refresh(face.v), points.refresh(face.carriesDarcy);
}

template void carryThroughFaces(const Water<2>&, const StepWeights&, StepFields<2>&);
template void carryThroughFaces(const Water<3>&, const StepWeights&, StepFields<3>&);

}  // namespace isph
