// SPDX-License-Identifier: GPL-3.0-or-later
#include "../OpenStep.hpp"
#include "../SceneBuilder.hpp"
#include "integrator/Corrector.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isph;

namespace {

constexpr Real kDt = 0.01;

/// A pool 6 deep in which one particle of the second row has risen: the force on it beyond gravity,
/// with the pressure of water at rest and a surplus of its own.
Vec<3> forceOnRisen(Real rise, Real surplus)
{
    SceneBuilder<3> builder(1);
    builder.water({-5, -5, -6}, {5, 5, -1}).water({-5, -5, -1}, {5, 5, 0});
    Scene<3> scene = builder.build();
    std::vector<Vec<3>>& x = scene.water.x;
    const Vec<3> middle{0.5, 0.5, -1.5};
    const auto risen = static_cast<std::size_t>(
        std::min_element(x.begin(), x.end(), [&](const auto& a, const auto& b) {
            return normSqr(a - middle) < normSqr(b - middle); }) - x.begin());
    x[risen][2] += rise;
    Timers timers;
    OpenStep<3> step(scene, timers);
    step.look();
    StepFields<3>& fields = step.open();
    const auto n = static_cast<std::size_t>(fields.points.fluid);
    fields.p.assign(n, 0), fields.v.assign(n, Vec<3>{});
    for (std::size_t i = 0; i < n; ++i) fields.p[i] = dot(scene.scheme.force, fields.points.x[i]);
    const auto at = static_cast<std::size_t>(
        std::find(fields.points.x.begin(), fields.points.x.end(), x[risen]) -
        fields.points.x.begin());
    fields.p[at] += surplus;
    EXPECT_EQ(fields.role[at], SurfaceRole::near);
    correct(ClearWater<3>{kDt}, scene.scheme, fields, scene.water);
    return scene.water.forceGradient[fields.points.owner[at]];
}

TEST(Corrector, WhatRisesBeneathTheSurfaceIsNotDrawnUpByItsOwnPressure)
{
    // A tenth of a spacing of water too little; with its own pressure it is drawn up with 2 % of
    // gravity.
    EXPECT_NEAR(norm(forceOnRisen(0.5, -0.981)), 0, 1e-12);
    EXPECT_NEAR(norm(forceOnRisen(0.5, 0)), 0, 1e-12);
}

TEST(Corrector, AnImpactIsFelt)
{
    // All but a quarter of a spacing of water.
    const Vec<3> weak = forceOnRisen(0.5, 100 * 9.81), strong = forceOnRisen(0.5, 200 * 9.81);
    EXPECT_NEAR(norm(strong) / norm(weak), 199.75 / 99.75, 1e-9);
}

TEST(Corrector, AParticleOfTheSecondRowHasItsOwnPressure)
{
    const Vec<3> whole = forceOnRisen(0, 0.981), most = forceOnRisen(0, 100 * 0.981);
    EXPECT_GT(norm(whole), 1e-3);
    EXPECT_NEAR(norm(most), 100 * norm(whole), 1e-9);
}

}  // namespace
