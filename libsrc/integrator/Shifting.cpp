// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Shifting.hpp"

#include "operators/Gradient.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

template <int Dim>
Real internalSpeed(const std::vector<Vec<Dim>>& u)
{
    const std::size_t n = u.size();
    const Vec<Dim> mean =
        orderedSum(n, [&](Index i) { return u[i]; }) / std::max<Real>(1, static_cast<Real>(n));
    return std::sqrt(orderedMax(n, 0, [&](Index i) { return normSqr(u[i] - mean); }));
}

namespace {
constexpr Real kTensile = 0.2;             // [Monaghan 2000], power 4
constexpr Real kLeastSupport = 0.4;        // lambda/Dim below which nothing is shifted
constexpr Real kSoilShare = 0.05;
constexpr Real kEdge = 1e-12;  // of W(s_i): rounding decides about pairs at the edge of the support
constexpr Real kSurfaceCollision = 0.95;   // in local spacings: between particles of the surface
// |T_i| h_i from which on walls leave a particle too little room (5.4)
constexpr Real kCorner = 0.3;

/// What shifting asks of a partner. Water beside soil sees the Darcy velocity, which is continuous
/// across the face; pores are swifter.
template <int Dim>
struct Neighbour {
    /// Velocities of both times fit one record of eight. In 3-D those of the step before have one
    /// of their own and a loop of their own, for registers do not hold the sums of both.
    static constexpr bool bothTimes = Dim == 2;
    enum Place : int {
        x = 0,
        u = Dim,
        volume = 2 * Dim,
        before = bothTimes ? 0 : kLanes,
        size = before + kLanes
    };
    /// From `before` on, x and volume as above
    enum PlaceBefore : int {
        uOld = bothTimes ? 6 : Dim
    };
};

/// Sums over the water partners of a particle, those of every lane apart.
template <int Dim>
struct ShiftSum {
    using N = Neighbour<Dim>;
    const Real* own;
    Real WLattice;                            ///< W(s_i)
    /// Without their correction; the latter if a record has both times
    OuterSum<Dim> gradU{}, gradUOld{};
    std::array<Lanes, Dim> bend{};            ///< sum V F (u_j - u_i)
    std::array<Lanes, Dim> concentration{};
    Lanes fastest2{};                         ///< largest |u_ij|^2

