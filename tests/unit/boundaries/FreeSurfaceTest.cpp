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
        EXPECT_EQ(role, row == 0 ? SurfaceRole::surface : row <= 2 ? SurfaceRole::near : SurfaceRole::inner)
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
        SceneBuilder<2>(1).water({0, 0}, {12, 8})
            .tank({0, 0}, {12, 12}, [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 12; })
            .periodic({0, 0}, {12, 12}, {true, false}).build(), 8);
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
    Scene<3> scene = SceneBuilder<3>(1).particle({0, 0, 0}).particle({1, 0, 0}).particle({9, 0, 0}).build();
    Timers timers;
    DragImplicitStep<3> step(scene, timers);
    step.look();
    for (const SurfaceRole role : step.fields().role) EXPECT_EQ(role, SurfaceRole::surface);
}

/// A block of 7^Dim particles whose middle one of the upper side is pushed down by a share of the spacing.
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
    EXPECT_NEAR((lambda - flat.lambda) / flat.rise, depth, 1e-6 + 0.6 * sqr(depth)) << Dim << " dimensions";
}

TEST(FreeSurface, TellsTheDepthOfAParticleBelowItsFirstRow)
{
    for (const Real depth : {0.0, 0.1, 0.3}) expectDepth<2>(depth), expectDepth<3>(depth);
}

/// One surface particle with the given lambda, normal and force of the last step; g points down.
Real pressureAtSurface(Real lambda, const Vec<2>& normal, const Vec<2>& forceGradient)
{
    Points<2> points;
    points.water = points.fluid = 1;
    points.h = {3};   // h0 = 1.5, d0 = 1: in soil of porosity 1/4
    Corrections<2> corrections;
    corrections.lambda = {lambda};
    corrections.lopsided = {normal};
    std::vector<Real> p;
    surfacePressure<2>({1.2, 0.6}, 1 / 1.5, points, corrections, {SurfaceRole::surface},
                       std::vector<Vec<2>>{forceGradient}, {0, -10}, p);
    return p[0];
}

TEST(FreeSurface, CarriesTheWaterAboveAParticleBetweenTheRows)
{
    const Vec<2> up{0, 3}, down{0, -3}, aside{3, 0}, still{0, 0}, falls{0, 10};
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.5, up, still), 7.5);      // half a local spacing of 2 deep
    EXPECT_EQ(pressureAtSurface(1.2, up, still), 0);               // of the first row
    EXPECT_EQ(pressureAtSurface(0.9, up, still), 0);               // a crest
    EXPECT_EQ(pressureAtSurface(1.5, up, falls), 0);               // in free fall
    EXPECT_EQ(pressureAtSurface(1.5, down, still), 0);             // a ceiling drips
    EXPECT_EQ(pressureAtSurface(1.5, aside, still), 0);
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.5, up, {0, -5}), 11.25);     // thrown up, as at an impact
    EXPECT_DOUBLE_EQ(pressureAtSurface(1.5, up, {0, -500}), 15);   // no more than |g| of it
}

}  // namespace
