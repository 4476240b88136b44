// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Scatter.hpp"
#include "operators/Corrections.hpp"
#include "operators/StrainRate.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Points with their pairs and corrections.
template <int Dim>
struct Cloud {
    explicit Cloud(Points<Dim> p) : points(std::move(p))
    {
        pairs.build(points, *kernelNamed("wendlandC2"));
        corrections.compute(points, pairs);
    }
    /// A_i of (2.9), over water or over all.
    Mat<Dim> moment(Index i, bool water) const
    {
        Mat<Dim> A;
        const auto add = [&](const auto& pair) {
            A += (-points.volume[pair.j]) * outer(pair.gradW(), pair.x_ij);
        };
        if (water) pairs.forWater(i, add);
        else pairs.forAll(i, add);
        return A;
    }
    Points<Dim> points;
    PairList<Dim> pairs;
    Corrections<Dim> corrections;
};

template <int Dim>
Vec<Dim> slopes()
{
    Vec<Dim> a;
    for (int d = 0; d < Dim; ++d) a[d] = 1.7 - 2.3 * d;
    return a;
}

template <int Dim>
void expectExactGradient(const Points<Dim>& points)
{
    const Cloud<Dim> cloud(points);
    const Vec<Dim> a = slopes<Dim>();
    int exactOnes = 0;
    for (Index i = 0; i < points.water; ++i) {
        if (smallestEigenvalue(cloud.moment(i, false)) < 0.25)
            continue;  // blended   [theory (2.9)]
        Vec<Dim> gradient;
        cloud.pairs.forAll(i, [&](const auto& pair) {
            gradient += (points.volume[pair.j] * dot(a, -pair.x_ij)) *
                        (cloud.corrections.L[i] * pair.gradW());
        });
        for (int d = 0; d < Dim; ++d) ASSERT_NEAR(gradient[d], a[d], 1e-12);
        ++exactOnes;
    }
    EXPECT_GT(exactOnes, points.water * 8 / 10);   // corners and shaken edges are left
}

TEST(Gradient, IsExactForALinearFieldOnJitteredParticles)
{
    expectExactGradient(shakenPoints<2>(14));
    expectExactGradient(shakenPoints<3>(9));
}

TEST(Gradient, IsExactForALinearFieldAlsoForUnequalWidths)
{
    Points<2> flat = shakenPoints<2>(14);
    Points<3> deep = shakenPoints<3>(9);
    varyWidths(flat), varyWidths(deep);
    expectExactGradient(flat);
    expectExactGradient(deep);
}

TEST(Gradient, OverWaterAloneIsExactToo)
{
    Points<2> points = shakenPoints<2>(14);   // the last rows of x are walls
    points.water = points.fluid = points.size() * 3 / 4;
    const Cloud<2> cloud(points);
    const Vec<2> a = slopes<2>();
    int exactOnes = 0;
    for (Index i = 0; i < points.water; ++i) {
        if (smallestEigenvalue(cloud.moment(i, true)) < 0.25) continue;
        Vec<2> gradient;
        cloud.pairs.forWater(i, [&](const auto& pair) {
            gradient += (points.volume[pair.j] * dot(a, -pair.x_ij)) *
                        (cloud.corrections.Lwater(i) * pair.gradW());
        });
        for (int d = 0; d < 2; ++d) ASSERT_NEAR(gradient[d], a[d], 1e-12);
        ++exactOnes;
    }
    EXPECT_GT(exactOnes, points.water * 8 / 10);
}

TEST(Corrections, WhatIsSeenOfALinearFieldIsAllOfItWhereTheInverseIsFull)
{
    const Cloud<3> cloud(shakenPoints<3>(8));
    for (Index i = 0; i < cloud.points.water; ++i) {
        const Mat<3> A = cloud.moment(i, false), product = cloud.corrections.L[i] * A;
        for (int r = 0; r < 3; ++r)
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(cloud.corrections.seen(i)[r][k], product[r][k], 1e-12);
                if (smallestEigenvalue(A) > 0.25) {
                    ASSERT_NEAR(product[r][k], r == k, 1e-12);
                }
            }
    }
}

