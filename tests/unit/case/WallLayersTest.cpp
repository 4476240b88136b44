// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scene.hpp"

#include <numbers>

using namespace isph;
using namespace isph::test;

namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real d0 = 0.01;
const std::string plane =
    "spacing 0.01; dimension 2; domain { min (-1 -1 0); max (1 1 0); } water {} ";
const std::string space =
    "spacing 0.05; dimension 3; domain { min (0 0 0); max (1 1 1); } water {} ";

/// The first layers by depth: their normals end on the surface and depths are (k + 1/2) d0.
void expectLayers(const WallParticles& walls, const Shape& shape, Real tolerance)
{
    ASSERT_GT(walls.size(), 0u);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        EXPECT_NEAR(shape.signedDistance(walls.x[i] + walls.depth[i] * walls.normal[i]), 0,
                    tolerance);
        const Real layer = walls.depth[i] / d0 - 0.5;
        EXPECT_NEAR(layer, std::round(layer), 0.05);  // in spacings
    }
}

Real sum(const std::vector<Real>& v)
{
    Real s = 0;
    for (Real a : v) s += a;
    return s;
}

}  // namespace

TEST(WallLayers, ATankOnTheLatticeGetsTheLatticeAroundIt)
{
    const CaseGeometry g = geometryOf(
        plane + "walls { tank { type box; min (0 0 0); max (0.2 0.1 0); open (top); } }");
    const WallParticles walls = layWalls(g, 0.03);
    // three layers: 3*(20 + 6) below and 2*3*10 beside
    EXPECT_EQ(walls.size(), 3u * 26 + 60);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (int d = 0; d < 2; ++d) {
            const Real cell = walls.x[i][d] / d0 - 0.5;
            EXPECT_NEAR(cell, std::round(cell), 1e-9);
        }
        EXPECT_NEAR(walls.volume[i], sqr(d0), 1e-15);
        EXPECT_LT(walls.x[i][1], 0.1);  // no wall above the open face
    }
    EXPECT_NEAR(nearestPair(g, walls.x), d0, 1e-12);
}

TEST(WallLayers, AClosedBoxWithItsFluidInsideHasWallsAllAround)
{
    const CaseGeometry g = geometryOf(
        plane + "walls { tank { type box; min (0 0 0); max (0.2 0.1 0); fluid inside; } }");
    EXPECT_EQ(layWalls(g, 0.03).size(), 26u * 16 - 20 * 10);
}

TEST(WallLayers, ATurnedTankHasTheTurnedParticlesOfTheTank)
{
    const std::string tank = "type box; min (0 0 0); max (0.2 0.1 0); open (top);";
    const WallParticles straight =
        layWalls(geometryOf(plane + "walls { t { " + tank + " } }"), 0.03);
    const CaseGeometry g =
        geometryOf(plane + "walls { t { " + tank + " rotation { angle 30; origin (0.1 0 0); } } }");
    const WallParticles turned = layWalls(g, 0.03);
    ASSERT_EQ(turned.size(), straight.size());
    const PointGrid grid(0.02, turned.x);
    const Real c = std::cos(pi / 6), s = std::sin(pi / 6);
    for (const Point& x : straight.x) {
        const Point r = x - Point{{0.1, 0, 0}};
        const Point expected{{0.1 + c * r[0] - s * r[1], s * r[0] + c * r[1], 0}};
        EXPECT_GE(grid.nearest(expected, 1e-9), 0);
    }
}

TEST(WallLayers, ACircleHasRingsAtTheDepthsWithTheAreaOfTheRing)
{
    const CaseGeometry g =
        geometryOf(plane + "walls { pile { type circle; centre (0 0 0); radius 0.1; } }");
    const WallParticles walls = layWalls(g, 0.04);
    expectLayers(walls, g.walls[0].shape(), 1e-3 * d0);  // chords of the contour
    EXPECT_NEAR(sum(walls.volume), pi * (sqr(0.1) - sqr(0.06)), 2e-3 * pi * sqr(0.1));  // as above
    EXPECT_GT(nearestPair(g, walls.x), 0.9 * d0);
    for (std::size_t i = 0; i < walls.size(); ++i)
        EXPECT_GT(dot(walls.normal[i], unit(walls.x[i])), 0.999);  // radial
}

TEST(WallLayers, ATankThatIsACircleHasItsRingsOutside)
{
    const CaseGeometry g = geometryOf(
        plane + "walls { tank { type circle; centre (0 0 0); radius 0.1; fluid inside; } }");
    const WallParticles walls = layWalls(g, 0.04);
    expectLayers(walls, g.walls[0].shape(), 1e-3 * d0);
    EXPECT_NEAR(sum(walls.volume), pi * (sqr(0.14) - sqr(0.1)), 2e-3 * pi * sqr(0.1));
    for (std::size_t i = 0; i < walls.size(); ++i)
        EXPECT_LT(dot(walls.normal[i], unit(walls.x[i])), -0.999);
}

