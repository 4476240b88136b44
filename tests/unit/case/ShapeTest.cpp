// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scene.hpp"

#include "case/BasicShapes.hpp"

#include <numbers>
#include <random>

using namespace isph;
using namespace isph::test;

namespace {

constexpr Real pi = std::numbers::pi;

struct Sample {
    const char* name;
    int dimension;
    const char* text;
};

const Sample samples[] = {
    {"box2", 2, "type box; min (0 0 0); max (1 0.5 0);"},
    {"box3", 3, "type box; min (0 0 0); max (1 0.5 0.7);"},
    {"turnedBox3", 3,
     "type box; min (0 0 0); max (1 0.5 0.7); rotation { angle 40; axis (1 2 0.5); origin (0.3 0 "
     "0); }"},
    {"circle", 2, "type circle; centre (0.3 0.2 0); radius 0.6;"},
    {"cylinder2", 2, "type cylinder; centre (0.3 0.2 0); radius 0.6;"},
    {"sphere", 3, "type sphere; centre (0.3 0.2 0.1); radius 0.6;"},
    {"cylinder", 3, "type cylinder; point1 (0 0 0); point2 (0.5 0.6 0.4); radius 0.3;"},
    {"polygon", 2, "type polygon; points ((0 0) (1 0) (1 1) (0.5 0.3) (0 1));"},
    {"clockwisePolygon", 2, "type polygon; points ((0 1) (0.5 0.3) (1 1) (1 0) (0 0));"},
    {"extrudedPolygon", 3,
     "type polygon; points ((0 0) (1 0) (1 1) (0.5 0.3) (0 1)); zMin -0.2; zMax 0.9;"},
};

class EveryShape : public testing::TestWithParam<Sample> {
protected:
    std::unique_ptr<Shape> shape = shapeOf(GetParam().text, GetParam().dimension);
    std::vector<Point> points()  // spread over the context's domain
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<Real> u(-1, 2);
        std::vector<Point> x(400);
        for (Point& p : x)
            for (int d = 0; d < GetParam().dimension; ++d) p[d] = u(random);
        return x;
    }
};

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(samples),
                         [](const auto& sample) { return std::string(sample.param.name); });

}  // namespace

TEST_P(EveryShape, TheNearestPointIsOnTheSurfaceAndAsFarAsTheDistanceSays)
{
    for (const Point& x : points()) {
        const Point p = shape->nearestPoint(x);
        EXPECT_NEAR(shape->signedDistance(p), 0, 1e-12);  // round-off
        EXPECT_NEAR(norm(x - p), std::fabs(shape->signedDistance(x)), 1e-12);
    }
}

TEST_P(EveryShape, NoPointOfTheSurfaceIsNearerThanTheDistance)
{
    // the surface as seen from other points: a brute-force lower bound
    const std::vector<Point> all = points();
    std::vector<Point> surface;
    for (const Point& x : all) surface.push_back(shape->nearestPoint(x));
    for (const Point& x : all)
        for (const Point& p : surface)
            ASSERT_GE(norm(x - p), std::fabs(shape->signedDistance(x)) - 1e-12);
}

TEST_P(EveryShape, TheNormalPointsOutOfTheShape)
{
    for (const Point& x : points()) {
        const Point n = shape->normal(x), p = shape->nearestPoint(x);
        EXPECT_NEAR(norm(n), 1, 1e-12);
        // at sharp corners the other side of the surface need not be straight behind
        if (shape->signedDistance(x) > 0)
            EXPECT_GT(shape->signedDistance(p + 1e-4 * n), 0);
        else
            EXPECT_LT(shape->signedDistance(p - 1e-4 * n), 0);
    }
}

TEST_P(EveryShape, TheVolumeAgreesWithAQuadrature)
{
    // midpoint rule with linear fractions at the surface; corners cost about (step)^2 per length of
    // edge
    const Real step = GetParam().dimension == 2 ? 0.005 : 0.02, exact = *shape->volume();
    const Real found = measure(shape->bounds(), GetParam().dimension, step,
                               [&](const Point& x) { return shape->signedDistance(x); });
    EXPECT_NEAR(found, exact, (GetParam().dimension == 2 ? 4 : 12) * sqr(step));
}

TEST_P(EveryShape, TheBoundsHoldTheShape)
{
    const BoundingBox b = shape->bounds();
    for (const Point& x : points())
        if (shape->signedDistance(x) < 0) {
            EXPECT_TRUE(b.contains(x));
        }
}

TEST(Contour, EnclosesTheAreaOfEveryShape)
{
    for (const Sample& sample : samples) {
        if (sample.dimension == 3) continue;
        const auto shape = shapeOf(sample.text, 2);
        EXPECT_NEAR(enclosedArea(shape->contour(1e-4)), *shape->volume(), 1e-12)
            << sample.name;  // chords of equal area
    }
}

