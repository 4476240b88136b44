// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

const std::string sand =
    "porousModel akbari; akbariCoeffs { porosity 0.4; D50 0.002; alphaC 1000; betaC 1.1; }";

/// Kinetic over potential energy after 100 steps; 1e-12 is a millionth of the speed of a fall.
template <int Dim>
void expectRest(Scene<Dim> scene)
{
    Real potential = 0;
    for (const Vec<Dim>& x : scene.water.x) potential += 9.81 * x[Dim - 1];
    const std::vector<Vec<Dim>> before = scene.water.x;
    advance(scene, 1e-3, 100);
    EXPECT_LT(kineticEnergy(scene.water), 1e-12 * potential);
    for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_LT(norm(scene.water.x[i] - before[i]), 1e-6 * scene.scheme.spacing);
}

TEST(StillWater, OnALatticeStaysAtRestInTwoDimensions)
{
    expectRest<2>(
        SceneBuilder<2>(0.01).water({0, 0}, {0.16, 0.12}).openTank({0, 0}, {0.16, 0.2}).build());
}

TEST(StillWater, OnALatticeStaysAtRestInThreeDimensions)
{
    expectRest<3>(SceneBuilder<3>(0.01).water({0, 0, 0}, {0.08, 0.07, 0.08})
                      .openTank({0, 0, 0}, {0.08, 0.07, 0.16}).build());
}

TEST(StillWater, OverASoilLayerStaysAtRest)
{
    expectRest<2>(SceneBuilder<2>(0.01)
                      .water({0, 0.1}, {0.12, 0.2})
                      .waterCells({0, 0}, {0.12, 0.1}, {8, 6})
                      .soil({0, 0}, {0.12, 0.1}, sand)
                      .openTank({0, 0}, {0.12, 0.3})
                      .build());
}

TEST(StillWater, BetweenPeriodicSidesStaysAtRest)
{
    expectRest<2>(SceneBuilder<2>(0.01)
                      .water({0, 0}, {0.16, 0.12})
                      .tank({0, 0}, {0.16, 0.2},
                            [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 0.16; })
                      .periodic({0, 0}, {0.16, 0.2}, {true, false})
                      .build());
}

/// Water on a lattice at an angle to the tank and its surface: the steps of that surface fall
/// level, then the water is at rest as far as its particles can tell: rms of the speed below 1 % of
/// sqrt(gH), pressure within 1 % of rho g H.
TEST(StillWater, InATankTurnedAgainstItsLatticeSettles)
{
    constexpr Real H = 0.12, L = 0.2, d0 = 0.01, angle = 0.5236;
    SceneBuilder<2> builder(d0);
    for (int a = -40; a < 40; ++a)
        for (int b = -40; b < 40; ++b) {
            const Real r = (a + 0.5) * d0, s = (b + 0.5) * d0;
            const Vec<2> x{std::cos(angle) * r - std::sin(angle) * s,
                           std::sin(angle) * r + std::cos(angle) * s};
            if (x[0] > 0 && x[0] < L && x[1] > 0 && x[1] < H) builder.particle(x);
        }
    Scene<2> scene = builder.openTank({0, 0}, {L, 0.2}).build();
    advance(scene, 2e-3, 1000);
    const Water<2>& water = scene.water;
    const Real n = static_cast<Real>(water.size()), depth = n * d0 * d0 / L;
    EXPECT_LT(std::sqrt(2 * kineticEnergy(water) / n), 0.01 * std::sqrt(9.81 * H));
    Real error = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        error += sqr(water.p[i] - 9810 * (depth - water.x[i][1]));
    }
    EXPECT_LT(std::sqrt(error / n), 0.01 * 9810 * H);
}

}  // namespace