TEST(WallLayers, AMoundOfSlopesOneInTwoHasStraightLayersAndClosedCorners)
{
    const CaseGeometry g =
        geometryOf(plane +
                   "walls { floor { type halfSpace; point (0 0 0); normal (0 1 0); }"
                   "        mound { type polygon; points ((-0.4 -0.1) (-0.4 0) (-0.2 0.1) (0.2 "
                   "0.1) (0.4 0) (0.4 -0.1)); } }");
    const WallParticles walls = layWalls(g, 0.03);
    // kernel sum of a filled half-plane: walls below, a lattice of water above would give 1; here
    // the body alone is tested where the kernel sees no water, a layer and a half below the surface
    KernelSum kernels(g, 0.5 * d0);  // so narrow that it sees the neighbours only
    kernels.add(walls.x, walls.volume);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls.depth[i] > 1.6 * d0 || walls.depth[i] < d0 || std::fabs(walls.x[i][0]) > 0.8)
            continue;
        EXPECT_NEAR(kernels.at(walls.x[i]), 2.2282, 0.12)
            << walls.x[i][0] << ' ' << walls.x[i][1];  // W(0) d0^2
    }
    EXPECT_GT(nearestPair(g, walls.x), 0.6 * d0);
}

TEST(WallLayers, BetweenABodyAndTheFloorItStandsOnThereIsNoSurface)
{
    const CaseGeometry g =
        geometryOf(plane +
                   "walls { tank { type box; min (-0.5 0 0); max (0.5 0.3 0); open (top); }"
                   "        caisson { type box; min (-0.1 0 0); max (0.1 0.2 0); } }");
    const WallParticles walls = layWalls(g, 0.03);
    bool besideToe = false;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const Point marker = walls.x[i] + (walls.depth[i] + 0.5 * d0) * walls.normal[i];
        EXPECT_GT(g.bodyDistance(marker), 0) << "a particle that looks into a body";
        EXPECT_FALSE(std::fabs(walls.x[i][0]) < 0.06 && walls.x[i][1] < 0.15)
            << "a particle that no water sees";
        besideToe = besideToe || norm(walls.x[i] - Point{{0.095, -0.005, 0}}) < 1e-9;
    }
    EXPECT_TRUE(besideToe) << "the layers do not close below the toe of the caisson";
}

TEST(WallLayers, TwoBodiesSideBySideHaveNoSeam)
{
    const CaseGeometry g = geometryOf(plane +
                                      "walls { a { type box; min (0 0 0); max (0.1 0.2 0); }"
                                      "        b { type box; min (0.1 0 0); max (0.2 0.2 0); } }");
    const CaseGeometry one =
        geometryOf(plane + "walls { a { type box; min (0 0 0); max (0.2 0.2 0); } }");
    const WallParticles pair = layWalls(g, 0.03), whole = layWalls(one, 0.03);
    ASSERT_EQ(pair.size(), whole.size());
    const PointGrid grid(0.02, pair.x);
    for (const Point& x : whole.x) EXPECT_GE(grid.nearest(x, 1e-9), 0);
}

TEST(WallLayers, APlateOfAnOddNumberOfSpacingsIsFilledOnce)
{
    const CaseGeometry g =
        geometryOf(plane + "walls { plate { type box; min (0 0 0); max (0.03 0.4 0); } }");
    const WallParticles walls = layWalls(g, 0.04);
    EXPECT_NEAR(nearestPair(g, walls.x), d0, 1e-9);
    EXPECT_EQ(walls.size(), 3u * 40);
    EXPECT_NEAR(sum(walls.volume), 0.03 * 0.4,
                1e-3 * 0.03 * 0.4);  // quadrature of the middle layer
}

TEST(WallLayers, AWavyFloorRepeatsAcrossThePeriodicFaces)
{
    const CaseGeometry g = geometryOf(
        "spacing 0.01; dimension 2; domain { min (0 -0.2 0); max (0.403 0.5 0); } water {}"
        "walls { floor { type polygon; points ((-0.1 -0.15) (0.5 -0.15) (0.5 0) (0.3 0)"
        " (0.2 0.05) (0.1 0) (-0.1 0)); } }",
        "x");
    const WallParticles walls = layWalls(g, 0.03);
    for (const Point& x : walls.x) {
        EXPECT_GE(x[0], 0);
        EXPECT_LT(x[0], 0.403);
    }
    EXPECT_GT(nearestPair(g, walls.x), 0.75 * d0);  // images included
    // no gap at the face either: the distance of a point on it to the nearest particle of each
    // layer
    const PeriodicPoints all(g, walls.x, 2 * d0);
    const PointGrid grid(d0, all.x);
    for (int k = 0; k < 3; ++k)
        EXPECT_GE(grid.nearest({{0, -(k + 0.5) * d0, 0}}, 0.55 * d0), 0) << k;
}

