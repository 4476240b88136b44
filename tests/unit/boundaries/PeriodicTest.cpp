// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "core/Error.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace isph;

namespace {

template <int Dim>
PeriodicBox<Dim> unitBox(Real length)
{
    PeriodicBox<Dim> box;
    for (int d = 0; d < Dim; ++d) box.min[d] = -1, box.max[d] = length - 1, box.periodic[d] = true;
    return box;
}

TEST(PeriodicBox, WrapsIntoTheBoxAndLeavesOtherDirectionsAlone)
{
    PeriodicBox<2> box = unitBox<2>(10);
    box.periodic[1] = false;
    EXPECT_EQ(box.wrap({9.5, 50}), (Vec<2>{-0.5, 50}));
    EXPECT_EQ(box.wrap({-1.5, -50}), (Vec<2>{8.5, -50}));
    EXPECT_EQ(box.wrap({3, 3}), (Vec<2>{3, 3}));
    EXPECT_EQ(box.wrap({29.5, 0})[0], -0.5);   // more than one period away
}

TEST(PeriodicBox, NeverWrapsOntoItsUpperEnd)
{
    const PeriodicBox<2> box = unitBox<2>(10);
    for (const Real x : {9.0, -1 - 1e-17, -1 - 1e-16, -1 - 2e-16, std::nextafter(-1.0, -2.0)}) {
        EXPECT_LT(box.wrap({x, 0})[0], 9.0) << x;
        EXPECT_GE(box.wrap({x, 0})[0], -1.0) << x;
    }
}

template <int Dim>
std::size_t imagesOf(const PeriodicBox<Dim>& box, const Vec<Dim>& x, Real reach)
{
    std::size_t n = 0;
    box.forImages(x, reach, [&](const Vec<Dim>& shift) {
        bool outside = false;
        for (int d = 0; d < Dim; ++d) {
            const Real image = x[d] + shift[d];
            EXPECT_GT(image, box.min[d] - reach);
            EXPECT_LT(image, box.max[d] + reach);
            outside = outside || image < box.min[d] || image >= box.max[d];
        }
        EXPECT_TRUE(outside);
        ++n;
    });
    return n;
}

TEST(PeriodicBox, ImagesStandBesideSidesEdgesAndCorners)
{
    EXPECT_EQ(imagesOf(unitBox<2>(10), {4, 4}, 2), 0u);
    EXPECT_EQ(imagesOf(unitBox<2>(10), {-0.5, 4}, 2), 1u);
    EXPECT_EQ(imagesOf(unitBox<2>(10), {-0.5, 8.5}, 2), 3u);
    EXPECT_EQ(imagesOf(unitBox<3>(10), {-0.5, 8.5, 4}, 2), 3u);
    EXPECT_EQ(imagesOf(unitBox<3>(10), {-0.5, 8.5, 8.5}, 2), 7u);
}

TEST(PeriodicBox, APeriodShorterThanTwoSupportsIsRefused)
{
    EXPECT_NO_THROW(unitBox<2>(10).requireLength(5));
    EXPECT_THROW(unitBox<2>(10).requireLength(5.01), FatalError);
}

/// Distance of the nearest of all copies, direction by direction.
template <int Dim>
Real nearestCopy(const PeriodicBox<Dim>& box, const Vec<Dim>& a, const Vec<Dim>& b)
{
    Vec<Dim> r = a - b;
    for (int d = 0; d < Dim; ++d)
        if (box.periodic[d]) r[d] -= box.length(d) * std::round(r[d] / box.length(d));
    return norm(r);
}

template <int Dim>
void expectImagesToStandForTheNearestCopies(int n, const std::array<bool, Dim>& directions)
{
    PeriodicBox<Dim> box;
    box.periodic = directions;
    for (int d = 0; d < Dim; ++d) box.max[d] = n;
    Water<Dim> water;
    water.x = shakenPoints<Dim>(n).x;
    for (Vec<Dim>& x : water.x) x = box.wrap(x);
    water.resize(water.x.size());
    std::vector<Real> porosity(water.size());
    for (std::size_t i = 0; i < porosity.size(); ++i)
        porosity[i] = 0.5 + 0.5 * static_cast<Real>(i % 7) / 6;
    Points<Dim> points;
    const Real h0 = 1, support = 2;
    layPoints<Dim>(water, porosity, WallCloud<Dim>{}, box, 1, h0, support, points);
    PairList<Dim> pairs;
    pairs.build(points, *kernelNamed("wendlandC2"));
    for (Index i = 0; i < points.water; ++i) {
        std::multiset<Index> found, expected;
        pairs.forAll(i, [&](const auto& pair) { found.insert(points.owner[pair.j]); });
        for (Index j = 0; j < points.water; ++j)
            if (j != i && nearestCopy(box, water.x[i], water.x[j]) <
                              support * (points.h[i] + points.h[j]) / 2)
                expected.insert(j);
        ASSERT_EQ(found, expected) << "particle " << i;
    }
}

TEST(PeriodicImages, EveryNearestCopyIsAPartnerExactlyOnce)
{
    expectImagesToStandForTheNearestCopies<2>(12, {true, true});
    expectImagesToStandForTheNearestCopies<2>(12, {true, false});
    expectImagesToStandForTheNearestCopies<3>(8, {true, true, true});
    expectImagesToStandForTheNearestCopies<3>(8, {false, true, false});
}

TEST(PeriodicImages, CarryVolumeWidthAndFieldsOfTheirOwners)
{
    PeriodicBox<2> box = unitBox<2>(12);
    Water<2> water;
    water.x = {{-0.9, 5}, {5, 5}};
    water.resize(2);
    const std::vector<Real> porosity = {0.25, 1};
    Points<2> points;
    layPoints<2>(water, porosity, WallCloud<2>{}, box, 1, 1.5, 2, points);
    ASSERT_EQ(points.images(), 1);
    EXPECT_EQ(points.x[2], (Vec<2>{11.1, 5}));
    EXPECT_EQ(points.owner[2], 0);
    EXPECT_EQ(points.volume[2], 4);   // d0^2/eps
    EXPECT_EQ(points.h[2], 3);        // h0/sqrt(eps)
    std::vector<Real> field = {7, 8, 0};
    points.refresh(field);
    EXPECT_EQ(field[2], 7);
}

}  // namespace
