// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/KernelField.hpp"

#include "TestFlow.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isph;
using namespace isph::test;

TEST(FlowView, AParticleInSoilOccupiesItsMassOverPorosityAndIsSmoothedInProportion)
{
    for (const int dimension : {2, 3}) {
        FlowView flow;
        flow.dimension = dimension;
        flow.spacing = 0.01;
        flow.density = 1000;
        flow.smoothingRatio = 1.5;
        flow.porosity = {1, 0.4};
        EXPECT_NEAR(flow.particleMass(), 1000 * std::pow(0.01, dimension), 1e-18);
        EXPECT_NEAR(flow.occupiedVolume(1) * 0.4 * flow.density, flow.particleMass(), 1e-15);
        EXPECT_NEAR(flow.smoothingLength(0), 0.015, 1e-17);
        EXPECT_NEAR(flow.occupiedVolume(1) / flow.occupiedVolume(0),
                    std::pow(flow.smoothingLength(1) / flow.smoothingLength(0), dimension), 1e-12);
    }
}

TEST(KernelField, SharesOfWaterAndWallSumToOneAndTheirGradientsAreTheirSlopes)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    const KernelField field(flow);
    const Vec<3> beside{{0.003, 0.004, 0}}, surface{{0.1, 0.098, 0}};
    EXPECT_NEAR(field.shares(beside).water + field.shares(beside).wall, 1,
                0.02);  // of a lattice sum
    for (const Vec<3>& x : {beside, surface})
        for (int d = 0; d < 2; ++d) {
            Vec<3> step{};
            step[d] = 1e-6;
            const Shares a = field.shares(x - step), b = field.shares(x + step),
                         at = field.shares(x);
            EXPECT_NEAR((b.water - a.water) / 2e-6, at.waterGradient[d],
                        1e-4);  // central difference, O(step^2)
            EXPECT_NEAR((b.wall - a.wall) / 2e-6, at.wallGradient[d], 1e-4);
        }
}

TEST(KernelField, GathersWhatEveryParticleAskedInTurnWouldGive)
{
    FlowView flow =
        emptyTank({.dimension = 3, .spacing = 0.1, .length = 1, .width = 0.6, .height = 1});
    addWater(flow, {0, 0, 0}, {0.5, 0.6, 0.6}, 1);
    addWater(flow, {0.5, 0, 0}, {1, 0.6, 0.6}, 0.4);  // wider kernels in soil
    jitter(flow, 0.3);
    const KernelField field(flow);
    KernelSamples samples;
    for (const Vec<3>& x :
         {Vec<3>{{0.5, 0.3, 0.3}}, Vec<3>{{0.01, 0.02, 0.59}}, Vec<3>{{0.7, 0.75, 0.1}}}) {
        field.water().gather(x, samples);
        std::vector<Index> seen(samples.owner), all;
        std::sort(seen.begin(), seen.end());
        for (std::size_t i = 0; i < flow.position.size(); ++i)
            if (norm(x - toVec(flow.position[i])) <
                flow.kernel->supportRadius() * flow.smoothingLength(i))
                all.push_back(static_cast<Index>(i));
        EXPECT_EQ(seen, all);
        EXPECT_GT(all.size(), 0u);
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const Vec<3> offset =
                x - toVec(flow.position[static_cast<std::size_t>(samples.owner[k])]);
            EXPECT_EQ(norm(samples.offset[k] - offset), 0);
        }
    }
}

TEST(KernelField, RefusesAParticleAtNoFinitePlace)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    flow.position[7][1] = std::nan("");
    EXPECT_THROW(KernelField{flow}, FatalError);
}
