// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity and drag at points in, at and above soil.                         [theory (4.10)-(4.15)]
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

std::string sand(Real porosity, Real D50)
{
    return "porousModel akbari; akbariCoeffs { porosity " + std::to_string(porosity) + "; D50 "
         + std::to_string(D50) + "; alphaC 1000; betaC 1.1; }";
}

/// State at points of a scene. Tolerance of exact ones: sums over some thirty neighbours.
template <int Dim>
PorousState<Dim> stateAt(const Scene<Dim>& scene, const std::vector<Vec<Dim>>& x)
{
    PorousState<Dim> state;
    scene.porous->evaluate(x, state);
    return state;
}
constexpr Real exact = 1e-13;

template <int Dim>
void expectTheZonesValues(const Scene<Dim>& scene, const PorousState<Dim>& state, std::size_t i)
{
    const SoilZone& zone = scene.porous->zones()[0];
    EXPECT_NEAR(state.porosity[i], zone.porosity, exact);
    EXPECT_NEAR(state.share[i], 1, exact);
    EXPECT_NEAR(state.linear[i] / zone.resistance.linear, 1, exact);
    EXPECT_NEAR(state.quadratic[i] / zone.resistance.quadratic, 1, exact);
    EXPECT_NEAR(state.mobility[i], zone.porosity / (1 + 0.34 * (1 - zone.porosity) / zone.porosity),
                exact);
}

TEST(PorousField, OnTheSoilLatticeHasTheZonesPorosityAndDrag)
{
    const auto flat = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001)).build();
    expectTheZonesValues(flat, stateAt<2>(flat, {{5.5, 6.5}}), 0);
    const auto deep = SceneBuilder<3>(1).soil({0, 0, 0}, {9, 9, 9}, sand(0.4, 0.001)).build();
    expectTheZonesValues(deep, stateAt<3>(deep, {{4.5, 4.5, 4.5}}), 0);
}

TEST(PorousField, BetweenTheSoilParticlesIsTheSame)
{
    const auto flat = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001)).build();
    std::vector<Vec<2>> x;
    for (int k = 0; k < 50; ++k) x.push_back({5 + 0.037 * k, 5 + 0.029 * k});
    const PorousState<2> state = stateAt(flat, x);
    for (std::size_t i = 0; i < x.size(); ++i) expectTheZonesValues(flat, state, i);
    const auto deep = SceneBuilder<3>(1).soil({0, 0, 0}, {9, 9, 9}, sand(0.4, 0.001)).build();
    expectTheZonesValues(deep, stateAt<3>(deep, {{4.13, 4.77, 4.91}}), 0);
}

TEST(PorousField, SoilGoesOnBehindWallsAndInCorners)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001))
                           .openTank({0, 0}, {12, 20}).build();
    const PorousState<2> state = stateAt<2>(scene, {{0.5, 6.5}, {6.5, 0.5}, {11.5, 0.5}});
    for (std::size_t i = 0; i < 3; ++i) expectTheZonesValues(scene, state, i);
}

TEST(PorousField, SoilGoesOnThroughAPeriodicSide)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001))
                           .periodic({0, 0}, {12, 12}, {true, true}).build();
    const PorousState<2> state = stateAt<2>(scene, {{0.5, 6.5}, {11.5, 11.5}});
    expectTheZonesValues(scene, state, 0);
    expectTheZonesValues(scene, state, 1);
}

TEST(PorousField, ClearWaterIsClearBeyondTheReachOfTheSoil)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 6}, sand(0.4, 0.001)).build();
    const PorousState<2> state =
        stateAt<2>(scene, {{6, 9}});  // 3.5 d0 above the last particle, reach 3 d0
    EXPECT_EQ(state.porosity[0], 1);
    EXPECT_EQ(state.share[0], 0);
    EXPECT_EQ(state.linear[0], 0);
    EXPECT_EQ(state.quadratic[0], 0);
    EXPECT_EQ(state.mobility[0], 1);
}

TEST(PorousField, OverAnInterfaceHoldsTheSameWaterAsAStep)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 8}, sand(0.4, 0.001)).build();
    std::vector<Vec<2>> x;
    const int n = 4000;
    for (int k = 0; k < n; ++k) x.push_back({6.3, 4.5 + 7 * (k + 0.5) / n});   // y from 4.5 to 11.5
    const PorousState<2> state = stateAt(scene, x);
    Real water = 0;
    for (const Real eps : state.porosity) water += 7 * eps / n;
    EXPECT_NEAR(water, 3.5 * 0.4 + 3.5, 1e-6);   // the sum over points 0.002 d0 apart
}

