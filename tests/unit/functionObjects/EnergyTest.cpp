// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include "core/Parallel.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {
FlowView fallingBlock(Real speed)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    setVelocity(flow, [&](const Vector3&) { return Vector3{0, -speed, 0}; });
    return flow;
}
}  // namespace

TEST(Energy, OfAFallingBlockIsThatOfItsMassAndCentre)
{
    const Real mass = 1000 * 0.2 * 0.1;
    const std::vector<Real> row = make("type energy;")->measure(fallingBlock(2));
    EXPECT_NEAR(row[0], 0.5 * mass * 4, 1e-12 * row[0]);
    EXPECT_NEAR(row[1], mass * 9.81 * 0.05, 1e-12 * row[1]);
    EXPECT_NEAR(row[2], row[0] + row[1], 1e-12 * row[2]);
    EXPECT_EQ(row[3], 0);
    EXPECT_NEAR(row[4], mass * 9.81 * 2, 1e-12 * row[4]);
    EXPECT_NEAR(row[5], 2, 1e-15);
}

TEST(Energy, ChangesSinceTheStartAlsoThroughARestart)
{
    auto first = make("type energy;"), second = make("type energy;");
    const std::vector<Real> start = first->measure(fallingBlock(0));
    const std::vector<Real> later = first->measure(fallingBlock(1));
    EXPECT_NEAR(later[3], later[0], 1e-12);
    second->resume(start);
    EXPECT_EQ(second->measure(fallingBlock(1)), later);
}

TEST(Energy, IsTheSameForAnyNumberOfThreads)
{
    Tank tank;
    tank.spacing = 0.002;
    FlowView flow = emptyTank(tank);
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    setVelocity(flow, [](const Vector3& x) {
        return Vector3{std::sin(40 * x[0]), std::cos(30 * x[1]), 0};
    });
    setThreadCount(1);
    const std::vector<Real> one = make("type energy;")->measure(flow),
                            oneVolume = make("type volume;")->measure(flow);
    setThreadCount(4);
    EXPECT_EQ(make("type energy;")->measure(flow), one);
    EXPECT_EQ(make("type volume;")->measure(flow), oneVolume);
    setThreadCount(1);
}
