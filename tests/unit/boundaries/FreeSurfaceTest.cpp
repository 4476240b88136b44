// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Roles by layers from the top: h = 1.5 d0 sees the rows within 3 d0, that is two below its own.
template <int Dim>
void expectRolesOfAFlatTank(Scene<Dim> scene, Real level)
{
    Timers timers;
    DragImplicitStep<Dim> step(scene, timers);
    step.look();
    int count[3] = {0, 0, 0};
    for (std::size_t i = 0; i < scene.water.size(); ++i) {
        const int row = static_cast<int>(level - scene.water.x[i][Dim - 1]);   // 0: the top
        const SurfaceRole role = step.fields().role[i];
        EXPECT_EQ(role, row == 0   ? SurfaceRole::surface
                        : row <= 2 ? SurfaceRole::near
                                   : SurfaceRole::inner)
            << "row " << row << ", lambda " << step.fields().corrections.lambda[i];
        ++count[static_cast<int>(role)];
    }
    for (const int c : count) EXPECT_GT(c, 0);
}

TEST(FreeSurface, OfAFlatTankIsItsTopRowAlsoAtTheWalls)
{
    expectRolesOfAFlatTank<2>(
        SceneBuilder<2>(1).water({0, 0}, {12, 8}).openTank({0, 0}, {12, 12}).build(), 8);
    expectRolesOfAFlatTank<3>(
        SceneBuilder<3>(1).water({0, 0, 0}, {7, 7, 7}).openTank({0, 0, 0}, {7, 7, 11}).build(), 7);
}

TEST(FreeSurface, OfAPeriodicTankIsItsTopRow)
{
    expectRolesOfAFlatTank<2>(
        SceneBuilder<2>(1)
            .water({0, 0}, {12, 8})
            .tank({0, 0}, {12, 12},
                  [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 12; })
            .periodic({0, 0}, {12, 12}, {true, false})
            .build(),
        8);
}

TEST(FreeSurface, IsNotFoundInAFullBox)
{
    Scene<2> scene = SceneBuilder<2>(1).water({0, 0}, {10, 10}).tank({0, 0}, {10, 10}).build();
    Timers timers;
    DragImplicitStep<2> step(scene, timers);
    step.look();
    for (const SurfaceRole role : step.fields().role) EXPECT_EQ(role, SurfaceRole::inner);
}

TEST(FreeSurface, IsAllOfASpray)
{
    Scene<3> scene =
        SceneBuilder<3>(1).particle({0, 0, 0}).particle({1, 0, 0}).particle({9, 0, 0}).build();
    Timers timers;
    DragImplicitStep<3> step(scene, timers);
    step.look();
    for (const SurfaceRole role : step.fields().role) EXPECT_EQ(role, SurfaceRole::surface);
}

/// A block of 7^Dim particles whose middle one of the upper side is pushed down by a share of the
/// spacing.
template <int Dim>
void expectDepth(Real depth)
{
    Vec<Dim> corner, middleOfTop;
    for (int d = 0; d < Dim; ++d) corner[d] = 7, middleOfTop[d] = d == Dim - 1 ? 6.5 : 3.5;
    Scene<Dim> scene = SceneBuilder<Dim>(1).water({}, corner).build();
    const Kernel& kernel = *scene.kernel;
    const FlatSurface flat = latticeSurface(kernel, Dim, scene.scheme.h0 / scene.scheme.spacing);
    std::size_t middle = 0;
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        if (norm(scene.water.x[i] - middleOfTop) < 0.1) middle = i;
    scene.water.x[middle][Dim - 1] -= depth;
    Timers timers;
    DragImplicitStep<Dim> step(scene, timers);
    step.look();
    const Real lambda = step.fields().corrections.lambda[middle];
    // From 0 exact; the rise slackens as the particle sinks.
    EXPECT_NEAR((lambda - flat.lambda) / flat.rise, depth, 1e-6 + 0.6 * sqr(depth))
        << Dim << " dimensions";
}

TEST(FreeSurface, TellsTheDepthOfAParticleBelowItsFirstRow)
{
    for (const Real depth : {0.0, 0.1, 0.3}) expectDepth<2>(depth), expectDepth<3>(depth);
}

