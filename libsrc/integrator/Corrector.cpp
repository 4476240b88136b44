// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Corrector.hpp"

#include "operators/Gradient.hpp"

namespace isph {

namespace {
/// What a pair asks of its partner.
template <int Dim>
struct Partner {
    enum Place : int { x = 0, w = Dim, volume = 2 * Dim, p, size = 8 };   ///< w of the predictor, p over rho
};

/// Sums over the water partners of a particle, those of every lane apart.
template <int Dim, class Medium>
struct HeadSum {
    using P = Partner<Dim>;
    const Medium& medium;
    Index i;
    const Real* own;
    Vec<Dim> force;
    std::array<Lanes, Dim> gradient{}, flux{};   ///< of p/rho - g.x, and of the velocity change (soil alone)

    void add(const PairLanes& pairs, const std::array<Lanes, P::size>& of)
    {
        std::array<Lanes, Dim> x;
        Lanes head = of[P::p] - own[P::p];
        for (int d = 0; d < Dim; ++d) {
            x[d] = own[P::x + d] - of[P::x + d];
            head += force[d] * x[d];
        }
        const Lanes VSlope = of[P::volume] * pairs.slope;
        for (int d = 0; d < Dim; ++d) gradient[d] += VSlope * head * x[d];
        if constexpr (Medium::hasSoil) {
            const Lanes change = changes(pairs.j, head, x, of);
            for (int d = 0; d < Dim; ++d) flux[d] += VSlope * change * x[d];
        }
    }

private:
    Lanes changes(const Index* j, const Lanes& head, const std::array<Lanes, Dim>& x,
                  const std::array<Lanes, P::size>& of) const
    {
        Lanes change{};
        const Real s_i = medium.damping(i);
        for (int l = 0; l < kLanes; ++l) {
            const Vec<Dim> n = medium.normal(i, j[l]);
            Real across = 0, along = 0;
            for (int d = 0; d < Dim; ++d) {
                across += (own[P::w + d] + of[P::w + d][l]) * n[d];
                along += n[d] * x[d][l];
            }
            change[l] = medium.beta(i, j[l]) * head[l]
                      - Real(0.5) * (s_i - medium.damping(i, j[l])) * across * along;
        }
        return change;
    }
};

}  // namespace

template <int Dim, class Medium>
void correct(const Medium& medium, const Scheme<Dim>& scheme, StepFields<Dim>& fields, Water<Dim>& water)
{
    using P = Partner<Dim>;
    const Points<Dim>& points = fields.points;
    const Vec<Dim> g = scheme.force;
    const auto partners = fields.pairs.template records<P::size>();
    parallelFor(points.fluid, [&](Index i) {
        Real* to = partners[i];
        for (int d = 0; d < Dim; ++d) to[P::x + d] = points.x[i][d], to[P::w + d] = fields.v[i][d];
        to[P::volume] = points.volume[i], to[P::p] = fields.p[i];
    });
    parallelForDynamic(points.water, [&](Index i) {
        HeadSum<Dim, Medium> sum{medium, i, partners[i], g};
        fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) { sum.add(pairs, partners.gather(pairs.j)); });
        const Vec<Dim> gradient = sumOf(sum.gradient);
        const Vec<Dim> flux = Medium::hasSoil ? sumOf(sum.flux) : medium.beta(i) * gradient;
        const Real s_i = medium.damping(i);
        const Vec<Dim> w_i = fields.v[i];
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