TEST(Shape, VolumesFollowTheirFormulas)
{
    EXPECT_DOUBLE_EQ(*shapeOf("type box; min (0 0 0); max (2 0.5 9);", 2)->volume(), 1.0);
    EXPECT_DOUBLE_EQ(*shapeOf("type circle; centre (0 0 0); radius 2;", 2)->volume(), 4 * pi);
    EXPECT_DOUBLE_EQ(*shapeOf("type sphere; centre (0 0 0); radius 2;", 3)->volume(), 32 * pi / 3);
    EXPECT_DOUBLE_EQ(
        *shapeOf("type cylinder; point1 (0 0 0); point2 (3 0 4); radius 0.5;", 3)->volume(),
        1.25 * pi);
    EXPECT_NEAR(*shapeOf("type polygon; points ((0 0) (4 0) (0 3));", 2)->volume(), 6, 1e-15);
}

TEST(Composite, UnionDifferenceAndIntersectionHaveTheAreasOfTheirContours)
{
    const std::string shapes =
        "shapes { a { type box; min (0 0 0); max (1 1 0); }"
        "         b { type box; min (0.5 0.25 0); max (1.5 0.75 0); } }";
    EXPECT_NEAR(*shapeOf("type union; " + shapes, 2)->volume(), 1.25, 1e-12);
    EXPECT_NEAR(*shapeOf("type difference; " + shapes, 2)->volume(), 0.75, 1e-12);
    EXPECT_NEAR(*shapeOf("type intersection; " + shapes, 2)->volume(), 0.25, 1e-12);
    const std::string holed =
        "type difference; shapes { a { type box; min (0 0 0); max (1 1 0); }"
        " b { type circle; centre (0.5 0.5 0); radius 0.25; } }";
    EXPECT_NEAR(*shapeOf(holed, 2)->volume(), 1 - pi / 16, 1e-12);
    // a common face counts neither for the union nor against it
    EXPECT_NEAR(*shapeOf("type union; shapes { a { type box; min (0 0 0); max (1 1 0); }"
                         " b { type box; min (1 0 0); max (2 0.5 0); } }",
                         2)
                     ->volume(),
                1.5, 1e-12);
}

TEST(Composite, ADifferenceIsInsideWhereTheFirstIsAndNoOtherIs)
{
    const auto shape = shapeOf(
        "type difference; shapes { a { type sphere; centre (0 0 0); radius 1; }"
        " b { type halfSpace; point (0 0 0); normal (0 1 0); } }",
        3);
    EXPECT_LT(shape->signedDistance({{0, 0.5, 0}}), 0);
    EXPECT_GT(shape->signedDistance({{0, -0.5, 0}}), 0);
    const Point p = shape->nearestPoint({{0.2, -0.4, 0}});
    EXPECT_NEAR(norm(p - Point{{0.2, 0, 0}}), 0, 1e-12);
    EXPECT_LT(norm(shape->normal({{0.2, 0.01, 0}}) - Point{{0, -1, 0}}),
              1e-12);  // out of what is left
}

TEST(Rotation, TurnsAboutItsOriginByDegrees)
{
    const auto shape =
        shapeOf("type box; min (0 0 0); max (1 0.1 0); rotation { angle 90; origin (1 0 0); }", 2);
    EXPECT_NEAR(shape->signedDistance({{1, -0.5, 0}}), 0, 1e-15);  // (0.5, 0) turned about (1, 0)
    EXPECT_LT(shape->signedDistance({{0.95, -0.5, 0}}), 0);
}

TEST(ReadShape, AnUnknownTypeListsTheValidOnesAndTheNearest)
{
    const std::string message =
        messageOf([] { shapeOf("type poligon; points ((0 0) (1 0) (0 1));", 2); });
    EXPECT_TRUE(contains(message, "Unknown shape type poligon; did you mean polygon?")) << message;
    for (const std::string& name : shapeTypes())
        EXPECT_TRUE(contains(message, "    " + name + "\n"));
}

TEST(ReadShape, MistakesAreRefusedWithTheirPlace)
{
    EXPECT_TRUE(contains(messageOf([] { shapeOf("type box; min (0 0 0); max (1 0 0);", 2); }),
                         "no extent along y"));
    EXPECT_TRUE(contains(messageOf([] { shapeOf("type circle; centre (0 0 0); radius -1;", 2); }),
                         "radius"));
    EXPECT_TRUE(contains(messageOf([] { shapeOf("type circle; centre (0 0 0); radius 1;", 3); }),
                         "two dimensions"));
    EXPECT_TRUE(contains(
        messageOf([] { shapeOf("type polygon; points ((0 0) (1 1) (1 0) (0 1));", 2); }), "cross"));
    EXPECT_TRUE(contains(messageOf([] { shapeOf("type polygon; points ((0 0) (1 1));", 2); }),
                         "three points"));
    EXPECT_TRUE(
        contains(messageOf([] { shapeOf("type polygon; points ((0 0) (1 1 0 1) (0 1));", 2); }),
                 "4 numbers"));
    EXPECT_TRUE(contains(
        messageOf([] { shapeOf("type box; min (0 0 0); max (1 1 0); radius 2;", 2); }), "radius"));
    try {
        shapeOf("type halfSpace;\npoint (0 0 0);\nnormal (0 0 0);\n", 3);
        FAIL();
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.line(), 3);
        EXPECT_EQ(error.file(), "shape");
    }
}