    void add(const PairLanes& pairs, const std::array<Lanes, kLanes>& of)
    {
        std::array<Lanes, Dim> x, u_ij, toPartner;
        [[maybe_unused]] std::array<Lanes, Dim> toPartnerOld;
        const Lanes VSlope = of[N::volume] * pairs.slope;
        Lanes speed2{};
        for (int d = 0; d < Dim; ++d) {
            x[d] = own[N::x + d] - of[N::x + d];
            u_ij[d] = own[N::u + d] - of[N::u + d];
            speed2 += u_ij[d] * u_ij[d];
            toPartner[d] = -VSlope * u_ij[d];
            bend[d] -= 2 * toPartner[d];
            if constexpr (N::bothTimes)
                toPartnerOld[d] = VSlope * (of[N::uOld + d] - own[N::uOld + d]);
        }
        gradU.add(toPartner, x);
        if constexpr (N::bothTimes) gradUOld.add(toPartnerOld, x);
        const Lanes share = pairs.W * (1 / WLattice), squared = share * share;
        const Lanes crowding = VSlope * (1 + kTensile * squared * squared);
        for (int d = 0; d < Dim; ++d) concentration[d] += crowding * x[d];
        fastest2 = (share > kEdge) & (speed2 > fastest2) ? speed2 : fastest2;
    }
};

template <int Dim>
Records<Neighbour<Dim>::size> neighboursOf(const StepFields<Dim>& fields, const Water<Dim>& water)
{
    using N = Neighbour<Dim>;
    const Points<Dim>& points = fields.points;
    const auto neighbours = fields.pairs.template records<N::size>();
    parallelFor(points.fluid, [&](Index k) {
        Real* to = neighbours[k];
        const Index i = points.owner[k];
        const Real eps = fields.soil.porosity[i];
        Real* before = to + N::before;
        for (int d = 0; d < Dim; ++d) {
            to[N::x + d] = before[N::x + d] = points.x[k][d];
            to[N::u + d] = eps * water.u[i][d], before[N::uOld + d] = eps * water.uOld[i][d];
        }
        to[N::volume] = before[N::volume] = points.volume[k];
    });
    return neighbours;
}

/// Gradient of the velocities of the step before, without its correction.
template <int Dim>
Mat<Dim> gradientBefore(const PairList<Dim>& pairs, const Records<Neighbour<Dim>::size>& neighbours,
                        Index i, const ShiftSum<Dim>& shiftSum)
{
    using N = Neighbour<Dim>;
    if constexpr (N::bothTimes) return shiftSum.gradUOld.total();
    const Records<N::size> all(neighbours[0] + N::before);
    const Real* own = all[i];
    OuterSum<Dim> sum;
    pairs.forWaterLanes(i, [&](const PairLanes& eight) {
        const auto of = all.template gather<kLanes>(eight.j);
        const Lanes VSlope = of[N::volume] * eight.slope;
        std::array<Lanes, Dim> x, change;
        for (int d = 0; d < Dim; ++d) {
            x[d] = own[N::x + d] - of[N::x + d];
            change[d] = VSlope * (of[N::uOld + d] - own[N::uOld + d]);
        }
        sum.add(change, x);
    });
    return sum.total();
}

/// The way in which lambda rises: away from a surface that is near.
template <int Dim>
Vec<Dim> risingLambda(const StepFields<Dim>& fields, Index i)
{
    const auto& lambda = fields.corrections.lambda;
    Vec<Dim> sum;
    fields.pairs.forWater(i, [&](const auto& pair) {
        sum += (fields.points.volume[pair.j] * (lambda[pair.j] - lambda[i])) * pair.gradW();
    });
    return sum;
}

/// How far a shift may go.                                                           [theory (7.1)]
template <int Dim>
Real largestShift(const Scheme<Dim>& scheme, Real h)
{
    return scheme.largestShift * scheme.spacing * h / scheme.h0;
}

/// d_i of (7.1)
template <int Dim>
Vec<Dim> shiftOf(const Scheme<Dim>& scheme, Real dt, const StepFields<Dim>& fields,
                 const ShiftSum<Dim>& sum, Index i)
{
    const Points<Dim>& points = fields.points;
    const Real h = points.h[i];
    Vec<Dim> concentration = sumOf(sum.concentration);
    Real wall = 0;
    fields.pairs.forWalls(i, [&](const auto& pair) {
        const Real V = points.volume[pair.j];
        concentration += (V * (1 + kTensile * sqr(sqr(pair.W / sum.WLattice)))) * pair.gradW();
        wall += V;
    });
    // Where a surface meets a wall its tangent is not known; water would be pumped up the wall.
    if (wall > 0 && fields.role[i] == SurfaceRole::surface) return {};
    Real U2 = 0;
    for (int l = 0; l < kLanes; ++l) U2 = std::max(U2, sum.fastest2[l]);
    Vec<Dim> step = (-scheme.shifting * h * dt * std::sqrt(U2)) * concentration;
    if (fields.role[i] != SurfaceRole::inner) {
        const bool surface = fields.role[i] == SurfaceRole::surface;
        const Vec<Dim> e = unit(surface ? fields.corrections.lopsided[i] : risingLambda(fields, i));
        step -= dot(step, e) * e;
    }
    return atMost(step, largestShift(scheme, h));
}

/// Inner particles without walls in their support.
template <int Dim>
bool isClear(const StepFields<Dim>& fields, Index i)
{
    return fields.role[i] == SurfaceRole::inner && fields.pairs.wallNeighbours(i) == 0;
}

/// Whether what neighbours would be moved by in common is left out.                  [theory (7.1)]
template <int Dim>
bool leavesMeanOut(const StepFields<Dim>& fields, Index i)
{
    if (fields.role[i] != SurfaceRole::inner) return false;
    return fields.pairs.wallNeighbours(i) == 0 ||
           norm(fields.corrections.lopsided[i]) * fields.points.h[i] < kCorner;
}

/// What a shift needs to know of the flow where the particle stands. It is short enough for single
/// precision.
///                                                                                   [theory (7.2)]
template <int Dim>
struct Move {
    using Gradient = std::array<float, Dim * Dim>;
    Vec<Dim> step;                ///< d_i
    Gradient gradU, gradUOld;
    std::array<float, Dim> bend;  ///< Laplacian of u; zero but for inner particles away from walls

