// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/Corrections.hpp"

#include <algorithm>

namespace isph {

namespace {
// A flat surface has a smallest eigenvalue near 0.5, splashes below 0.2 (numerical experiments with
// Wendland C2, h = 1.5 d0).
constexpr Real kBlendFrom = 0.10, kBlendTo = 0.25;
}  // namespace

template <int Dim>
Mat<Dim> blendedInverse(const Mat<Dim>& A)
{
    const Real e = smallestEigenvalue(A);
    const Real weight = std::clamp((e - kBlendFrom) / (kBlendTo - kBlendFrom), Real(0), Real(1));
    if (weight == 0) return Mat<Dim>::identity();
    return weight * inverse(A) + (1 - weight) * Mat<Dim>::identity();
}

template <int Dim>
void Corrections<Dim>::compute(const Points<Dim>& points, const PairList<Dim>& pairs)
{
    const Index n = points.water;
    lambda.resize(points.fluid), lambdaWater.resize(points.fluid);
    filling.resize(n), L.resize(n), Lwater.resize(n), seen.resize(n), lopsided.resize(n);
    parallelForDynamic(n, [&](Index i) {
        Mat<Dim> A;
        Vec<Dim> side;
        Real fill = points.volume[i] * pairs.selfW(i);
        const auto add = [&](const auto& pair) {
            const Real V = points.volume[pair.j];
            A += (-V * pair.slope) * outer(pair.x_ij, pair.x_ij);
            side += V * pair.F() * pair.x_ij;
            fill += V * pair.W;
        };
        pairs.forWater(i, add);
        Lwater[i] = blendedInverse(A);
        lambdaWater[i] = trace(A);
        pairs.forWalls(i, add);
        L[i] = blendedInverse(A);
        seen[i] = L[i] * A;
        lambda[i] = trace(A);
        filling[i] = fill;
        lopsided[i] = side;
    });
    points.refresh(lambda), points.refresh(lambdaWater);
}

template Mat<2> blendedInverse(const Mat<2>&);
template Mat<3> blendedInverse(const Mat<3>&);
template struct Corrections<2>;
template struct Corrections<3>;

}  // namespace isph
