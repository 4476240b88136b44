// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {

Real linear(const Vector3& x)
{
    return 3 + 2 * x[0] - 5 * x[1] + 7 * x[2];
}

/// In the bulk, in the surface of a wall, in a corner and next to the surface of the water.
const std::string kPoints =
    "probeLocations ((0.1 0.05 0.1) (0 0.04 0.1) (0 0 0.1) (0.12 0.097 0.1)); ";

FlowView stillWater(int dimension)
{
    Tank tank;
    tank.dimension = dimension;
    FlowView flow = emptyTank(tank);
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0.2});
    jitter(flow, 0.2);
    return flow;
}

}  // namespace

TEST(Probes, AreExactForLinearFieldsOnJitteredParticles)
{
    for (const int dimension : {2, 3}) {
        FlowView flow = stillWater(dimension);
        setPressure(flow, linear);
        const Real third = dimension == 2 ? 0 : 0.5;
        setVelocity(flow, [&](const Vector3& x) { return Vector3{x[1], 1 - x[0], third}; });
        auto probes = make("type probes; fields (p U mag(U)); " + kPoints);
        const std::vector<Real> row = probes->measure(flow);
        const std::size_t width = 1 + dimension + 1;
        ASSERT_EQ(row.size(), 4 * width);
        ASSERT_EQ(probes->columns().size(), row.size());
        const std::vector<Vector3> points{
            {0.1, 0.05, 0.1}, {0, 0.04, 0.1}, {0, 0, 0.1}, {0.12, 0.097, 0.1}};
        for (std::size_t k = 0; k < points.size(); ++k) {
            Vector3 x = points[k];
            if (dimension == 2) x[2] = 0;
            EXPECT_NEAR(row[k * width], linear(x), 1e-12);
            EXPECT_NEAR(row[k * width + 1], x[1], 1e-12);
            EXPECT_NEAR(row[k * width + 2], 1 - x[0], 1e-12);
            EXPECT_NEAR(row[k * width + dimension + 1], std::hypot(x[1], 1 - x[0], third), 1e-12);
        }
    }
}

TEST(Probes, NameTheirColumnsByFieldComponentAndPoint)
{
    auto probes =
        make("type probes; fields (p U mag(U)); probeLocations ((0.1 0.05) (0.05 0.05));");
    FlowView flow = stillWater(2);
    probes->measure(flow);
    EXPECT_EQ(probes->columns(), (std::vector<std::string>{"p_0", "U_x_0", "U_y_0", "mag(U)_0",
                                                           "p_1", "U_x_1", "U_y_1", "mag(U)_1"}));
}

TEST(Probes, OutsideTheWaterAndDeepInTheWallGiveZero)
{
    FlowView flow = stillWater(2);
    setPressure(flow, [](const Vector3&) { return 1; });
    const std::vector<Real> row = make(
                                      "type probes; fields (p); probeLocations ((0.1 0.112) (0.1 "
                                      "0.2) (0.1 -0.02) (5 5) (0.1 0.09));")
                                      ->measure(flow);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(row[k], 0) << k;
    EXPECT_NEAR(row[4], 1, 1e-12);
}

TEST(Probes, FallBackOnTheMeanWhereTheNeighboursCarryNoGradient)
{
    FlowView flow = emptyTank({});  // a film of one row: no gradient across it
    addWater(flow, {0, 0, 0}, {0.2, 0.01, 0});
    setPressure(flow, [](const Vector3&) { return 42; });
    EXPECT_NEAR(make("type probes; fields (p); probeLocations ((0.1 0.002));")->measure(flow)[0],
                42, 1e-12);
}

TEST(Probes, SeeThroughAPeriodicEnd)
{
    FlowView flow = emptyTank({});
    flow.wallPosition.clear();
    flow.wallVolume.clear();
    flow.periodic = {true, true, false};
    flow.domainMax = {0.2, 0.2, 0};
    addWater(flow, {0, 0, 0}, {0.2, 0.2, 0});
    setPressure(flow,
                [](const Vector3& x) { return std::cos(2 * 3.141592653589793 * x[0] / 0.2); });
    const std::vector<Real> row =
        make("type probes; fields (p); probeLocations ((0 0) (0.1 0.1));")->measure(flow);
    EXPECT_NEAR(row[0], -row[1], 1e-12);  // the same packing half a wave on: only the sign differs
    EXPECT_NEAR(row[0], 1, 0.1);          // smoothing over h = 0.075 wavelengths
}

TEST(Probes, NameTheFieldsThereAreWhenAskedForAnother)
{
    FlowView flow = stillWater(2);
    try {
        make("type probes; fields (pp); probeLocations ((0.1 0.05));")->measure(flow);
        FAIL() << "no error";
    } catch (const FatalIOError& error) {
        EXPECT_NE(std::string(error.what()).find("Unknown field pp"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("    U\n    p\n"), std::string::npos);
        EXPECT_EQ(error.line(), 1);
    }
    EXPECT_THROW(make("type probes; fields (mag(p)); probeLocations ((0.1 0.05));")->measure(flow),
                 FatalIOError);
    EXPECT_THROW(make("type probes; fields (); probeLocations ((0.1 0.05));"), FatalIOError);
    EXPECT_THROW(make("type probes; fields (p); probeLocations ();"), FatalIOError);
}
