// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Predictor.hpp"

#include "boundaries/WallLaw.hpp"
#include "operators/Gradient.hpp"
#include "operators/SupportFactor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace isph {

namespace {
/// c_r of rough parts, which are small, and of whole differences at the surface, over that of the
/// case.
constexpr Real kRoughStrength = 8, kWholeStrength = 0.5;

/// Reynolds numbers |grad v| d0^2/nu of the spacing up to which friction resolves a shear, and from
/// which on it is too weak to end the noise in it.                                   [theory (7.8)]
constexpr Real kResolved = 10, kUnresolved = 20;

/// Share of the rough part of v_ij that makes the Laplacian exact to the fourth order of a full
/// support, for any kernel, and its bound in shares of v_ij: noise must not stiffen the explicit
/// friction.                                                                        [theory (2.13)]
constexpr Real kSharpening = 1.0 / 3, kMostSharpening = 0.1;

/// Share of h0^2 that friction spreads over in a step from which on the packing's anisotropy
/// counts. [theory (2.14)]
constexpr Real kViscous = 5e-4;

/// What pairs ask of a particle, side by side in memory. The gradient needs the first eight,
/// beside soil the zone too.
template <int Dim>
struct Carried {
    enum Place : int {
        x = 0,    ///< Dim values
        v = Dim,  ///< extrapolated to the new time, Dim values
        volume = 2 * Dim,
        part,
        lambda,
        viscosity,
        zone,
        gradient,  ///< grad v where differences have a smooth part, else zero, row by row
        /// 1 if inner and all partners are in the same zone, otherwise 0
        whole = gradient + Dim * Dim,
        shear,       ///< |grad v|
        unresolved,  ///< its share that friction does not resolve
        used,
        size = (used + kLanes - 1) / kLanes * kLanes
    };
    /// part: 1 near the surface, 1.5 where the smooth part is taken off there too, 2 inner;
    /// negative in soil that holds its water. No dissipation acts across its face. (7.5)
    static constexpr Real kClear = 1, kSmooth = 1.5, kInner = 2;
};

/// 0 where friction resolves a shear, 1 where it is too weak; shear is |grad v| d0^2 [m2/s].
///                                                                                   [theory (7.8)]
inline Real unresolvedShare(Real shear, Real nu)
{
    const Real beyond = shear - kResolved * nu, all = (kUnresolved - kResolved) * nu;
    return beyond < all ? std::max(Real(0), beyond / all) : 1;
}

/// grad v of inner particles; where it is zero a velocity difference has no smooth part.
///                                                                                   [theory (7.3)]
template <bool HasSoil, int Dim>
void velocityGradient(const StepFields<Dim>& fields, Real spacing, Index i,
                      const Records<Carried<Dim>::size>& carried)
{
    using C = Carried<Dim>;
    Real* own = carried[i];
    std::fill(own + C::gradient, own + C::size, 0);
    if (std::abs(own[C::part]) < C::kSmooth) return;
    OuterSum<Dim> sum;
    bool whole = true;
    fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
        const auto of = carried.template gather<HasSoil ? 2 * kLanes : kLanes>(pairs.j);
        std::array<Lanes, Dim> change, x_ij;
        if constexpr (HasSoil)
            for (int l = 0; l < kLanes; ++l) whole &= of[C::zone][l] == own[C::zone];
        for (int d = 0; d < Dim; ++d) {
            change[d] = pairs.slope * of[C::volume] * (of[C::v + d] - own[C::v + d]);
            x_ij[d] = own[C::x + d] - of[C::x + d];
        }
        sum.add(change, x_ij);
    });
    const Mat<Dim> gradient = sum.total() * fields.corrections.Lwater(i);
    for (int r = 0; r < Dim; ++r)
        for (int c = 0; c < Dim; ++c) own[C::gradient + r * Dim + c] = gradient[r][c];
    own[C::whole] = whole && std::abs(own[C::part]) == C::kInner;
    Real shear2 = 0;
    for (int r = 0; r < Dim; ++r) shear2 += normSqr(gradient[r]);
    own[C::shear] = std::sqrt(shear2);
    // Soil feeds noise at any Reynolds number.
    const bool clear = own[C::whole] > 0 && own[C::zone] == kClearWater;
    own[C::unresolved] =
        clear ? unresolvedShare(own[C::shear] * sqr(spacing), own[C::viscosity]) : 1;
}