TEST(PorousField, WaterHasTheDragOfTheZoneItIsInAndNoOther)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 6}, sand(0.3, 0.001))
                           .soil({0, 6}, {12, 10}, sand(0.5, 0.01)).build();
    const auto& zones = scene.porous->zones();
    std::vector<Vec<2>> x;
    for (int k = 0; k < 80; ++k) x.push_back({6.3, 4.03 + 0.1 * k});
    const PorousState<2> state = stateAt(scene, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Index zone = x[i][1] < 6 ? 0 : x[i][1] < 10 ? 1 : kClearWater;
        ASSERT_EQ(state.zone[i], zone) << "at " << x[i][1];
        EXPECT_EQ(state.linear[i], zone == kClearWater ? 0 : zones[zone].resistance.linear);
        EXPECT_EQ(state.quadratic[i], zone == kClearWater ? 0 : zones[zone].resistance.quadratic);
    }
}

TEST(PorousField, TellsTheDepthBeneathTheNearestFace)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {14, 6}, sand(0.3, 0.001))
                           .soil({0, 6}, {14, 12}, sand(0.5, 0.01)).build();
    std::vector<Vec<2>> x;
    for (int k = 0; k < 100; ++k)
        x.push_back({6.3 + 0.01 * k, 4.03 + 0.1 * k});  // across both faces, to 13.93
    const PorousState<2> state = stateAt(scene, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Real depth = std::min({std::abs(x[i][1] - 6), std::abs(x[i][1] - 12), 2.0});
        EXPECT_NEAR(state.depth[i], depth, 1e-9)
            << "at " << x[i][1];  // round-off over the slope there, 1e-3
    }
}

TEST(PorousField, ItsNormalPointsIntoTheSoil)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 8}, sand(0.4, 0.001)).build();
    const PorousState<2> state = stateAt<2>(scene, {{6, 8.3}, {6.5, 7.7}});   // symmetric in x
    for (const Vec<2>& n : state.normal) {
        EXPECT_NEAR(unit(n)[0], 0, 1e-12);
        EXPECT_NEAR(unit(n)[1], -1, 1e-12);
    }
}

TEST(PorousField, AWallBesideSoilIsNoSoilSurface)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001))
                           .openTank({0, 0}, {12, 20}).build();
    // Against 1/(3 d0) and more at a surface.
    for (const Vec<2>& n : stateAt<2>(scene, {{0.3, 6.5}, {6.5, 0.3}, {6.2, 6.5}}).normal)
        EXPECT_LT(norm(n), exact);
}

TEST(PorousField, BetweenTwoZonesHasTheMeanOfTheirPorosities)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 6}, sand(0.3, 0.001))
                           .soil({0, 6}, {12, 12}, sand(0.5, 0.01)).build();
    const PorousState<2> state = stateAt<2>(scene, {{6.5, 2.5}, {6.2, 6}, {6.5, 9.5}});
    EXPECT_NEAR(state.porosity[0], 0.3, exact);
    EXPECT_NEAR(state.porosity[1], 0.4, exact);
    EXPECT_NEAR(state.porosity[2], 0.5, exact);
    EXPECT_NEAR(state.share[1], 1, exact);
}

TEST(PorousField, SharpPorosityIsThatOfTheZoneLessTheGrainsThatMove)
{
    auto scene = SceneBuilder<2>(1).soil({0, 0}, {14, 6}, sand(0.3, 0.001))
                     .soil({0, 6}, {14, 10}, sand(0.5, 0.01)).build();
    EXPECT_NEAR(scene.porous->sharpPorosityAt({6.3, 5.9}), 0.3, exact);
    EXPECT_NEAR(scene.porous->sharpPorosityAt({6.3, 6.1}), 0.5, exact);
    EXPECT_NEAR(scene.porous->sharpPorosityAt({6.3, 9.9}), 0.5, exact);
    EXPECT_NEAR(scene.porous->sharpPorosityAt({6.3, 10.1}), 1, exact);
    for (std::size_t k = 0; k < scene.soil.size(); ++k)
        scene.soil.released[k] = scene.soil.x[k][1] > 6;
    scene.porous->place(scene.soil, scene.box);
    EXPECT_NEAR(scene.porous->sharpPorosityAt({6.3, 8}), 1 - 0.5 * 0.99948,
                1e-4);  // 2 d0 from both ends of the grains
}

TEST(PorousField, ReleasedGrainsFillSpaceButResistNoMore)
{
    auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001)).build();
    scene.soil.released.assign(scene.soil.size(), 1);
    scene.porous->place(scene.soil, scene.box);
    const PorousState<2> state = stateAt<2>(scene, {{5.5, 6.5}});
    EXPECT_NEAR(state.porosity[0], 0.4, exact);
    EXPECT_EQ(state.share[0], 0);
    EXPECT_EQ(state.linear[0], 0);
    ASSERT_EQ(state.solidsFlux.size(), 1u);
    EXPECT_EQ(norm(state.solidsFlux[0]), 0);   // at rest
    for (Vec<2>& u : scene.soil.u) u = {2, -1};
    scene.porous->place(scene.soil, scene.box);
    const PorousState<2> moving = stateAt<2>(scene, {{5.5, 6.5}});
    EXPECT_NEAR(moving.solidsFlux[0][0], 0.6 * 2, exact);
    EXPECT_NEAR(moving.solidsFlux[0][1], 0.6 * -1, exact);
}

}  // namespace
