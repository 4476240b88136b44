// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scene.hpp"

#include <random>

using namespace isph;
using namespace isph::test;

namespace {

/// The unit cube in STL; `triangles` of its twelve.
std::filesystem::path writeCube(const std::string& name, int triangles = 12)
{
    const auto file = std::filesystem::temp_directory_path() / name;
    std::ofstream out(file);
    out << "solid cube\n";
    int written = 0;
    for (int d = 0; d < 3; ++d)
        for (int end = 0; end < 2; ++end) {
            const auto corner = [&](int a, int b) {
                Point x;
                x[d] = end, x[(d + 1) % 3] = a, x[(d + 2) % 3] = b;
                return x;
            };
            const Point quad[4] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
            for (int half = 0; half < 2 && written < triangles; ++half, ++written) {
                out << "facet normal 0 0 0\nouter loop\n";
                const int order[3] = {0, end ? half + 1 : half + 2, end ? half + 2 : half + 1};
                for (int k : order)
                    out << "vertex " << quad[k][0] << ' ' << quad[k][1] << ' ' << quad[k][2]
                        << '\n';
                out << "endloop\nendfacet\n";
            }
        }
    out << "endsolid cube\n";
    return file;
}

std::string cubeText(const std::string& name)
{
    return "type surface; file \"" + name + "\";";
}

}  // namespace

TEST(Surface, AClosedCubeHasTheDistancesNormalsAndVolumeOfABox)
{
    writeCube("isphTestCube.stl");
    const auto cube = shapeOf(cubeText("isphTestCube.stl"), 3);
    const auto box = shapeOf("type box; min (0 0 0); max (1 1 1);", 3);
    EXPECT_NEAR(*cube->volume(), 1, 1e-12);
    for (const Point& x :
         {Point{{0.5, 0.5, 0.4}}, Point{{0.2, 0.4, 0.7}}, Point{{1.5, 0.5, 0.5}},
          Point{{-0.3, -0.4, 0.5}}, Point{{1.2, 1.3, 1.4}}, Point{{0.5, 2, 0.5}}}) {
        EXPECT_NEAR(cube->signedDistance(x), box->signedDistance(x),
                    1e-6);  // STL holds single precision
        EXPECT_NEAR(norm(cube->nearestPoint(x) - box->nearestPoint(x)), 0, 1e-6);
        EXPECT_NEAR(norm(cube->normal(x) - box->normal(x)), 0, 1e-5);
    }
}

TEST(Surface, ASurfaceWithAHoleIsRefusedWithItsFileAndItsOpenEdges)
{
    writeCube("isphTestOpenCube.stl", 11);
    const std::string message = messageOf([] { shapeOf(cubeText("isphTestOpenCube.stl"), 3); });
    EXPECT_TRUE(contains(message, "isphTestOpenCube.stl")) << message;
    EXPECT_TRUE(contains(message, "not closed: 3 open edges"))
        << message;  // those of the missing triangle
}

TEST(Surface, AMissingFileAndAnUnknownFormatAreRefused)
{
    EXPECT_TRUE(contains(messageOf([] { shapeOf(cubeText("isphNoSuch.stl"), 3); }), "cannot open"));
    std::ofstream(std::filesystem::temp_directory_path() / "isphTest.ply") << "ply\n";
    EXPECT_TRUE(
        contains(messageOf([] { shapeOf(cubeText("isphTest.ply"), 3); }), ".stl, .obj and .vtp"));
}

TEST(Surface, InTwoDimensionsItIsItsSection)
{
    writeCube("isphTestCube2.stl");
    const auto square = shapeOf(cubeText("isphTestCube2.stl"), 2);
    EXPECT_NEAR(*square->volume(), 1, 1e-6);
    EXPECT_NEAR(square->signedDistance({{0.25, 0.5, 0}}), -0.25, 1e-6);
    EXPECT_NEAR(square->signedDistance({{1.5, 0.5, 0}}), 0.5, 1e-6);
    EXPECT_TRUE(contains(messageOf([] { shapeOf(cubeText("isphTestCube2.stl") + " z 3;", 2); }),
                         "does not cut"));
}

TEST(Surface, AnObjFileIsReadToo)
{
    const auto file = std::filesystem::temp_directory_path() / "isphTest.obj";
    std::ofstream(file)
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    EXPECT_NEAR(*shapeOf(cubeText("isphTest.obj"), 3)->volume(), 1.0 / 6, 1e-7);
}

TEST(Surface, ANotchedPrismHasTheDistancesOfTheExtrudedPolygon)
{
    // an L from z = 0 to 1, in triangles; its inner edge is where the nearest feature tells the
    // side
    const Real corner[6][2] = {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
    const int cap[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    std::ofstream out(std::filesystem::temp_directory_path() / "isphTestPrism.obj");
    for (int z = 0; z < 2; ++z)
        for (const auto& c : corner) out << "v " << c[0] << ' ' << c[1] << ' ' << z << '\n';
    for (const auto& t : cap) {
        out << "f " << t[2] + 1 << ' ' << t[1] + 1 << ' ' << t[0] + 1 << '\n';
        out << "f " << t[0] + 7 << ' ' << t[1] + 7 << ' ' << t[2] + 7 << '\n';
    }
    for (int k = 0; k < 6; ++k) {
        const int a = k + 1, b = (k + 1) % 6 + 1;
        out << "f " << a << ' ' << b << ' ' << b + 6 << "\nf " << a << ' ' << b + 6 << ' ' << a + 6
            << '\n';
    }
    out.close();
    const auto prism = shapeOf(cubeText("isphTestPrism.obj"), 3);
    const auto polygon = shapeOf(
        "type polygon; zMin 0; zMax 1;"
        "points ((0 0) (1 0) (1 0.4) (0.4 0.4) (0.4 1) (0 1));",
        3);
    EXPECT_NEAR(*prism->volume(), *polygon->volume(), 1e-6);
    std::mt19937 random(3);
    std::uniform_real_distribution<Real> u(-0.5, 1.5);
    for (int i = 0; i < 2000; ++i) {
        const Point x{{u(random), u(random), u(random)}};
        EXPECT_NEAR(prism->signedDistance(x), polygon->signedDistance(x),
                    1e-6);  // single precision
    }
}
