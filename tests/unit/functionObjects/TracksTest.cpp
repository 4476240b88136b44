// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isph;
using namespace isph::test;

namespace {
const std::string kTracks = "type tracks; points ((0.051 0.049) (0.15 0.02));";

FlowView block()
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    return flow;
}

/// All particles moved, and stored in another order.
void moveAndReorder(FlowView& flow)
{
    for (Vector3& x : flow.position) x[0] += 0.03;
    std::reverse(flow.position.begin(), flow.position.end());
    std::reverse(flow.id.begin(), flow.id.end());
}
}  // namespace

TEST(Tracks, FollowTheParticlesThatWereNearestAtTheStart)
{
    FlowView flow = block();
    auto tracks = make(kTracks);
    const std::vector<Real> start = tracks->measure(flow);
    ASSERT_EQ(tracks->columns(),
              (std::vector<std::string>{"id_0", "x_0", "y_0", "id_1", "x_1", "y_1"}));
    EXPECT_NEAR(start[1], 0.055, 1e-15);
    EXPECT_NEAR(start[2], 0.045, 1e-15);
    moveAndReorder(flow);
    const std::vector<Real> later = tracks->measure(flow);
    EXPECT_EQ(later[0], start[0]);
    EXPECT_NEAR(later[1], 0.085, 1e-15);
    EXPECT_EQ(later[2], start[2]);
}

TEST(Tracks, FollowTheSameOnesAfterARestart)
{
    FlowView flow = block();
    auto first = make(kTracks), second = make(kTracks);
    const std::vector<Real> start = first->measure(flow);
    moveAndReorder(flow);
    second->resume(start);
    EXPECT_EQ(second->measure(flow), first->measure(flow));
}

TEST(Tracks, EndTheRunWhereAParticleIsGone)
{
    FlowView flow = block();
    auto tracks = make(kTracks);
    tracks->measure(flow);
    flow.id.assign(flow.id.size(), -1);
    EXPECT_THROW(tracks->measure(flow), FatalError);
}