template <int Dim>
Mat<Dim> gradientOf(const Real* own)
{
    Mat<Dim> gradient;
    for (int r = 0; r < Dim; ++r)
        for (int c = 0; c < Dim; ++c) gradient[r][c] = own[Carried<Dim>::gradient + r * Dim + c];
    return gradient;
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

inline Lanes sizeOf(const Lanes& a)
{
    return a < 0 ? -a : a;
}

/// What is left of a without its smooth part: never more than it and never of the other sign.
inline Lanes roughPart(const Lanes& a, const Lanes& smooth)
{
    const Lanes rough = a - smooth;
    const Lanes less = rough * rough < a * a ? rough : a;
    return rough * a > 0 ? less : Lanes{};
}

/// a with a third of its rough part more, bounded.                                  [theory (2.13)]
inline Lanes sharpened(const Lanes& a, const Lanes& smooth)
{
    const Lanes more = kSharpening * (a - smooth), most = kMostSharpening * sizeOf(a);
    return a + (more < -most ? -most : (more > most ? most : more));
}

/// Viscosity along the lines to partners, that of two media in series.               [theory (3.3)]
template <int Dim>
Lanes viscosityOf(const Partners<Dim>& partners, const Lanes& ownShare)
{
    using C = Carried<Dim>;
    const Real nu_i = partners.own[C::viscosity];
    const Lanes nu_j = partners(C::viscosity), both = ownShare * nu_j + (1 - ownShare) * nu_i;
    return both > 0 ? nu_i * nu_j / both : Lanes{};
}

/// Second derivatives and second moments of a row of an inner particle, those of every lane apart:
/// what the anisotropy of the packing adds to friction.                             [theory (2.14)]
template <int Dim>
struct AnisotropySum {
    using C = Carried<Dim>;
    /// Sum V F x_ij x_ij, over the share of a full support
    std::array<std::array<Lanes, Dim>, Dim> spread{};
    /// Sum V (grad v_j - grad v_i) gradW_ij
    std::array<std::array<std::array<Lanes, Dim>, Dim>, Dim> bend{};

    void add(const Partners<Dim>& partners, const std::array<Lanes, Dim>& x, const Lanes& slope,
             const Lanes& weight, const Lanes& smooth)
    {
        const Lanes VSlope = smooth * partners(C::volume) * slope;
        for (int a = 0; a < Dim; ++a)
            for (int c = 0; c < Dim; ++c) {
                spread[a][c] += weight * x[a] * x[c];
                for (int d = 0; d < Dim; ++d)
                    bend[d][a][c] -= VSlope * partners.difference(C::gradient + d * Dim + a) * x[c];
            }
    }
    /// sum_ac (M_ac - delta_ac) d2v/dx_a dx_c
    Vec<Dim> excess(const auto& L) const
    {
        Vec<Dim> sum;
        for (int d = 0; d < Dim; ++d) {
            Mat<Dim> second;
            for (int a = 0; a < Dim; ++a) second[a] = sumOf(bend[d][a]);
            second = second * L;
            for (int a = 0; a < Dim; ++a)
                for (int c = 0; c < Dim; ++c)
                    sum[d] += (Real(0.5) * sumOf(spread[a][c]) - (a == c)) * second[a][c];
        }
        return sum;
    }
};
template <int Dim>
struct NoAnisotropySum {
    void add(const auto&...) {}
    Vec<Dim> excess(const auto&) const { return {}; }
};

/// Friction and dissipation of a row, those of every lane apart. Viscous: friction matters.
template <int Dim, bool Viscous>
struct RateSum {
    using C = Carried<Dim>;
    /// c_r; largest share of a velocity difference; of |x_ij|^2
    Real dissipation, most, shortest2;
    std::array<Lanes, Dim> rate{};
    std::array<Lanes, Dim> side{};       ///< sum V F x_ij over the share of a full support
    std::conditional_t<Viscous, AnisotropySum<Dim>, NoAnisotropySum<Dim>> anisotropy{};

    /// ownShare: of the line between both, in the zone of the particle itself.
    void add(const Partners<Dim>& partners, const Lanes& slope, const Lanes& ownShare)
    {
        std::array<Lanes, Dim> v_ij, x, smooth;
        Lanes approach{}, smoothApproach{}, r2{};
        for (int d = 0; d < Dim; ++d) {
            v_ij[d] = partners.difference(C::v + d);
            x[d] = partners.difference(C::x + d);
        }
        for (int d = 0; d < Dim; ++d) {
            smooth[d] = smoothPart(partners, x, d);
            approach += v_ij[d] * x[d];
            smoothApproach += smooth[d] * x[d];
            r2 += x[d] * x[d];
        }
        const Lanes VF = -2 * partners(C::volume) * slope;
        const Lanes weight = VF / supportOf(partners), nu = viscosityOf(partners, ownShare);
        const Lanes pull = pullOf(partners, VF, approach, smoothApproach, nu, r2)
                         / (r2 > shortest2 ? r2 : allLanes(shortest2));
        const Lanes friction = weight * nu,
                    smoothPair = partners.own[C::whole] * partners(C::whole);
        for (int d = 0; d < Dim; ++d) {
            const Lanes v = smoothPair > 0 ? sharpened(v_ij[d], smooth[d]) : v_ij[d];
            rate[d] -= friction * v + pull * x[d];
            side[d] += weight * x[d];
        }
        if (partners.own[C::whole] > 0) anisotropy.add(partners, x, slope, weight, smoothPair);
    }

private:
    /// Component d of (grad v_i + grad v_j) x_ij/2
    static Lanes smoothPart(const Partners<Dim>& partners, const std::array<Lanes, Dim>& x, int d)
    {
        Lanes smooth{};
        for (int c = 0; c < Dim; ++c)
            smooth += Real(0.5) * partners.sum(C::gradient + d * Dim + c) * x[c];
        return smooth;
    }
    static Lanes supportOf(const Partners<Dim>& partners)
    {
        const Lanes support = partners.sum(C::lambda) * (Real(0.5) / Dim);
        return support > kLeastPairSupport ? support : allLanes(kLeastPairSupport);
    }
    /// What of a rough part's size is noise: all where friction is too weak for the shear, else
    /// what is more than the bends of a shear can be.                                [theory (7.8)]
    /// Inlined, as pullOf(), or numbers of partners would go through memory.
    [[gnu::always_inline]] static Lanes noiseOf(const Partners<Dim>& partners, const Lanes& rough,
                                                const Lanes& r2)
    {
        const Lanes own = allLanes(partners.own[C::unresolved]), of = partners(C::unresolved);
        const Lanes size = sizeOf(rough), unresolved = (own > of ? own : of) * size;
        const Lanes beyond = 2 * size - Real(0.5) * partners.sum(C::shear) * r2;
        const Lanes noise = beyond < size ? beyond : size;
        return noise > unresolved ? noise : unresolved;
    }
    /// 2 V F (c_r n - nu) a, a the approach or its rough part, n what of its size counts: what
    /// friction does not do itself.
    [[gnu::always_inline]] Lanes pullOf(const Partners<Dim>& partners, const Lanes& VF,
                                        const Lanes& approach, const Lanes& smooth, const Lanes& nu,
                                        const Lanes& r2) const
    {
        if (dissipation == 0) return Lanes{};
        const Lanes part = partners(C::part) * (partners.own[C::part] < 0 ? Real(-1) : Real(1));
        Lanes a = approach, viscosity = dissipation * kWholeStrength * sizeOf(approach);
        if (std::abs(partners.own[C::part]) >= C::kSmooth) {
            const Lanes rough = roughPart(approach, smooth);
            a = part >= C::kSmooth ? rough : approach;
            viscosity = part >= C::kSmooth
                            ? dissipation * kRoughStrength * noiseOf(partners, rough, r2)
                            : viscosity;
        }
        const Lanes lacking = viscosity - nu;
        const Lanes pull = 2 * VF * (lacking > 0 ? lacking : Lanes{});
        return part < C::kClear ? Lanes{} : (pull < most ? pull : allLanes(most)) * a;
    }
};

/// Points of the lattice within 2 h. A pair may take away this share of its velocity difference in
/// a step and no more: the dissipation is explicit and must not overshoot where sprays meet.
template <int Dim>
Real neighboursOfLattice(const Scheme<Dim>& scheme)
{
    const Real q = 2 * scheme.h0 / scheme.spacing, pi = 3.141592653589793;
    return Dim == 2 ? pi * sqr(q) : 4 * pi / 3 * cube(q);
}
/// Shares of the lines to partners in the zone of the particle itself.              [theory (4.15)]
template <int Dim, class Medium>
Lanes ownShareOf(Index i, const Medium& medium, const PairLanes& pairs,
                 const Partners<Dim>& partners)
{
    using C = Carried<Dim>;
    Lanes share = allLanes(0.5);
    for (int l = 0; l < kLanes; ++l) {
        Vec<Dim> x_ij;
        for (int d = 0; d < Dim; ++d) x_ij[d] = partners.difference(C::x + d)[l];
        share[l] = medium.weight(i, pairs.j[l], x_ij);
    }
    return share;
}

/// nu grad v of a particle that has partners across a face, of the viscosity of each pair: exact
/// where the stress is uniform, whatever the jump of the gradient.                  [theory (2.15)]
template <int Dim, class Medium>
Mat<Dim> stressOf(Index i, const Medium& medium, const StepFields<Dim>& fields,
                  const Records<Carried<Dim>::size>& carried)
{
    using C = Carried<Dim>;
    OuterSum<Dim> sum;
    fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
        const Partners<Dim> partners{carried[i], carried.gather(pairs.j)};
        const Lanes nu = viscosityOf(partners, ownShareOf(i, medium, pairs, partners));
        std::array<Lanes, Dim> change, x_ij;
        for (int d = 0; d < Dim; ++d) {
            change[d] = -pairs.slope * partners(C::volume) * nu * partners.difference(C::v + d);
            x_ij[d] = partners.difference(C::x + d);
        }
        sum.add(change, x_ij);
    });
    return sum.total() * fields.corrections.Lwater(i);
}

