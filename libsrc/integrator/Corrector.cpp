// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Corrector.hpp"

namespace isph {

template <int Dim, class Medium>
void correct(const Medium& medium, const Scheme<Dim>& scheme, StepFields<Dim>& fields, Water<Dim>& water)
{
    const Points<Dim>& points = fields.points;
    const Vec<Dim> g = scheme.force;
    parallelForDynamic(points.water, [&](Index i) {
        const Real s_i = medium.damping(i), p_i = fields.p[i];
        const Vec<Dim> w_i = fields.v[i];
        Vec<Dim> gradient, flux;   // of p/rho - g.x, and of the velocity change; L_i is applied to both
        fields.pairs.forWater(i, [&](const auto& pair) {
            const Index j = pair.j;
            const Vec<Dim> VgradW = points.volume[j] * pair.gradW();
            const Real head = fields.p[j] - p_i + dot(g, pair.x_ij);
            gradient += head * VgradW;
            Real change = medium.beta(i, j) * head;
            if constexpr (Medium::hasSoil) {
                const Vec<Dim> n = medium.normal(i, j);
                change -= Real(0.5) * (s_i - medium.damping(i, j)) * dot(w_i + fields.v[j], n) * dot(n, pair.x_ij);
            }
            flux += change * VgradW;
        });
        const Mat<Dim>& L = fields.corrections.Lwater[i];
        const Vec<Dim> unseen = g - fields.corrections.seen[i] * g;
        const Vec<Dim> v = s_i * w_i - L * flux + medium.beta(i) * unseen;
        water.forceGradient[i] = L * gradient - unseen;
        water.uOld[i] = water.u[i];
        water.u[i] = v / medium.porosity(i);
    });
}

template void correct(const ClearWater<2>&, const Scheme<2>&, StepFields<2>&, Water<2>&);
template void correct(const ClearWater<3>&, const Scheme<3>&, StepFields<3>&, Water<3>&);
template void correct(const WaterInSoil<2>&, const Scheme<2>&, StepFields<2>&, Water<2>&);
template void correct(const WaterInSoil<3>&, const Scheme<3>&, StepFields<3>&, Water<3>&);

}  // namespace isph
