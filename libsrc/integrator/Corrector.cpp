// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Corrector.hpp"

#include "operators/Gradient.hpp"

namespace isph {

namespace {
constexpr Real kLeastConducted = 0.25;   // of what a particle far from faces conducts: half at a flat face

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
    OuterSum<Dim> conducted{};                   ///< sum V beta_ij gradW x_ij (soil alone)

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
            Lanes beta{};
            for (int l = 0; l < kLanes; ++l) beta[l] = medium.beta(i, pairs.j[l], lane(x, l));
            if (medium.carries(i))
                for (int l = 0; l < kLanes; ++l) head[l] += medium.swiftness(i, pairs.j[l]);
            const Lanes change = beta * head - held(pairs.j, x, of);
            std::array<Lanes, Dim> conducting;
            for (int d = 0; d < Dim; ++d) {
                flux[d] += VSlope * change * x[d];
                conducting[d] = -VSlope * beta * x[d];
            }
            conducted.add(conducting, x);
        }
    }

private:
    /// What drag takes from the predictor on the way to a partner, (s_i - s_ij)/2 (w_i + w_j).x_ij, through a face
    /// where there is one.
    Lanes held(const Index* j, const std::array<Lanes, Dim>& x, const std::array<Lanes, P::size>& of) const
    {
        Lanes held{};
        for (int l = 0; l < kLanes; ++l) {
            const Vec<Dim> x_ij = lane(x, l);
            Vec<Dim> w;
            for (int d = 0; d < Dim; ++d) w[d] = own[P::w + d] + of[P::w + d][l];
            held[l] = Real(0.5) * (medium.damping(i) - medium.damping(i, j[l], x_ij)) * medium.damped(i, j[l], w, x_ij);
        }
        return held;
    }
};

/// The part of the flux along a face: the pairs through it conduct like the two media in series, but side by side
/// with its own a particle feels the whole gradient.                                              [theory (3.11)]
template <int Dim>
Vec<Dim> wholeAlong(const WaterInSoil<Dim>& medium, Index i, const Mat<Dim>& conducted, const Mat<Dim>& seen,
                    const Vec<Dim>& flux)
{
    if (!medium.atFace(i)) return flux;
    const Vec<Dim> n = medium.normal(i, i);
    const auto along = [&](const Mat<Dim>& M) { return trace(M) - dot(n, M * n); };
    const Real share = along(conducted) / (medium.beta(i) * along(seen));
    const Vec<Dim> through = dot(flux, n) * n;
    return through + (1 / std::max(kLeastConducted, share)) * (flux - through);
}

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
        const Real s_i = medium.damping(i);
        const Vec<Dim> w_i = fields.v[i];
        const Mat<Dim> L = fields.corrections.Lwater(i);
        Vec<Dim> flux = medium.beta(i) * (L * gradient);
        if constexpr (Medium::hasSoil) flux = wholeAlong(medium, i, L * sum.conducted.total(), Mat<Dim>(fields.corrections.seen(i)),
                                                         L * sumOf(sum.flux));
        const Vec<Dim> unseen = g - fields.corrections.seen(i) * g;
        const Vec<Dim> v = s_i * w_i - flux + medium.beta(i) * unseen;
        water.forceGradient[i] = (1 / medium.beta(i)) * flux - unseen;
        water.uOld[i] = water.u[i];
        water.u[i] = v / medium.porosity(i);
    });
}

template void correct(const ClearWater<2>&, const Scheme<2>&, StepFields<2>&, Water<2>&);
template void correct(const ClearWater<3>&, const Scheme<3>&, StepFields<3>&, Water<3>&);
template void correct(const WaterInSoil<2>&, const Scheme<2>&, StepFields<2>&, Water<2>&);
template void correct(const WaterInSoil<3>&, const Scheme<3>&, StepFields<3>&, Water<3>&);

}  // namespace isph
