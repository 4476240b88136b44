// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity and drag at points in, at and above soil.                              [theory (4.10)-(4.13)]
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
    EXPECT_NEAR(state.mobility[i], zone.porosity / (1 + 0.34 * (1 - zone.porosity) / zone.porosity), exact);
}

TEST(PorousField, OnTheSoilLatticeHasTheZonesPorosityAndDrag)
{
    const auto flat = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001)).build();
    expectTheZonesValues(flat, stateAt<2>(flat, {{5.5, 6.5}}), 0);
    const auto deep = SceneBuilder<3>(1).soil({0, 0, 0}, {9, 9, 9}, sand(0.4, 0.001)).build();
    expectTheZonesValues(deep, stateAt<3>(deep, {{4.5, 4.5, 4.5}}), 0);
}

TEST(PorousField, BetweenTheSoilParticlesIsAsGood)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 12}, sand(0.4, 0.001)).build();
    std::vector<Vec<2>> x;
    for (int k = 0; k < 50; ++k) x.push_back({5 + 0.037 * k, 5 + 0.029 * k});
    const PorousState<2> state = stateAt(scene, x);
    for (const Real eps : state.porosity) EXPECT_NEAR(eps, 0.4, 0.005);   // quadrature of the kernel, h = 1.5 d0
}

TEST(PorousField, IsTheSameForEveryKernel)
{
    for (const char* kernel : {"cubicSpline", "quinticSpline", "wendlandC2", "wendlandC4"}) {
        const auto scene = SceneBuilder<2>(1).soil({0, 0}, {14, 14}, sand(0.4, 0.001)).build(kernel);
        expectTheZonesValues(scene, stateAt<2>(scene, {{6.5, 6.5}}), 0);
    }
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
    const PorousState<2> state = stateAt<2>(scene, {{6, 9}});   // 3.5 d0 above the last particle, reach 3 d0
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
    for (int k = 0; k < n; ++k) x.push_back({6.5, 4.5 + 7 * (k + 0.5) / n});   // y from 4.5 to 11.5
    const PorousState<2> state = stateAt(scene, x);
    Real water = 0;
    for (const Real eps : state.porosity) water += 7 * eps / n;
    EXPECT_NEAR(water, 3.5 * 0.4 + 3.5, 0.01);   // of 4.9: the quadrature of the lattice inside, 0.2 %
}

TEST(PorousField, DragHasNoTailInTheWaterAboveABed)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 8}, sand(0.4, 0.001)).build();
    std::vector<Vec<2>> x;
    for (int k = 0; k < 100; ++k) x.push_back({6.5, 6 + 0.04 * k});
    const PorousState<2> state = stateAt(scene, x);
    const Real whole = scene.porous->zones()[0].resistance.linear;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Real factor = state.linear[i] / whole, phi = state.share[i];
        EXPECT_NEAR(factor, std::clamp((phi - 0.5) / 0.2 + 0.5, 0.0, 1.0), exact);
        if (std::abs(x[i][1] - 8) > 0.5) {
            EXPECT_NEAR(factor, x[i][1] < 8, exact) << "at " << x[i][1];
        }
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
    // Inside soil the gradient is that of the quadrature, against 1/(3 d0) and more at a surface.
    for (const Vec<2>& n : stateAt<2>(scene, {{0.3, 6.5}, {6.5, 0.3}, {6.2, 6.5}}).normal)
        EXPECT_LT(norm(n), 0.02);
}

TEST(PorousField, BetweenTwoZonesIsTheirMean)
{
    const auto scene = SceneBuilder<2>(1).soil({0, 0}, {12, 6}, sand(0.3, 0.001))
                           .soil({0, 6}, {12, 12}, sand(0.5, 0.01)).build();
    const auto& zones = scene.porous->zones();
    const PorousState<2> state = stateAt<2>(scene, {{6.5, 2.5}, {6.5, 6}, {6.5, 9.5}});
    EXPECT_NEAR(state.porosity[0], 0.3, exact);
    EXPECT_NEAR(state.porosity[1], 0.4, 0.005);      // between the rows: quadrature
    EXPECT_NEAR(state.porosity[2], 0.5, exact);
    EXPECT_NEAR(state.linear[0] / zones[0].resistance.linear, 1, exact);
    EXPECT_NEAR(state.linear[1] / (zones[0].resistance.linear + zones[1].resistance.linear), 0.5, 1e-9);
    EXPECT_NEAR(state.linear[2] / zones[1].resistance.linear, 1, exact);
    EXPECT_NEAR(state.share[1], 1, 0.01);
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
    ASSERT_EQ(state.solidsDivergence.size(), 1u);
    EXPECT_EQ(state.solidsDivergence[0], 0);   // at rest
}

}  // namespace
