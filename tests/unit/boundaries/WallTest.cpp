// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "boundaries/WallGuard.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace isph;

namespace {

/// A tank of unit spacing, 12 wide and 12 high, filled to 5.
Scene<2> halfFullTank()
{
    return SceneBuilder<2>(1).water({0, 0}, {12, 5}).openTank({0, 0}, {12, 12}).build();
}

Points<2> laid(const Scene<2>& scene)
{
    Points<2> points;
    const std::vector<Real> porosity(scene.water.size(), 1);
    layPoints<2>(scene.water, porosity, scene.wallCloud, scene.box, 1, 1.5, 2, points);
    dryWalls(scene.wallCloud, 1, 1.5, points);
    return points;
}

TEST(Walls, CountWhereWaterTouchesThemAndNowhereElse)
{
    const Scene<2> scene = halfFullTank();
    const Points<2> points = laid(scene);
    int wet = 0, dry = 0;
    for (std::size_t k = 0; k < scene.wallCloud.size(); ++k) {
        const Vec<2>& x = scene.wallCloud.x[k];
        const Real volume = points.volume[points.fluid + static_cast<Index>(k)];
        EXPECT_EQ(volume, x[1] < 5 ? 1 : 0) << x[0] << " " << x[1];
        ++(x[1] < 5 ? wet : dry);
    }
    EXPECT_GT(wet, 0);
    EXPECT_GT(dry, 0);
}

/// Theory (6.5): the marker stands at 0.5; wet through at a distance of 0.65, dry from 0.95 on. The
/// one column of walls beneath the particle has five layers.
TEST(Walls, AreWettedByDegrees)
{
    for (const auto& [height, wet] :
         {std::pair{1.15, 1.0}, std::pair{1.3, 0.5}, std::pair{1.46, 0.0}}) {
        Scene<2> scene =
            SceneBuilder<2>(1).particle({5.5, height}).openTank({0, 0}, {12, 12}).build();
        const Points<2> points = laid(scene);
        const Real volume =
            orderedSum(scene.wallCloud.size(), [&](Index k) { return points.volume[1 + k]; });
        EXPECT_NEAR(volume, 5 * wet, 1e-12) << height;
    }
}

TEST(Walls, TakeTheWidthOfTheWaterThatWetsThem)
{
    Scene<2> scene = SceneBuilder<2>(1).water({0, 0}, {12, 5}).openTank({0, 0}, {12, 12}).build();
    Points<2> points;
    const std::vector<Real> porosity(scene.water.size(), 0.25);
    layPoints<2>(scene.water, porosity, scene.wallCloud, scene.box, 1, 1.5, 2, points);
    dryWalls(scene.wallCloud, 1, 1.5, points);
    for (std::size_t k = 0; k < scene.wallCloud.size(); ++k)
        if (scene.wallCloud.x[k][1] < 5) {
            EXPECT_EQ(points.h[points.fluid + static_cast<Index>(k)], 3);
        }
}

TEST(Walls, OfAPeriodicSceneHaveImages)
{
    const Scene<2> scene = SceneBuilder<2>(1)
        .tank({0, 0}, {12, 12}, [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 12; })
        .periodic({0, 0}, {12, 12}, {true, false}).build();
    ASSERT_EQ(scene.walls.size(), 60u);            // five layers of twelve
    ASSERT_GT(scene.wallCloud.size(), 60u);
    for (std::size_t k = 60; k < scene.wallCloud.size(); ++k) {
        const Vec<2> shift = scene.wallCloud.x[k] - scene.walls.x[scene.wallCloud.owner[k]];
        EXPECT_NEAR(std::abs(shift[0]), 12, 1e-12);
        EXPECT_EQ(shift[1], 0);
    }
}

TEST(WallGuard, PutsBackWhatSankIntoAWallAndLeavesTheRest)
{
    const Scene<2> scene = halfFullTank();
    const WallGuard<2> guard(scene.wallCloud, 1);
    std::vector<Vec<2>> x = {{6.5, -0.3}, {6.5, 0.05}, {6.5, 0.5},
                             {-0.2, 4.5}, {12.4, 4.5}, {6, 6}};
    EXPECT_EQ(guard.keepOut(x), 4);
    EXPECT_NEAR(x[0][1], 0.1, 1e-14);      // a tenth of a spacing   [theory (6.6)]
    EXPECT_EQ(x[0][0], 6.5);
    EXPECT_NEAR(x[1][1], 0.1, 1e-14);
    EXPECT_EQ(x[2], (Vec<2>{6.5, 0.5}));
    EXPECT_NEAR(x[3][0], 0.1, 1e-14);
    EXPECT_NEAR(x[4][0], 11.9, 1e-14);
    EXPECT_EQ(x[5], (Vec<2>{6, 6}));
}

/// Two walls from the origin on, the first along y, the second turned from it by `degrees`; water
/// between them.
struct Corner {
    explicit Corner(Real degrees)
    {
        const Real angle = degrees * std::acos(Real(-1)) / 180;
        const std::array<Vec<2>, 2> along{{{0, 1}, {std::sin(angle), std::cos(angle)}}};
        normal = {{{1, 0}, {-std::cos(angle), std::sin(angle)}}};
        for (int wall = 0; wall < 2; ++wall)
            for (int k = 1; k < 12; ++k) {
                walls.x.push_back(0.25 * k * along[wall]), walls.normal.push_back(normal[wall]);
                walls.depth.push_back(0);
            }
    }
    std::array<Vec<2>, 2> normal;
    WallCloud<2> walls;
};

TEST(WallGuard, LeadsOutOfBothWallsOfACorner)
{
    for (const Real degrees : {60, 90}) {
        const Corner corner(degrees);
        std::vector<Vec<2>> x = {{-0.1, -0.1}};
        EXPECT_EQ(WallGuard<2>(corner.walls, 1).keepOut(x), 1);
        for (const Vec<2>& n : corner.normal) EXPECT_NEAR(dot(x[0], n), 0.1, 1e-14) << degrees;
    }
}

TEST(WallGuard, LeadsOutOfOneWallButNotIntoTheOther)
{
    const Corner wedge(10);   // 0.16 wide at y = 0.9, less than twice 0.1
    std::vector<Vec<2>> x = {{0.2, 0.9}, {-0.05, 0.9}, {0.1, 0.9}};
    const std::vector<Vec<2>> before = x;
    EXPECT_EQ(WallGuard<2>(wedge.walls, 1).keepOut(x), 3);
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(dot(x[i], wedge.normal[0]), dot(x[i], wedge.normal[1]), 1e-14);
        EXPECT_GT(dot(x[i], wedge.normal[0]), 0.07);
        EXPECT_LT(norm(x[i] - before[i]),
                  0.16);  // across the wedge, not up to where it is wide enough
    }
}

TEST(WallGuard, WithoutWallsMovesNothing)
{
    const WallGuard<3> guard(WallCloud<3>{}, 1);
    std::vector<Vec<3>> x = {{-1, -1, -1}};
    EXPECT_EQ(guard.keepOut(x), 0);
    EXPECT_EQ(x[0], (Vec<3>{-1, -1, -1}));
}

}  // namespace