/// What the boundary layer at the nearest wall takes from a particle, whose Darcy velocity is v_i.
///                                                                                  [theory (6.11)]
template <int Dim>
Vec<Dim> wallLawOf(Index i, const Vec<Dim>& v_i, Real porosity, const WallCloud<Dim>& walls,
                   const Scheme<Dim>& scheme, const StepFields<Dim>& fields)
{
    const Real spacing = scheme.spacing * fields.points.h[i] / scheme.h0;
    Real nearest = std::numeric_limits<Real>::max(), height = 0;
    Index wall = -1;
    fields.pairs.forWalls(i, [&](const auto& pair) {
        const Index k = pair.j - fields.points.fluid;
        if (normSqr(pair.x_ij) >= nearest || walls.depth[k] >= scheme.spacing) return;
        nearest = normSqr(pair.x_ij), wall = k,
        height = dot(pair.x_ij, walls.normal[k]) - walls.depth[k];
    });
    if (wall < 0 || !walls.wallLaw[wall]) return {};
    const Vec<Dim> passing = v_i - porosity * walls.velocity[wall];
    const Vec<Dim> along = passing - dot(passing, walls.normal[wall]) * walls.normal[wall];
    const Real stress =
        wallStress(norm(along), std::max(height, Real(0.5) * spacing), scheme.viscosity);
    return -stress * wallLayer(height, spacing) * unit(along);
}

