// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "integrator/Shifting.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// How far a shift moves the particles of an uneven tank, 12 x 8 spacings of 1, in a shear flow.
std::vector<Vec<2>> shiftsOf(Scene<2>& scene)
{
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        scene.water.u[i] = scene.water.uOld[i] = {0.1 * scene.water.x[i][1], 0};
    Timers timers;
    DragImplicitStep<2> step(scene, timers);
    step.look();
    std::vector<Vec<2>> moved(scene.water.x);
    shift(*scene.kernel, scene.scheme, Real(0.01), step.fields(), scene.water);
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = scene.water.x[i] - moved[i];
    return moved;
}

Scene<2> unevenTank() { return SceneBuilder<2>(1).water({0, 0}, {12, 8}).shakeWater(0.2).openTank({0, 0}, {12, 12}).build(); }

TEST(Shifting, LeavesSurfaceParticlesWithinReachOfAWallWhereTheyAre)
{
    Scene<2> scene = unevenTank();
    const std::vector<Vec<2>> before = scene.water.x, moved = shiftsOf(scene);
    int atWalls = 0, between = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Real x = before[i][0];
        if (before[i][1] < 7.2) continue;   // the top row stands at 7.5, shaken by 0.2
        if (x < 2 || x > 10) {
            EXPECT_EQ(norm(moved[i]), 0) << x;
            ++atWalls;
        } else if (x > 4 && x < 8) {
            EXPECT_GT(norm(moved[i]), 0) << x;
            ++between;
        }
    }
    EXPECT_GE(atWalls, 2);
    EXPECT_GE(between, 2);
}

TEST(Shifting, MovesNothingInWaterThatMovesAsOne)
{
    Scene<2> scene = unevenTank();
    for (std::size_t i = 0; i < scene.water.size(); ++i) scene.water.u[i] = scene.water.uOld[i] = {3, -2};
    Timers timers;
    DragImplicitStep<2> step(scene, timers);
    step.look();
    const std::vector<Vec<2>> before = scene.water.x;
    shift(*scene.kernel, scene.scheme, Real(0.01), step.fields(), scene.water);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(norm(scene.water.x[i] - before[i]), 0);
}

}  // namespace
