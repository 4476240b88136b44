// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace isph;
using namespace isph::test;

namespace {

std::vector<Real> levels(const FlowView& flow, const std::string& keys)
{
    return make("type waterLevel; " + keys)->measure(flow);
}

const std::string kAcross =
    "line { start (0 0 0); end (0.2 0 0); n 41; }";  // wall to wall, every d0/2

}  // namespace

TEST(WaterLevel, OfStillWaterIsATenthOfTheSpacingRightFromWallToWallForEveryKernelAndOffset)
{
    // The lattice's own level is known: half a spacing above its top row. The kernel sums of a
    // lattice ripple by some per cent, which the slope of the sum at the surface, about 0.7/d0,
    // turns into 0.05 d0.
    for (const std::string kernel : {"wendlandC2", "wendlandC4", "cubicSpline", "quinticSpline"})
        for (const Real offset : {0.0, 0.2, 0.5, 0.8}) {
            Tank tank;
            tank.kernel = kernel;
            tank.smoothingRatio = kernel == "quinticSpline" ? 1.2 : 1.5;
            FlowView flow = emptyTank(tank);
            const Real level = 0.1 + offset * tank.spacing;
            addWater(flow, {0, offset * tank.spacing, 0}, {0.2, level, 0});
            for (const Real z : levels(flow, kAcross))
                EXPECT_NEAR(z, level, 0.1 * tank.spacing)
                    << kernel << " moved by " << offset << " d0";
        }
}

TEST(WaterLevel, InSoilIsHalfALocalSpacingAboveTheTopRowAlsoBesideClearWater)
{
    FlowView flow = emptyTank({});
    const Real local = flow.spacing / std::sqrt(0.4);
    addWater(flow, {0, 0, 0}, {0.2, 6 * local, 0}, 0.4);
    for (const Real z : levels(flow, "line { start (0.03 0 0); end (0.17 0 0); n 30; }"))
        EXPECT_NEAR(z, 6 * local, 0.1 * flow.spacing);
    // Beside clear water: porosity 0.36 makes 6 local spacings fill what 10 of clear water do.
    // Where kernels of two widths meet, their sum is off by some per cent.
    flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.1, 0.1, 0}, 0.36);
    addWater(flow, {0.1, 0, 0}, {0.2, 0.1, 0});
    for (const Real z : levels(flow, "line { start (0.03 0 0); end (0.17 0 0); n 30; }"))
        EXPECT_NEAR(z, 0.1, 0.25 * flow.spacing);
}

TEST(WaterLevel, InThreeDimensionsAndInATurnedTankIsTheElevationAgainstGravity)
{
    Tank tank;
    tank.dimension = 3;
    tank.length = tank.width = tank.height = 0.12;
    FlowView flow = emptyTank(tank);
    addWater(flow, {0, 0, 0}, {0.12, 0.07, 0.12});
    for (const Real angle : {0.0, 0.5}) {
        turn(flow, angle);
        const auto at = [&](Real x, Real z) {
            const Vector3 point = turned({x, 0.3, z}, angle);  // any height on the vertical
            return fmt::format("({} {} {})", point[0], point[1], point[2]);
        };
        for (const Real z : levels(
                 flow, "at (" + at(0.06, 0.06) + at(0, 0.06) + at(0, 0) + at(0.033, 0.111) + ");"))
            EXPECT_NEAR(z, 0.07, 0.1 * tank.spacing);
    }
}

TEST(WaterLevel, FindsTheLayerOfTwoAndAHalfSpacingsBesideADam)
{
    // Tail water of the porous dam break: 25 mm at a spacing of 10 mm, as two rows and as three.
    for (const Real top : {0.02, 0.03}) {
        FlowView flow = emptyTank({});
        addWater(flow, {0, 0, 0}, {0.2, top, 0});
        for (const Real z : levels(flow, kAcross)) EXPECT_NEAR(z, top, 0.1 * flow.spacing);
    }
}

TEST(WaterLevel, OfALayerOfOneParticleOnTheFloorIsItsSpacing)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.01, 0});
    for (const Real z : levels(flow, kAcross)) EXPECT_NEAR(z, 0.01, 0.1 * flow.spacing);
}

TEST(WaterLevel, IgnoresDropsAboveTheSurfaceUnlessAskedForThem)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    addWater(flow, {0.04, 0.2, 0}, {0.05, 0.21, 0});  // one particle
    addWater(flow, {0.09, 0.2, 0}, {0.11, 0.22, 0});  // two by two
    const std::string at = "at ((0.045 0) (0.1 0)); ";
    for (const Real z : levels(flow, at)) EXPECT_NEAR(z, 0.1, 0.1 * flow.spacing);
    const std::vector<Real> withDrops = levels(flow, at + "minimumDepth 0;");
    EXPECT_NEAR(withDrops[0], 0.1,
                0.1 * flow.spacing);  // one particle alone never fills half a kernel
    EXPECT_GT(withDrops[1], 0.2);
    EXPECT_LT(withDrops[1], 0.22);
}

TEST(WaterLevel, CountsASheetOfWaterOffTheWallsFromTheMinimumDepthOn)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.05, 0});
    addWater(flow, {0, 0.15, 0}, {0.2, 0.19, 0});  // four rows
    EXPECT_NEAR(levels(flow, "at ((0.1 0));")[0], 0.19, 0.1 * flow.spacing);
    EXPECT_NEAR(levels(flow, "at ((0.1 0)); minimumDepth 6;")[0], 0.05, 0.1 * flow.spacing);
}

TEST(WaterLevel, OfADryColumnIsTheFloorOrTheLevelThatTheDictionaryNames)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.05, 0.1, 0});
    for (const Real z : levels(flow, "at ((0.15 0) (0.195 0) (0.2 0));"))  // also in the corner
        EXPECT_NEAR(z, 0, 0.1 * flow.spacing);
    EXPECT_EQ(levels(flow, "at ((0.15 0)); dryLevel -1;")[0], -1);
    flow.wallPosition.clear();
    flow.wallVolume.clear();
    EXPECT_EQ(levels(flow, "at ((0.15 0));")[0], flow.position[0][1]);
}

TEST(WaterLevel, RefusesAFlowWithoutGravityUnlessTheUpwardDirectionIsGiven)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    flow.gravity = {};
    EXPECT_THROW(levels(flow, "at ((0.1 0));"), FatalIOError);
    EXPECT_NEAR(levels(flow, "at ((0.1 0)); direction (0 2 0);")[0], 0.1, 0.1 * flow.spacing);
}

TEST(WaterLevel, NeedsEitherPointsOrALine)
{
    EXPECT_THROW(make("type waterLevel;"), FatalIOError);
    EXPECT_THROW(make("type waterLevel; at ((0 0)); " + kAcross), FatalIOError);
    EXPECT_THROW(make("type waterLevel; line { start (0 0 0); end (1 0 0); m 3; }"), FatalIOError);
}