    /// grad u step + |step|^2/(2 Dim) lap u, with that of u for both times: between them it changes
    /// little.
    Vec<Dim> along(const Gradient& gradient, const Vec<Dim>& way) const
    {
        const Real spread = normSqr(way) / (2 * Dim);
        Vec<Dim> change;
        for (int d = 0; d < Dim; ++d) {
            change[d] = spread * static_cast<Real>(bend[d]);
            for (int c = 0; c < Dim; ++c)
                change[d] += static_cast<Real>(gradient[d * Dim + c]) * way[c];
        }
        return change;
    }
};

template <int Dim>
Move<Dim> moveOf(const StepFields<Dim>& fields, const ShiftSum<Dim>& sum, const Mat<Dim>& gradU,
                 const Mat<Dim>& gradUOld, const Vec<Dim>& step, Index i)
{
    Move<Dim> move;
    move.step = step;
    // What the sums make of a linear flow in an uneven packing does not belong to the Laplacian
    // (7.7); `lopsided` is -T_i.
    Vec<Dim> bend;
    if (isClear(fields, i)) bend = sumOf(sum.bend) + gradU * fields.corrections.lopsided[i];
    for (int d = 0; d < Dim; ++d) {
        move.bend[d] = static_cast<float>(bend[d]);
        for (int c = 0; c < Dim; ++c) {
            move.gradU[d * Dim + c] = static_cast<float>(gradU[d][c]);
            move.gradUOld[d * Dim + c] = static_cast<float>(gradUOld[d][c]);
        }
    }
    return move;
}

/// What pairs ask of a partner's move.
template <int Dim>
struct Step {
    enum Place : int { step = 0, volume = Dim, size = 4 };
};

/// Mean of d over a particle and its partners.                                       [theory (7.1)]
template <int Dim>
Vec<Dim> meanStep(const StepFields<Dim>& fields, const Records<Step<Dim>::size>& steps, Index i)
{
    using S = Step<Dim>;
    std::array<Lanes, Dim> sum{};
    Lanes weight{};
    fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
        const auto of = steps.gather(pairs.j);
        const Lanes VW = of[S::volume] * pairs.W;
        weight += VW;
        for (int d = 0; d < Dim; ++d) sum[d] += VW * of[S::step + d];
    });
    const Real own = fields.points.volume[i] * fields.pairs.selfW(i);
    Vec<Dim> mean = sumOf(sum);
    for (int d = 0; d < Dim; ++d) mean[d] += own * steps[i][S::step + d];
    return mean / (own + sumOf(weight));
}

/// Moves the particles, and their velocities with the flow field.                    [theory (7.2)]
template <int Dim>
void applyMoves(const Scheme<Dim>& scheme, const StepFields<Dim>& fields,
                const LargeArray<Move<Dim>>& moves, Water<Dim>& water)
{
    using S = Step<Dim>;
    const Points<Dim>& points = fields.points;
    const auto steps = fields.pairs.template records<S::size>();
    parallelFor(points.fluid, [&](Index k) {
        for (int d = 0; d < Dim; ++d) steps[k][S::step + d] = moves[points.owner[k]].step[d];
        steps[k][S::volume] = points.volume[k];
    });
    parallelForDynamic(points.water, [&](Index i) {
        const Move<Dim>& move = moves[i];
        if (move.step == Vec<Dim>{}) return;
        Vec<Dim> step = move.step;
        if (leavesMeanOut(fields, i))
            step = atMost(step - meanStep(fields, steps, i), largestShift(scheme, points.h[i]));
        const Real eps = fields.soil.porosity[i];
        water.x[i] += step;
        water.u[i] += (1 / eps) * move.along(move.gradU, step);
        water.uOld[i] += (1 / eps) * move.along(move.gradUOld, step);
    });
}
}  // namespace

