// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Scatter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

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
            ASSERT_NEAR(pair.slope, slope * scale / sqr(h),
                        1e-14 + 6e-8 * std::abs(slope) * scale / sqr(h));
            ASSERT_EQ(pair.x_ij, points.x[i] - points.x[pair.j]);
        });
}

/// Points in the order of the cells of a search, but for a few that have changed places.
Points<2> nearlySorted(Points<2> points, const Kernel& kernel)
{
    CellGrid<2> grid;
    PairList<2>::binByCells(points.x, kernel.supportRadius() * points.h[0], grid);
    std::vector<Vec<2>> x;
    for (const Index j : grid.order()) x.push_back(points.x[j]);
    for (std::size_t i = 0; i + 40 < x.size(); i += 37) std::swap(x[i], x[i + 40]);
    points.x = x;
    return points;
}

TEST(PairList, IsThatOfBruteForceWhereAFewHaveChangedCells)
{
    const auto kernel = kernelNamed("wendlandC2");
    expectRowsAsByBruteForce(nearlySorted(shakenPoints<2>(15), *kernel), *kernel);
    Points<2> unequal = nearlySorted(shakenPoints<2>(15), *kernel);
    varyWidths(unequal);
    expectRowsAsByBruteForce(unequal, *kernel);
}

/// One h has a search of its own; a narrower particle far away makes it the search for many, of the
/// same pairs.
template <int Dim>
void expectNothingOfANarrowPointFarAway(const Points<Dim>& points)
{
    const auto kernel = kernelNamed("wendlandC2");
    Points<Dim> more = points;
    more.x.push_back(Vec<Dim>{} + 100.0 * points.x[points.size() / 2]);
    more.h.push_back(0.5 * points.h[0]), more.volume.push_back(1),
        more.owner.push_back(more.water++);
    more.fluid = more.water;
    PairList<Dim> alone, beside;
    alone.build(points, *kernel), beside.build(more, *kernel);
    ASSERT_EQ(alone.size(), beside.size());
    for (Index i = 0; i < points.water; ++i) {
        std::vector<std::tuple<Index, Real, Real>> row, other;
        alone.forAll(i, [&](const auto& pair) { row.emplace_back(pair.j, pair.W, pair.slope); });
        beside.forAll(i, [&](const auto& pair) { other.emplace_back(pair.j, pair.W, pair.slope); });
        ASSERT_EQ(row, other) << "row " << i;   // the same bits
        ASSERT_EQ(alone.nearest(i), beside.nearest(i));
    }
}

TEST(PairList, OfOneWidthIsThatOfMany)
{
    expectNothingOfANarrowPointFarAway(shakenPoints<2>(12));
    expectNothingOfANarrowPointFarAway(shakenPoints<3>(6));
}

TEST(PairList, EightAtATimeAreTheSamePairsAndIdlePlacesAddNothing)
{
    const Points<2> points = withImagesAndWalls<2>(15);
    PairList<2> pairs;
    pairs.build(points, *kernelNamed("wendlandC2"));
    using List = std::vector<std::tuple<Index, Real, Real>>;
    for (Index i = 0; i < points.water; ++i) {
        List one, eight;
        std::size_t read = 0;
        pairs.forAll(i, [&](const auto& pair) { one.emplace_back(pair.j, pair.W, pair.slope); });
        const auto take = [&](const PairLanes& lanes) {
            for (int l = 0; l < kLanes; ++l, ++read) {
                const bool idle = lanes.W[l] == 0 && lanes.slope[l] == 0;
                if (idle) ASSERT_EQ(lanes.j[l], i);
                else eight.emplace_back(lanes.j[l], lanes.W[l], lanes.slope[l]);
            }
        };
        pairs.forWaterLanes(i, take), pairs.forWallLanes(i, take);
        ASSERT_EQ(one, eight) << "row " << i;
        ASSERT_EQ(read % kLanes, 0U);
    }
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
