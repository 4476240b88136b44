// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Predictor.hpp"

#include "operators/Gradient.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kInnerStrength = 8;  // c_r of inner pairs, whose rough part is small, over that of others

/// Lower bound of (lambda_i + lambda_j)/(2 Dim): sprays have little of a support.  [theory (2.8)]
constexpr Real kLeastSupport = 0.7;

template <int Dim>
Real supportFactor(Real lambda_i, Real lambda_j)
{
    return 1 / std::max(kLeastSupport, (lambda_i + lambda_j) / (2 * Dim));
}

/// What pairs ask of a particle, side by side in memory. The gradient needs the first eight numbers.
template <int Dim>
struct Carried {
    enum Place : int {
        x = 0,                 ///< Dim values
        v = Dim,               ///< extrapolated to the new time, Dim values
        volume = 2 * Dim, part, lambda, viscosity,
        stretch,               ///< grad v of inner particles, zero of others: its diagonal,
        shear = stretch + Dim, ///< sums of opposite entries below and above it
        used = shear + Dim * (Dim - 1) / 2, size = (used + kLanes - 1) / kLanes * kLanes
    };
    /// part: 1 near the surface, 2 inner; negative in soil. No dissipation acts across its face.
    static constexpr Real kClear = 1, kInner = 2;
};

/// grad v; where it is zero the dissipation takes the whole velocity difference.           [theory (7.3)]
template <int Dim>
void smoothPart(const StepFields<Dim>& fields, Index i, const Records<Carried<Dim>::size>& carried)
{
    using C = Carried<Dim>;
    Real* own = carried[i];
    std::fill(own + C::stretch, own + C::size, 0);
    if (std::abs(own[C::part]) != C::kInner) return;
    OuterSum<Dim> sum;
    fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
        const auto of = carried.template gather<kLanes>(pairs.j);
        std::array<Lanes, Dim> change, x_ij;
        for (int d = 0; d < Dim; ++d) {
            change[d] = pairs.slope * of[C::volume] * (of[C::v + d] - own[C::v + d]);
            x_ij[d] = own[C::x + d] - of[C::x + d];
        }
        sum.add(change, x_ij);
    });
    const Mat<Dim> gradient = sum.total() * fields.corrections.Lwater(i);
    for (int r = 0, s = 0; r < Dim; ++r) {
        own[C::stretch + r] = gradient[r][r];
        for (int c = 0; c < r; ++c) own[C::shear + s++] = gradient[r][c] + gradient[c][r];
    }
}

/// Numbers of eight partners, and those of the particle itself.
template <int Dim>
struct Partners {
    using C = Carried<Dim>;
    const Real* own;
    std::array<Lanes, C::size> of;

    const Lanes& operator()(int place) const { return of[place]; }
    Lanes sum(int place) const { return own[place] + of[place]; }
    Lanes difference(int place) const { return own[place] - of[place]; }
};

/// (v_ij.e) r without its smooth part between inner particles: never more than it and never of the other sign.
template <int Dim>
Lanes roughPart(const Partners<Dim>& partners, const std::array<Lanes, Dim>& x, const Lanes& approach)
{
    using C = Carried<Dim>;
    Lanes smooth{};
    for (int r = 0, s = 0; r < Dim; ++r) {
        smooth += Real(0.5) * partners.sum(C::stretch + r) * x[r] * x[r];
        for (int c = 0; c < r; ++c) smooth += Real(0.5) * partners.sum(C::shear + s++) * x[r] * x[c];
    }
    const Lanes rough = approach - smooth;
    const Lanes less = rough * rough < approach * approach ? rough : approach;
    return rough * approach > 0 ? less : Lanes{};
}

/// Friction and dissipation of a row, those of every lane apart.
template <int Dim>
struct RateSum {
    using C = Carried<Dim>;
    Real dissipation, most, shortest2;   ///< c_r; largest share of a velocity difference; of |x_ij|^2
    std::array<Lanes, Dim> rate{};

    void add(const Partners<Dim>& partners, const Lanes& slope)
    {
        std::array<Lanes, Dim> v_ij, x;
        Lanes approach{}, r2{};
        for (int d = 0; d < Dim; ++d) {
            v_ij[d] = partners.difference(C::v + d);
            x[d] = partners.difference(C::x + d);
            approach += v_ij[d] * x[d];
            r2 += x[d] * x[d];
        }
        const Lanes VF = -2 * partners(C::volume) * slope;
        const Lanes friction = VF * frictionOf(partners);
        const Lanes pull = pullOf(partners, x, VF, approach) / (r2 > shortest2 ? r2 : allLanes(shortest2));
        for (int d = 0; d < Dim; ++d) rate[d] -= friction * v_ij[d] + pull * x[d];
    }

private:
    /// Harmonic mean of the viscosities over the share of a full support.
    static Lanes frictionOf(const Partners<Dim>& partners)
    {
        const Lanes both = partners.sum(C::viscosity), support = partners.sum(C::lambda) * (Real(0.5) / Dim);
        const Lanes product = 2 * partners.own[C::viscosity] * partners(C::viscosity);
        const Lanes weight = both * (support > kLeastSupport ? support : allLanes(kLeastSupport));
        return both > 0 ? product / weight : Lanes{};
    }
    /// 2 V F c_r |a| a, a the approach or its rough part.
    Lanes pullOf(const Partners<Dim>& partners, const std::array<Lanes, Dim>& x, const Lanes& VF,
                 const Lanes& approach) const
    {
        if (dissipation == 0) return Lanes{};
        const Real own = std::abs(partners.own[C::part]);
        const Lanes part = partners(C::part) * (partners.own[C::part] < 0 ? Real(-1) : Real(1));
        Lanes a = approach, strength = allLanes(dissipation);
        if (own == C::kInner) {
            a = part == C::kInner ? roughPart<Dim>(partners, x, approach) : approach;
            strength = part == C::kInner ? strength * kInnerStrength : strength;
        }
        const Lanes speed = a < 0 ? -a : a;
        const Lanes pull = 2 * VF * strength * speed;
        return part < C::kClear ? Lanes{} : (pull < most ? pull : allLanes(most)) * a;
    }
};