/// How lambda of the first row of a tank answers when the water is drawn out along the surface by
/// `along`.
template <int Dim>
Real lambdaOfStretched(Real along, const FlatSurface& flat)
{
    Vec<Dim> corner, middleOfTop;
    for (int d = 0; d < Dim; ++d) corner[d] = 9, middleOfTop[d] = d == Dim - 1 ? 8.5 : 4.5;
    Scene<Dim> scene = SceneBuilder<Dim>(1).water({}, corner).build();
    std::size_t middle = 0;
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        if (norm(scene.water.x[i] - middleOfTop) < 0.1) middle = i;
    for (Vec<Dim>& x : scene.water.x) x[0] *= along, x[Dim - 1] /= along;
    Timers timers;
    DragImplicitStep<Dim> step(scene, timers);
    step.look();
    return (step.fields().corrections.lambda[middle] - flat.lambda) / flat.thickening;
}

template <int Dim>
void expectThickening()
{
    Scene<Dim> scene = SceneBuilder<Dim>(1).particle({}).build();
    const FlatSurface flat =
        latticeSurface(*scene.kernel, Dim, scene.scheme.h0 / scene.scheme.spacing);
    // Half a spacing above the centres is 1/0.99 and 1/1.01 times as high.
    const Real higher = 0.5 / 0.99 - 0.5 / 1.01;
    EXPECT_NEAR(lambdaOfStretched<Dim>(0.99, flat) - lambdaOfStretched<Dim>(1.01, flat), higher,
                1e-3 * higher)
        << Dim;
}

TEST(FreeSurface, TellsHowMuchHigherTheWaterAboveACompressedRowIs)
{
    expectThickening<2>(), expectThickening<3>();
}

constexpr FlatSurface kFlat{1.2, 0.6, 0.5};

/// p/rho0 of surface particles in a row, 2 apart, with these lambda, one normal and one force at
/// the new time.
std::vector<Real> pressuresAtSurface(const std::vector<Real>& lambda, const Vec<2>& normal,
                                     const Vec<2>& forceGradient)
{
    const std::size_t n = lambda.size();
    const Scene<2> scene = SceneBuilder<2>(1).particle({0, 0}).build();   // for its kernel
    Points<2> points;
    points.water = points.fluid = static_cast<Index>(n);
    Corrections<2> corrections;
    for (std::size_t i = 0; i < n; ++i) {
        points.x.push_back({2 * static_cast<Real>(i), 0});
        points.h.push_back(3);   // h0 = 1.5, d0 = 1: in soil of porosity 1/4
        points.volume.push_back(4);
        points.owner.push_back(static_cast<Index>(i));
    }
    PairList<2> pairs;
    pairs.build(points, *scene.kernel);
    corrections.lambda = lambda;
    corrections.lopsided.assign(n, normal);
    std::vector<Real> p;
    surfacePressure<2>(kFlat, 1 / 1.5, points, pairs, corrections,
                       std::vector<SurfaceRole>(n, SurfaceRole::surface),
                       std::vector<Vec<2>>(n, forceGradient), {0, -10}, p);
    return p;
}

Real pressureAtSurface(Real lambda, const Vec<2>& normal, const Vec<2>& forceGradient)
{
    return pressuresAtSurface({lambda}, normal, forceGradient)[0];
}

TEST(FreeSurface, CarriesTheWaterAboveTheCentresOfItsParticles)
{
    const Vec<2> up{0, 3}, down{0, -3}, aside{3, 0}, still{0, 0}, falls{0, 10};
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.2, up, still), 10);       // half a local spacing of 2
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.45, up, still), 20);      // another half spacing deep
    EXPECT_EQ(pressureAtSurface(0.9, up, still), 0);               // a crest
    EXPECT_EQ(pressureAtSurface(1.5, up, falls), 0);               // in free fall
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.2, down, still),
                     -10);  // what hangs from water pulls at it
    EXPECT_EQ(pressureAtSurface(1.5, aside, still), 0);
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.2, up, {0, -5}), 15);     // thrown up, as at an impact
}

TEST(FreeSurface, CarriesAllOfTheMeanAndAQuarterOfTheRest)
{
    const Real step = 0.01;
    const Vec<2> up{0, 3}, still{0, 0};
    const auto even = pressuresAtSurface(std::vector<Real>(9, 1.2 + step), up, still);
    EXPECT_NEAR(even[4], 10 + 20 * step / kFlat.thickening, 1e-12);
    std::vector<Real> uneven(9, 1.2);
    for (std::size_t i = 0; i < uneven.size(); i += 2) uneven[i] += step;
    const auto p = pressuresAtSurface(uneven, up, still);
    // A mean that sees the row only: of the alternation less than a fifth is left in it.
    const Real rough = 20 * 0.25 * step / kFlat.rise;
    EXPECT_GT(p[4] - p[3], rough);
    EXPECT_LT(p[4] - p[3], rough + 0.2 * 20 * step / kFlat.thickening);
}

}  // namespace
