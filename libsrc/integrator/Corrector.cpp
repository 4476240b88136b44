// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Corrector.hpp"

#include "operators/Gradient.hpp"

#include <algorithm>
#include <array>

namespace isph {

namespace {
// |T_i| h_i of a second row, and of a particle between it and the first.
constexpr Real kEven = 0.25, kUneven = 0.4;
constexpr Real kMostFitted = 0.25;  // spacings of water: what weighs more is an impact's
constexpr Real kLeastRest = 0.2;  // of the partners' weight: if less is left they fit any gradient
// Of what a particle far from faces conducts: half at a flat face.
constexpr Real kLeastConducted = 0.25;

/// What a pair asks of its partner.
template <int Dim>
struct Partner {
    /// w of the predictor, p over rho
    enum Place : int {
        x = 0,
        w = Dim,
        volume = 2 * Dim,
        p,
        size = 8
    };
};

/// Sums over the water partners of a particle, those of every lane apart.
template <int Dim, class Medium>
struct HeadSum {
    using P = Partner<Dim>;
    const Medium& medium;
    Index i;
    const Real* own;
    Vec<Dim> force;
    /// Of p/rho - g.x, and of the velocity change (soil alone)
    std::array<Lanes, Dim> gradient{}, flux{};
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
    /// What drag takes from the predictor on the way to a partner, (s_i - s_ij)/2 (w_i + w_j).x_ij,
    /// through a face where there is one.
    Lanes held(const Index* j, const std::array<Lanes, Dim>& x,
               const std::array<Lanes, P::size>& of) const
    {
        Lanes held{};
        for (int l = 0; l < kLanes; ++l) {
            const Vec<Dim> x_ij = lane(x, l);
            Vec<Dim> w;
            for (int d = 0; d < Dim; ++d) w[d] = own[P::w + d] + of[P::w + d][l];
            held[l] = Real(0.5) * (medium.damping(i) - medium.damping(i, j[l], x_ij)) *
                      medium.damped(i, j[l], w, x_ij);
        }
        return held;
    }
};

/// The part of the flux along a face: the pairs through it conduct like the two media in series,
/// but side by side with its own a particle feels the whole gradient.               [theory (3.11)]
template <int Dim>
Vec<Dim> wholeAlong(const WaterInSoil<Dim>& medium, Index i, const Mat<Dim>& conducted,
                    const Mat<Dim>& seen, const Vec<Dim>& flux)
{
    if (!medium.atFace(i)) return flux;
    const Vec<Dim> n = medium.normal(i, i);
    const auto along = [&](const Mat<Dim>& M) { return trace(M) - dot(n, M * n); };
    const Real share = along(conducted) / (medium.beta(i) * along(seen));
    const Vec<Dim> through = dot(flux, n) * n;
    return through + (1 / std::max(kLeastConducted, share)) * (flux - through);
}

/// How much of its own pressure a particle near the surface leaves out. Not beside soil, where the
/// pressure bends at faces.                                                         [theory (3.14)]
template <int Dim, class Medium>
Real leftOut(const StepFields<Dim>& fields, const Medium& medium, Index i)
{
    if (fields.role[i] != SurfaceRole::near) return 0;
    if constexpr (Medium::hasSoil)
        if (medium.inSoil(i) || medium.atFace(i)) return 0;
    const Real lopsided = norm(fields.corrections.lopsided[i]) * fields.points.h[i];
    return std::clamp((lopsided - kEven) / (kUneven - kEven), Real(0), Real(1));
}

/// p/rho at a particle of the linear field that fits its partners, mean and gradient.
///                                                                                  [theory (3.14)]
template <int Dim>
Real fittedPressure(const StepFields<Dim>& fields, const Records<Partner<Dim>::size>& partners,
                    const Vec<Dim>& g, Index i)
{
    using P = Partner<Dim>;
    const Real p_i = partners[i][P::p];
    Real weight = 0, head = 0;
    Vec<Dim> way, slope, missing;   // to the partners; of the head; sum V gradW
    fields.pairs.forWater(i, [&](const auto& pair) {
        const Real* of = partners[pair.j];
        const Real higher = of[P::p] - p_i + dot(g, pair.x_ij), VW = of[P::volume] * pair.W;
        const Vec<Dim> VgradW = of[P::volume] * pair.gradW();
        weight += VW, head += VW * higher, way -= VW * pair.x_ij;
        slope += higher * VgradW, missing += VgradW;
    });
    const Mat<Dim> L = fields.corrections.Lwater(i);
    const Real rest = weight - dot(L * missing, way);
    return rest < kLeastRest * weight ? p_i : p_i + (head - dot(L * slope, way)) / rest;
}
}  // namespace

template <int Dim, class Medium>
void correct(const Medium& medium, const Scheme<Dim>& scheme, StepFields<Dim>& fields,
             Water<Dim>& water)
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
        const Real* own = partners[i];
        std::array<Real, P::size> fitted;
        if (const Real share = leftOut(fields, medium, i); share > 0) {
            const Real most = kMostFitted * scheme.spacing * std::max(scheme.strongest, norm(g));
            std::copy_n(own, P::size, fitted.begin());
            fitted[P::p] += share * std::clamp(fittedPressure(fields, partners, g, i) - own[P::p],
                                               -most, most);
            own = fitted.data();
        }
        HeadSum<Dim, Medium> sum{medium, i, own, g};
        fields.pairs.forWaterLanes(
            i, [&](const PairLanes& pairs) { sum.add(pairs, partners.gather(pairs.j)); });
        const Vec<Dim> gradient = sumOf(sum.gradient);
        const Real s_i = medium.damping(i);
        const Vec<Dim> w_i = fields.v[i];
        const Mat<Dim> L = fields.corrections.Lwater(i);
        Vec<Dim> flux = medium.beta(i) * (L * gradient);
        if constexpr (Medium::hasSoil)
            flux = wholeAlong(medium, i, L * sum.conducted.total(),
                              Mat<Dim>(fields.corrections.seen(i)), L * sumOf(sum.flux));
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