/// Accelerations of a particle by friction and dissipation.
template <bool Viscous, int Dim, class Medium>
Vec<Dim> rateOf(Index i, const Medium& medium, const WallCloud<Dim>& walls,
                const Scheme<Dim>& scheme, Real most, const StepFields<Dim>& fields,
                const Records<Carried<Dim>::size>& carried)
{
    using C = Carried<Dim>;
    const auto& pairs = fields.pairs;
    const Real* own = carried[i];
    RateSum<Dim, Viscous> sum{scheme.dissipation, most, 1e-12 * sqr(scheme.spacing)};
    const bool whole = own[C::whole] > 0;
    pairs.forWaterLanes(i, [&](const PairLanes& eight) {
        const Partners<Dim> partners{own, carried.gather(eight.j)};
        Lanes ownShare = allLanes(0.5);
        if constexpr (Medium::hasSoil)
            if (!whole) ownShare = ownShareOf(i, medium, eight, partners);
        sum.add(partners, eight.slope, ownShare);
    });
    Vec<Dim> rate = sumOf(sum.rate), side = sumOf(sum.side), v_i;
    for (int d = 0; d < Dim; ++d) v_i[d] = own[C::v + d];
    const Real nu_i = own[C::viscosity];
    if (!walls.noSlip.empty())
        pairs.forWalls(i, [&](const auto& pair) {
            const Index k = pair.j - fields.points.fluid;
            if (!walls.noSlip[k]) return;
            const Real weight = fields.points.volume[pair.j] * pair.F() *
                                supportFactor<Dim>(own[C::lambda], own[C::lambda]);
            rate -=
                weight * nu_i * walls.slip(k, pair.x_ij, v_i, medium.porosity(i), scheme.spacing);
            side += weight * pair.x_ij;
        });
    if (!walls.wallLaw.empty() && pairs.wallNeighbours(i) > 0)
        rate += wallLawOf<Dim>(i, v_i, medium.porosity(i), walls, scheme, fields);
    const bool inner = std::abs(own[C::part]) == C::kInner, clear = pairs.wallNeighbours(i) == 0;
    // Where slip walls cut the support the Laplacian stays as it is.
    if (inner && (clear || !walls.noSlip.empty())) {
        if constexpr (Medium::hasSoil) {
            if (inner && !whole && nu_i > 0)
                return rate + stressOf(i, medium, fields, carried) * side;
        }
        rate += nu_i * (gradientOf<Dim>(own) * side);
    }
    if (clear && whole) rate -= nu_i * sum.anisotropy.excess(fields.corrections.Lwater(i));
    return rate;
}
}  // namespace