template <int Dim>
Real shift(const Kernel& kernel, const Scheme<Dim>& scheme, Real dt, const StepFields<Dim>& fields,
           Water<Dim>& water)
{
    const Index n = fields.points.water;
    const Real qLattice = scheme.spacing / scheme.h0;
    Real w = 0, slope = 0;
    kernel.evaluate(Span<const Real>(&qLattice, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
    const Real wLattice = w * kernel.normalisation(Dim);   // W(s_i) h_i^D
    const auto neighbours = neighboursOf(fields, water);
    LargeArray<Real> divergence(n);
    LargeArray<Move<Dim>> moves(scheme.shifting == 0 ? 0 : n);
    parallelForDynamic(n, [&](Index i) {
        const Real h = fields.points.h[i];
        ShiftSum<Dim> sum{neighbours[i], wLattice / (Dim == 2 ? sqr(h) : cube(h))};
        fields.pairs.forWaterLanes(i, [&](const PairLanes& pairs) {
            sum.add(pairs, neighbours.template gather<kLanes>(pairs.j));
        });
        const Mat<Dim> L = fields.corrections.Lwater(i), gradU = sum.gradU.total() * L;
        divergence[i] = fields.role[i] == SurfaceRole::inner ? sqr(dt * trace(gradU)) : 0;
        if (scheme.shifting == 0) return;
        moves[i].step = {};
        const bool inSoil = !fields.soil.share.empty() && fields.soil.share[i] > kSoilShare;
        if (fields.corrections.lambda[i] < kLeastSupport * Dim || inSoil) return;
        const Vec<Dim> step = shiftOf(scheme, dt, fields, sum, i);
        if (normSqr(step) == 0) return;
        moves[i] = moveOf(fields, sum, gradU, gradientBefore(fields.pairs, neighbours, i, sum) * L,
                          step, i);
    });
    if (scheme.shifting != 0) applyMoves(scheme, fields, moves, water);
    return std::sqrt(orderedSum(n, [&](Index i) { return divergence[i]; }) / std::max<Index>(1, n));
}

template <int Dim>
void collide(const Scheme<Dim>& scheme, const StepFields<Dim>& fields,
             Span<const Vec<Dim>> wallNormal, Span<const Real> wallDepth, Water<Dim>& water)
{
    const Points<Dim>& points = fields.points;
    const auto before = fields.pairs.template records<4>();   // velocities
    parallelFor(points.fluid, [&](Index k) {
        for (int d = 0; d < Dim; ++d) before[k][d] = water.u[points.owner[k]][d];
    });
    const auto u = [&](Index k) {
        Vec<Dim> velocity;
        for (int d = 0; d < Dim; ++d) velocity[d] = before[k][d];
        return velocity;
    };
    const Real farthest = std::max(kSurfaceCollision, scheme.collisionDistance);
    parallelForDynamic(points.water, [&](Index i) {
        const Real spacing = scheme.spacing * points.h[i] / scheme.h0;
        const bool surface = fields.role[i] == SurfaceRole::surface;
        const bool near =
            fields.pairs.nearest(i) < (surface ? farthest : scheme.collisionDistance) * spacing;
        if (!near && fields.pairs.wallNeighbours(i) == 0) return;
        Vec<Dim> change;
        if (near) fields.pairs.forWater(i, [&](const auto& pair) {
            const bool both = surface && fields.role[pair.j] == SurfaceRole::surface;
            const Real reach = (both ? kSurfaceCollision : scheme.collisionDistance) * spacing;
            const Real r2 = normSqr(pair.x_ij), approach = dot(u(i) - u(pair.j), pair.x_ij);
            if (r2 < reach * reach && approach < 0 && r2 > 0)
                change -= (Real(0.5) * approach / r2) * pair.x_ij;
        });
        fields.pairs.forWalls(i, [&](const auto& pair) {
            const Index k = pair.j - points.fluid;
            // Above the wall surface
            const Real height = dot(pair.x_ij, wallNormal[k]) - wallDepth[k];
            const Real beside = normSqr(pair.x_ij - dot(pair.x_ij, wallNormal[k]) * wallNormal[k]);
            const Real approach = dot(u(i) + change, wallNormal[k]);
            const Real wallReach = (scheme.collisionDistance - Real(0.25)) * scheme.spacing;
            if (wallDepth[k] < scheme.spacing && height < wallReach && approach < 0
                && beside < sqr(Real(0.75) * scheme.spacing))
                change -= approach * wallNormal[k];
        });
        water.u[i] += change;
        water.uOld[i] += change;
    });
}

template Real internalSpeed(const std::vector<Vec<2>>&);
template Real internalSpeed(const std::vector<Vec<3>>&);
template Real shift(const Kernel&, const Scheme<2>&, Real, const StepFields<2>&, Water<2>&);
template Real shift(const Kernel&, const Scheme<3>&, Real, const StepFields<3>&, Water<3>&);
template void collide(const Scheme<2>&, const StepFields<2>&, Span<const Vec<2>>, Span<const Real>,
                      Water<2>&);
template void collide(const Scheme<3>&, const StepFields<3>&, Span<const Vec<3>>, Span<const Real>,
                      Water<3>&);

}  // namespace isph
