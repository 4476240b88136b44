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

}  // namespace