template <int Dim, class Medium>
void predict(const Water<Dim>& water, const WallCloud<Dim>& walls, const Medium& medium,
             const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields)
{
    const Points<Dim>& points = fields.points;
    // Slip walls take no part in the friction, nor then in its support.
    const auto& lambda =
        walls.noSlip.empty() ? fields.corrections.lambdaWater : fields.corrections.lambda;
    const bool turbulent = !fields.eddyViscosity.empty();
    using C = Carried<Dim>;
    const auto carried = fields.pairs.template records<C::size>();
    parallelFor(points.water, [&](Index i) {
        Real* to = carried[i];
        if constexpr (Medium::hasSoil)
            for (int d = 0; d < Dim; ++d) to[C::v + d] = fields.face.v[i][d];
        else
            for (int d = 0; d < Dim; ++d)
                to[C::v + d] = weights.extrapolated(water.u[i][d], water.uOld[i][d]);
        const bool inner = fields.role[i] == SurfaceRole::inner;
        to[C::part] = (inner                   ? C::kInner
                       : scheme.wholeAtSurface ? C::kClear
                                               : C::kSmooth) *
                      (medium.isHeld(i, norm(water.u[i])) ? -1 : 1);
        to[C::volume] = points.volume[i];
        to[C::lambda] = lambda[i];
        to[C::viscosity] = (scheme.viscosity + (turbulent ? fields.eddyViscosity[i] : 0)) /
                           medium.sharpPorosity(i);
        to[C::zone] = medium.zone(i);
    });
    const auto copyToImages = [&](int from, int to) {
        parallelFor(points.images(), [&](Index k) {
            const Real* owner = carried[points.owner[points.water + k]];
            std::copy(owner + from, owner + to, carried[points.water + k] + from);
        });
    };
    copyToImages(0, C::gradient);
    parallelFor(points.fluid, [&](Index i) {
        for (int d = 0; d < Dim; ++d) carried[i][C::x + d] = points.x[i][d];
    });
    const bool rubs = scheme.dissipation > 0 || scheme.viscosity > 0 || turbulent;
    if (rubs) {
        parallelForDynamic(points.water, [&](Index i) {
            velocityGradient<Medium::hasSoil>(fields, scheme.spacing, i, carried);
        });
        copyToImages(C::gradient, C::size);
    }
    const bool viscous = scheme.viscosity * weights.dtPrime() > kViscous * sqr(scheme.h0);
    const Real most = 1 / (neighboursOfLattice(scheme) * weights.dtPrime());
    fields.v.resize(points.fluid);
    parallelForDynamic(points.water, [&](Index i) {
        Vec<Dim> rate;
        if (rubs)
            rate = viscous ? rateOf<true>(i, medium, walls, scheme, most, fields, carried)
                           : rateOf<false>(i, medium, walls, scheme, most, fields, carried);
        Vec<Dim> start;
        if constexpr (Medium::hasSoil) start = fields.v[i];
        else start = weights.now() * water.u[i] + weights.before() * water.uOld[i];
        fields.v[i] = start + medium.mobility(i) * weights.dtPrime() * rate;
    });
    points.refresh(fields.v);
}

template void predict(const Water<2>&, const WallCloud<2>&, const ClearWater<2>&, const Scheme<2>&,
                      const StepWeights&, StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const ClearWater<3>&, const Scheme<3>&,
                      const StepWeights&, StepFields<3>&);
template void predict(const Water<2>&, const WallCloud<2>&, const WaterInSoil<2>&, const Scheme<2>&,
                      const StepWeights&, StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const WaterInSoil<3>&, const Scheme<3>&,
                      const StepWeights&, StepFields<3>&);

}  // namespace isph
