// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Scatter.hpp"

#include <gtest/gtest.h>

#include <map>

using namespace isph;

namespace {

template <int Dim>
std::vector<Index> byBruteForce(const Points<Dim>& points, Real support, Index i)
{
    std::vector<Index> partners;
    for (Index j = 0; j < points.size(); ++j)
        if (j != i && norm(points.x[i] - points.x[j]) < support * (points.h[i] + points.h[j]) / 2)
            partners.push_back(j);
    return partners;
}

template <int Dim>
void expectRowsAsByBruteForce(const Points<Dim>& points, const Kernel& kernel)
{
    PairList<Dim> pairs;
    pairs.build(points, kernel);
    PairIndex all = 0;
    for (Index i = 0; i < points.water; ++i) {
        std::vector<Index> row;
        pairs.forAll(i, [&](const auto& pair) { row.push_back(pair.j); });
        const std::vector<Index> expected = byBruteForce(points, kernel.supportRadius(), i);
        ASSERT_EQ(row, expected) << "row " << i;
        all += static_cast<PairIndex>(row.size());
        pairs.forWater(i, [&](const auto& pair) { ASSERT_LT(pair.j, points.fluid); });
        pairs.forWalls(i, [&](const auto& pair) { ASSERT_GE(pair.j, points.fluid); });
    }
    EXPECT_EQ(pairs.size(), all);
}

/// The last points of the block stand for images and walls.
template <int Dim>
Points<Dim> withImagesAndWalls(int n)
{
    Points<Dim> points = shakenPoints<Dim>(n);
    points.water = points.size() * 6 / 10;
    points.fluid = points.size() * 8 / 10;
    return points;
}

TEST(PairList, IsThatOfBruteForceOnJitteredPoints)
{
    for (const char* name : {"wendlandC2", "quinticSpline"}) {   // supports of 2 h and 3 h
        const auto kernel = kernelNamed(name);
        expectRowsAsByBruteForce(shakenPoints<2>(15), *kernel);
        expectRowsAsByBruteForce(shakenPoints<3>(8), *kernel);
    }
}

TEST(PairList, IsThatOfBruteForceForUnequalWidths)
{
    const auto kernel = kernelNamed("wendlandC2");
    Points<2> flat = shakenPoints<2>(15);
    Points<3> deep = shakenPoints<3>(8);
    varyWidths(flat), varyWidths(deep);
    expectRowsAsByBruteForce(flat, *kernel);
    expectRowsAsByBruteForce(deep, *kernel);
}

TEST(PairList, TellsWaterAndItsImagesFromWalls)
{
    const auto kernel = kernelNamed("wendlandC2");
    expectRowsAsByBruteForce(withImagesAndWalls<2>(15), *kernel);
    expectRowsAsByBruteForce(withImagesAndWalls<3>(8), *kernel);
}

template <int Dim>
void expectBothSidesOfAPairToAgree(Points<Dim> points)
{
    varyWidths(points);
    PairList<Dim> pairs;
    pairs.build(points, *kernelNamed("wendlandC2"));
    std::map<std::pair<Index, Index>, std::pair<Real, Real>> value;
    for (Index i = 0; i < points.water; ++i)
        pairs.forAll(i, [&](const auto& pair) { value[{i, pair.j}] = {pair.W, pair.slope}; });
    ASSERT_FALSE(value.empty());
    for (const auto& [ij, both] : value) {
        const auto ji = value.find({ij.second, ij.first});
        ASSERT_NE(ji, value.end());
        ASSERT_EQ(both, ji->second);   // the same operations in the same order
    }
}

TEST(PairList, KernelAndSlopeAreTheSameFromBothSides)
{
    expectBothSidesOfAPairToAgree(shakenPoints<2>(12));
    expectBothSidesOfAPairToAgree(shakenPoints<3>(6));
}

TEST(PairList, HoldsTheKernelOfTheMeanWidth)
{
    const auto kernel = kernelNamed("wendlandC4");
    Points<3> points = shakenPoints<3>(5);
    varyWidths(points);
    PairList<3> pairs;
    pairs.build(points, *kernel);
    for (Index i = 0; i < points.water; ++i)
        pairs.forAll(i, [&](const auto& pair) {
            const Real h = (points.h[i] + points.h[pair.j]) / 2;
            const Real q = norm(points.x[i] - points.x[pair.j]) / h;
            Real w = 0, slope = 0;
            kernel->evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
            const Real scale = kernel->normalisation(3) / cube(h);
            // The same algebra, values below 0.5, rounded to single precision (half of 2^-23).
            ASSERT_NEAR(pair.W, w * scale, 1e-14 + 6e-8 * w * scale);
            ASSERT_NEAR(pair.slope, slope * scale / sqr(h), 1e-14 + 6e-8 * std::abs(slope) * scale / sqr(h));
            ASSERT_EQ(pair.x_ij, points.x[i] - points.x[pair.j]);
        });
}

TEST(PairList, IsTheSameForOneAndThreeThreads)
{
    const auto kernel = kernelNamed("wendlandC2");
    const Points<2> points = shakenPoints<2>(60);   // 14 blocks of rows
    std::vector<Index> list[2];
    const int before = threadCount();
    for (const int k : {0, 1}) {
        setThreadCount(k == 0 ? 1 : 3);
        PairList<2> pairs;
        pairs.build(points, *kernel);
        for (Index i = 0; i < points.water; ++i)
            pairs.forAll(i, [&](const auto& pair) { list[k].push_back(pair.j); });
    }
    setThreadCount(before);
    EXPECT_EQ(list[0], list[1]);
}

}  // namespace