TEST(WallLayers, ATankInThreeDimensionsContinuesTheLattice)
{
    const CaseGeometry g = geometryOf(
        space + "walls { tank { type box; min (0 0 0); max (1 0.5 0.4); open (top); } }");
    const WallParticles walls = layWalls(g, 0.1);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (int d = 0; d < 3; ++d) {
            const Real cell = walls.x[i][d] / 0.05 - 0.5;
            EXPECT_NEAR(cell, std::round(cell), 1e-9);
        }
        EXPECT_NEAR(walls.volume[i], cube(0.05), 1e-15);
        EXPECT_NEAR(
            g.walls[0].shape().signedDistance(walls.x[i] + walls.depth[i] * walls.normal[i]), 0,
            1e-12);
    }
    // every place of the lattice within 0.1 m of the walls, the open face excepted, is taken once
    std::size_t expected = 0;
    for (int i = -2; i < 22; ++i)
        for (int j = -2; j < 10; ++j)
            for (int k = -2; k < 10; ++k) {
                const Point x{{(i + 0.5) * 0.05, (j + 0.5) * 0.05, (k + 0.5) * 0.05}};
                const bool inside = i >= 0 && i < 20 && j >= 0 && k >= 0 && k < 8;
                expected +=
                    !inside &&
                    shapeOf("type box; min (0 0 0); max (1 2 0.4);", 3)->signedDistance(x) <= 0.1;
            }
    EXPECT_EQ(walls.size(), expected);
}

TEST(WallLayers, ASphereHasShellsAtTheDepthsWithTheVolumeOfTheShells)
{
    const CaseGeometry g =
        geometryOf(space + "walls { ball { type sphere; centre (0.5 0.5 0.5); radius 0.3; } }");
    const WallParticles walls = layWalls(g, 0.1);
    ASSERT_GT(walls.size(), 100u);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const Real layer = walls.depth[i] / 0.05 - 0.5;
        EXPECT_NEAR(layer, std::round(layer), 1e-6);
        EXPECT_NEAR(norm(walls.normal[i] - unit(walls.x[i] - Point{{0.5, 0.5, 0.5}})), 0, 1e-9);
    }
    EXPECT_NEAR(sum(walls.volume), 4 * pi / 3 * (cube(0.3) - cube(0.2)),
                0.03 * 4 * pi / 3 * cube(0.3));
    EXPECT_GT(nearestPair(g, walls.x), 0.6 * 0.05);
}

TEST(WallLayers, AnInclinedPlaneInThreeDimensionsIsSmooth)
{
    const CaseGeometry g = geometryOf(
        space + "walls { slope { type halfSpace; point (0.5 0.5 0.5); normal (-1 2 0.5); } }");
    const WallParticles walls = layWalls(g, 0.15);
    KernelSum kernels(g, 0.075);
    kernels.add(walls.x, walls.volume);
    // a point of the surface sees half a kernel: 0.5 on a smooth wall, and 0.5 +- 0.1 on stairs
    const Point n = unit(Point{{-1, 2, 0.5}}), t1 = unit(Point{{2, 1, 0}}),
                t2 = unit(Point{{-0.5, 1, -5}});
    for (int a = -4; a <= 4; ++a)
        for (int b = -4; b <= 4; ++b) {
            const Point x = Point{{0.5, 0.5, 0.5}} + 0.04 * a * t1 + 0.04 * b * t2;
            EXPECT_NEAR(dot(x - Point{{0.5, 0.5, 0.5}}, n), 0, 1e-12);
            EXPECT_NEAR(kernels.at(x), 0.5, 0.04);
        }
}

TEST(Walls, AnOpenFaceThatIsNoneIsRefused)
{
    const std::string message = messageOf([] {
        geometryOf(plane + "walls { tank { type box; min (0 0 0); max (1 1 0); open (topp); } }");
    });
    EXPECT_TRUE(contains(message, "topp is not a face of the box; did you mean top?")) << message;
    EXPECT_TRUE(contains(
        messageOf([] {
            geometryOf(plane +
                       "walls { tank { type circle; centre (0 0 0); radius 1; open (top); } }");
        }),
        "only a box"));
    EXPECT_TRUE(contains(messageOf([] {
                             geometryOf(plane +
                                        "walls { tank { type box; min (0 0 0); max (1 1 0); open "
                                        "(top); fluid outside; } }");
                         }),
                         "holds its water inside"));
}
