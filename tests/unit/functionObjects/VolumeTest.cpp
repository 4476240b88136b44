// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"
#include "core/Parallel.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {

struct Measured {
    Real grid, spray, particles, difference, differenceWithSpray;
};

Measured volume(const FlowView& flow)
{
    const std::vector<Real> row = make("type volume;")->measure(flow);
    return {row[0], row[1], row[2], row[3], row[4]};
}

}  // namespace

TEST(Volume, OfAFlatTankTwentySpacingsDeepIsHalfAPerCentRightForEveryOffsetOfTheGrid)
{
    for (const Real offset : {0.0, 0.13, 0.25, 0.4}) {
        FlowView flow = emptyTank({});
        addWater(flow, {0, 0, 0}, {0.2, 0.2, 0});
        for (auto* points : {&flow.position, &flow.wallPosition})
            for (Vector3& x : *points)
                x = {x[0] + 1.7 * offset * flow.spacing, x[1] + offset * flow.spacing, 0};
        const Measured v = volume(flow);
        EXPECT_NEAR(v.particles, 0.04, 1e-12);
        EXPECT_NEAR(v.grid / 0.04, 1, 0.005) << "moved by " << offset << " d0";
        EXPECT_EQ(v.spray, 0);
        EXPECT_NEAR(v.difference, (v.grid - v.particles) / v.particles, 1e-15);
    }
}

TEST(Volume, OfATurnedTankIsHalfAPerCentRight)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.2, 0});
    turn(flow, 0.52);
    EXPECT_NEAR(volume(flow).difference, 0, 0.005);
}

TEST(Volume, InSoilCountsThePores)
{
    // Water over a layer of soil: the lattices of both have their own spacing, so the face between
    // them is half a local spacing from the rows on both sides.
    FlowView flow = emptyTank({});
    const Real local = flow.spacing / std::sqrt(0.4);
    const Real wide = 12 * local;
    addWater(flow, {0, 0, 0}, {wide, 6 * local, 0}, 0.4);
    flow.porosityAt = [face = 6 * local](const Vector3& x) { return x[1] < face ? 0.4 : 1.0; };
    addWater(flow, {0, 6 * local, 0}, {wide, 6 * local + 0.1, 0});
    flow.wallPosition.clear();
    flow.wallVolume.clear();
    flow.periodic = {true, false, false};
    flow.domainMax = {wide, 1, 0};
    const Real exact = wide * (0.4 * 6 * local + 0.1);
    EXPECT_NEAR(volume(flow).grid / exact, 1, 0.005);
}

TEST(Volume, InThreeDimensionsIsHalfAPerCentRightForATankOfTwentySpacings)
{
    Tank tank;
    tank.dimension = 3;
    tank.height = 0.22;
    FlowView flow = emptyTank(tank);
    addWater(flow, {0, 0, 0}, {0.2, 0.2, 0.2});
    EXPECT_NEAR(volume(flow).difference, 0, 0.005);
}

TEST(Volume, OneAndFourThreadsAgreeBitForBit)
{
    FlowView flow =
        emptyTank({.dimension = 3, .spacing = 0.1, .length = 1, .width = 0.6, .height = 1});
    addWater(flow, {0, 0, 0}, {1, 0.6, 0.6}, 1);
    jitter(flow, 0.2);
    const int before = threadCount();
    setThreadCount(1);
    const Measured one = volume(flow);
    setThreadCount(4);
    const Measured four = volume(flow);
    setThreadCount(before);
    EXPECT_EQ(one.grid, four.grid);
    EXPECT_EQ(one.spray, four.spray);
}

TEST(Volume, SeesWaterThatSpreadsByAPerCent)
{
    // What the measure is for: particles that stand 1 % too far apart in each direction.
    FlowView flow = emptyTank({});
    flow.wallPosition.clear();
    flow.wallVolume.clear();
    addWater(flow, {0, 0, 0}, {0.4, 0.4, 0});
    const Real before = volume(flow).grid;
    for (Vector3& x : flow.position) x = {1.01 * x[0], 1.01 * x[1], 0};
    EXPECT_NEAR(volume(flow).grid / before, 1.0201, 0.003);
}

TEST(Volume, IsZeroOnADryFloorAndCountsLoneParticlesAsSpray)
{
    Tank tank;
    for (const Real offset : {0.0, 0.003, 0.005}) {
        FlowView flow = emptyTank(tank);
        for (Vector3& x : flow.wallPosition) x[1] += offset;
        flow.position = {{0.05, 0.1, 0}, {0.15, 0.2, 0}};
        flow.porosity = {1, 1};
        const Measured v = volume(flow);
        EXPECT_EQ(v.grid, 0);
        EXPECT_NEAR(v.spray, 2e-4, 1e-15);
        EXPECT_NEAR(v.differenceWithSpray, 0, 1e-12);
        EXPECT_EQ(v.difference, -1);
    }
}

TEST(Volume, OfNoWaterIsZero)
{
    const Measured v = volume(emptyTank({}));
    EXPECT_EQ(v.grid, 0);
    EXPECT_EQ(v.difference, 0);
}