TEST(BlendedInverse, IsTheInverseAboveAQuarter)
{
    Mat<2> A;
    A[0] = {0.9, 0.2}, A[1] = {0.2, 0.5};   // smallest eigenvalue 0.417
    const Mat<2> product = blendedInverse(A) * A;
    for (int r = 0; r < 2; ++r)
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(product[r][k], r == k, 1e-14);
}

TEST(BlendedInverse, IsTheIdentityBelowATenth)
{
    Mat<3> A = Mat<3>::identity();
    A[2][2] = 0.099;
    for (const Mat<3>& m : {A, Mat<3>{}})   // also where a particle is alone
        for (int r = 0; r < 3; ++r)
            for (int k = 0; k < 3; ++k) EXPECT_EQ(blendedInverse(m)[r][k], r == k);
}

TEST(BlendedInverse, GoesOverInProportion)
{
    Mat<2> A = Mat<2>::identity();
    A[1][1] = 0.175;   // halfway from 0.1 to 0.25
    EXPECT_NEAR(blendedInverse(A)[1][1], 0.5 / 0.175 + 0.5, 1e-13);
    EXPECT_NEAR(blendedInverse(A)[0][0], 1, 1e-14);
}

template <int Dim>
void expectAFullLatticeToBeSeenAsFull(int n)
{
    std::array<int, Dim> count;
    count.fill(n);
    Vec<Dim> max;
    for (int d = 0; d < Dim; ++d) max[d] = n;
    Points<Dim> points = shakenPoints<Dim>(n);
    points.x = lattice<Dim>({}, max, count);
    const Cloud<Dim> cloud(points);
    int inside = 0;
    for (Index i = 0; i < points.water; ++i) {
        bool whole = true;
        for (int d = 0; d < Dim; ++d) whole = whole && points.x[i][d] > 3 && points.x[i][d] < n - 3;
        if (!whole) continue;
        ++inside;
        EXPECT_NEAR(cloud.corrections.lambda[i], Dim, 0.01 * Dim);  // quadrature of a smooth kernel
        EXPECT_NEAR(cloud.corrections.filling[i], 1, 0.01);
        EXPECT_LT(norm(cloud.corrections.lopsided[i]), 1e-13);      // pairs cancel
    }
    EXPECT_GT(inside, 0);
}

TEST(Corrections, AFullLatticeIsFullAndNotLopsided)
{
    expectAFullLatticeToBeSeenAsFull<2>(10);
    expectAFullLatticeToBeSeenAsFull<3>(8);
}

template <int Dim>
std::vector<Real> strainRates(const Cloud<Dim>& cloud, const Mat<Dim>& gradU)
{
    std::vector<Vec<Dim>> u;
    for (const Vec<Dim>& x : cloud.points.x) u.push_back(gradU * x);
    std::vector<Real> rate;
    strainRate<Dim>(cloud.points, cloud.pairs, cloud.corrections, u, rate);
    return rate;
}

TEST(StrainRate, IsTheShearRateOfAShearFlowAndZeroInRotation)
{
    const Cloud<2> cloud(shakenPoints<2>(12));
    Mat<2> shear, rotation;
    shear[0] = {0, 3.5};
    rotation[0] = {0, 3.5}, rotation[1] = {-3.5, 0};
    const std::vector<Real> sheared = strainRates(cloud, shear),
                            rotating = strainRates(cloud, rotation);
    for (Index i = 0; i < cloud.points.water; ++i) {
        if (smallestEigenvalue(cloud.moment(i, true)) < 0.25) continue;
        ASSERT_NEAR(sheared[i], 3.5, 1e-11);   // linear field, 1e-12 of gradients of 3.5
        ASSERT_NEAR(rotating[i], 0, 1e-11);
    }
}

TEST(StrainRate, StretchingInThreeDimensionsCountsTwice)
{
    const Cloud<3> cloud(shakenPoints<3>(8));
    Mat<3> stretch;
    stretch[0][0] = 2, stretch[1][1] = -1, stretch[2][2] = -1;   // sqrt(2 S:S) = sqrt(12)
    const std::vector<Real> rate = strainRates(cloud, stretch);
    for (Index i = 0; i < cloud.points.water; ++i)
        if (smallestEigenvalue(cloud.moment(i, true)) > 0.25) {
            ASSERT_NEAR(rate[i], std::sqrt(12.0), 1e-11);
        }
}

}  // namespace
