// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/Corrections.hpp"

#include <algorithm>

namespace isph {

namespace {
// A flat surface has a smallest eigenvalue near 0.5, splashes below 0.2 (numerical experiments with
// Wendland C2, h = 1.5 d0).
constexpr Real kBlendFrom = 0.10, kBlendTo = 0.25;

/// Whether all eigenvalues of the symmetric A exceed e: A - e I has positive leading minors.
inline bool exceeds(Mat<2> A, Real e)
{
    A[0][0] -= e, A[1][1] -= e;
    return A[0][0] > 0 && determinant(A) > 0;
}
inline bool exceeds(Mat<3> A, Real e)
{
    for (int d = 0; d < 3; ++d) A[d][d] -= e;
    return A[0][0] > 0 && A[0][0] * A[1][1] > A[0][1] * A[1][0] && determinant(A) > 0;
}

/// What a pair asks of its partner.
template <int Dim>
struct Partner {
    enum Place : int { x = 0, volume = Dim, size = 4 };
};

/// Sums over the pairs of a row, those of every lane apart.
template <int Dim>
struct Moments {
    using P = Partner<Dim>;
    const Real* own;
    std::array<std::array<Lanes, Dim>, Dim> outer{};   ///< sum V slope x_ij x_ij, its lower half
    std::array<Lanes, Dim> side{};                     ///< sum V slope x_ij
    Lanes fill{};                                      ///< sum V W

    void add(const PairLanes& pairs, const std::array<Lanes, P::size>& of)
    {
        const Lanes weight = of[P::volume] * pairs.slope;
        fill += of[P::volume] * pairs.W;
        std::array<Lanes, Dim> x;
        for (int r = 0; r < Dim; ++r) {
            x[r] = own[P::x + r] - of[P::x + r];
            const Lanes weighted = weight * x[r];
            side[r] += weighted;
        }
        for (int r = 0; r < Dim; ++r)
            for (int c = 0; c < Dim; ++c)   // bounds that are known, or the sums are kept in memory
                if (c <= r) outer[r][c] += weight * x[r] * x[c];
    }
    /// A of (2.9)
    Mat<Dim> matrix() const
    {
        Mat<Dim> A;
        for (int r = 0; r < Dim; ++r)
            for (int c = 0; c <= r; ++c) A[r][c] = A[c][r] = -sumOf(outer[r][c]);
        return A;
    }
    Vec<Dim> lopsided() const
    {
        Vec<Dim> T;
        for (int d = 0; d < Dim; ++d) T[d] = -2 * sumOf(side[d]);
        return T;
    }
};

template <int Dim>
Records<Partner<Dim>::size> partnersOf(const Points<Dim>& points, const PairList<Dim>& pairs)
{
    using P = Partner<Dim>;
    const auto partners = pairs.template recordsOfAll<P::size>();
    parallelFor(points.size(), [&](Index k) {
        Real* to = partners[k];
        for (int d = 0; d < Dim; ++d) to[P::x + d] = points.x[k][d];
        to[P::volume] = points.volume[k];
    });
    return partners;
}
}  // namespace

template <int Dim>
Mat<Dim> blendedInverse(const Mat<Dim>& A)
{
    if (exceeds(A, kBlendTo)) return inverse(A);
    const Real e = smallestEigenvalue(A);
    const Real weight = std::clamp((e - kBlendFrom) / (kBlendTo - kBlendFrom), Real(0), Real(1));
    if (weight == 0) return Mat<Dim>::identity();
    return weight * inverse(A) + (1 - weight) * Mat<Dim>::identity();
}

/// Returns whether the particle is a special one.
template <int Dim>
bool Corrections<Dim>::computeRow(const Points<Dim>& points, const PairList<Dim>& pairs,
                                  const Records<4>& partners, Index i, Special& special)
{
    Moments<Dim> moments{partners[i]};
    const auto add = [&](const PairLanes& eight) { moments.add(eight, partners.gather(eight.j)); };
    pairs.forWaterLanes(i, add);
    Mat<Dim> A = moments.matrix();
    Mat<Dim> inverseA = blendedInverse(A);
    special.Lwater = inverseA;
    lambdaWater[i] = trace(A);
    const bool walls = pairs.wallNeighbours(i) > 0;
    if (walls) {
        pairs.forWallLanes(i, add);
        A = moments.matrix();
        inverseA = blendedInverse(A);
    }
    const bool full = exceeds(A, kBlendTo);
    L[i] = inverseA;
    special.seen = full ? Mat<Dim>::identity() : inverseA * A;
    lambda[i] = trace(A);
    filling[i] = points.volume[i] * pairs.selfW(i) + sumOf(moments.fill);
    lopsided[i] = moments.lopsided();
    return walls || !full;
}

template <int Dim>
void Corrections<Dim>::compute(const Points<Dim>& points, const PairList<Dim>& pairs)
{
    const Index n = points.water;
    lambda.resize(points.fluid), lambdaWater.resize(points.fluid);
    filling.resize(n), L.resize(n), lopsided.resize(n), place_.resize(n);
    const auto partners = partnersOf(points, pairs);
    parallelForDynamic(n, [&](Index i) {
        Special special;   // the few are computed again when their number is known
        const bool walls = pairs.wallNeighbours(i) > 0;
        place_[i] = walls || computeRow(points, pairs, partners, i, special) ? 0 : -1;
    });
    Index count = 0;
    for (Index& place : place_)
        if (place >= 0) place = count++;
    special_.resize(count);
    parallelForDynamic(n, [&](Index i) {
        if (place_[i] >= 0) computeRow(points, pairs, partners, i, special_[place_[i]]);
    });
    points.refresh(lambda), points.refresh(lambdaWater);
}

template Mat<2> blendedInverse(const Mat<2>&);
template Mat<3> blendedInverse(const Mat<3>&);
template struct Corrections<2>;
template struct Corrections<3>;

}  // namespace isph