/// Points of the lattice within 2 h. A pair may take away this share of its velocity difference in a
/// step and no more: the dissipation is explicit and must not overshoot where sprays meet.
template <int Dim>
Real neighboursOfLattice(const Scheme<Dim>& scheme)
{
    const Real q = 2 * scheme.h0 / scheme.spacing, pi = 3.141592653589793;
    return Dim == 2 ? pi * sqr(q) : 4 * pi / 3 * cube(q);
}
}  // namespace

template <int Dim, class Medium>
void predict(const Water<Dim>& water, const WallCloud<Dim>& walls, const Medium& medium,
             const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields)
{
    const Points<Dim>& points = fields.points;
    // Slip walls take no part in the friction, nor then in its support.
    const auto& lambda = walls.noSlip.empty() ? fields.corrections.lambdaWater : fields.corrections.lambda;
    const bool turbulent = !fields.eddyViscosity.empty();
    using C = Carried<Dim>;
    const auto carried = fields.pairs.template records<C::size>();
    parallelFor(points.water, [&](Index i) {
        Real* to = carried[i];
        const Real eps = medium.porosity(i);
        for (int d = 0; d < Dim; ++d)
            to[C::v + d] = eps * ((1 + weights.ratio) * water.u[i][d] - weights.ratio * water.uOld[i][d]);
        const bool inner = fields.role[i] == SurfaceRole::inner;
        to[C::part] = (inner ? C::kInner : C::kClear) * (medium.inSoil(i) ? -1 : 1);
        to[C::volume] = points.volume[i];
        to[C::lambda] = lambda[i];
        to[C::viscosity] = (scheme.viscosity + (turbulent ? fields.eddyViscosity[i] : 0)) / eps;
    });
    const auto copyToImages = [&](int from, int to) {
        parallelFor(points.images(), [&](Index k) {
            const Real* owner = carried[points.owner[points.water + k]];
            std::copy(owner + from, owner + to, carried[points.water + k] + from);
        });
    };
    copyToImages(0, C::stretch);
    parallelFor(points.fluid, [&](Index i) {
        for (int d = 0; d < Dim; ++d) carried[i][C::x + d] = points.x[i][d];
    });
    if (scheme.dissipation > 0) {
        parallelForDynamic(points.water, [&](Index i) { smoothPart(fields, i, carried); });
        copyToImages(C::stretch, C::size);
    }
    const Real most = 1 / (neighboursOfLattice(scheme) * weights.dtPrime());
    fields.v.resize(points.fluid);
    parallelForDynamic(points.water, [&](Index i) {
        RateSum<Dim> sum{scheme.dissipation, most, 1e-12 * sqr(scheme.spacing)};
        fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
            sum.add({carried[i], carried.gather(pairs.j)}, pairs.slope);
        });
        Vec<Dim> rate = sumOf(sum.rate), v_i;
        for (int d = 0; d < Dim; ++d) v_i[d] = carried[i][C::v + d];
        const Real nu_i = carried[i][C::viscosity];
        if (!walls.noSlip.empty())
            fields.pairs.forWalls(i, [&](const auto& pair) {
                const Index k = pair.j - points.fluid;
                if (walls.noSlip[k])
                    rate -= points.volume[pair.j] * pair.F() * nu_i * supportFactor<Dim>(lambda[i], lambda[i])
                          * walls.slip(k, pair.x_ij, v_i, medium.porosity(i), scheme.spacing);
            });
        fields.v[i] = medium.porosity(i) * (weights.now() * water.u[i] + weights.before() * water.uOld[i])
                    + medium.mobility(i) * weights.dtPrime() * rate;
    });
    points.refresh(fields.v);
}

template void predict(const Water<2>&, const WallCloud<2>&, const ClearWater<2>&, const Scheme<2>&, const StepWeights&,
                      StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const ClearWater<3>&, const Scheme<3>&, const StepWeights&,
                      StepFields<3>&);
template void predict(const Water<2>&, const WallCloud<2>&, const WaterInSoil<2>&, const Scheme<2>&, const StepWeights&,
                      StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const WaterInSoil<3>&, const Scheme<3>&, const StepWeights&,
                      StepFields<3>&);

}  // namespace isph
