// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

constexpr Real g = 9.81, dt = 1e-3;
constexpr int steps = 300;

/// Lattice points within R of the origin.
template <int Dim>
Scene<Dim> drop(Real spacing, int cells)
{
    SceneBuilder<Dim> builder(spacing);
    const Real R = cells * spacing;
    Vec<Dim> low, high;
    std::array<int, Dim> count;
    for (int d = 0; d < Dim; ++d) low[d] = -R, high[d] = R, count[d] = 2 * cells;
    for (const Vec<Dim>& x : lattice<Dim>(low, high, count))
        if (norm(x) < R) builder.particle(x);
    return builder.build();
}

template <int Dim>
Vec<Dim> centre(const std::vector<Vec<Dim>>& x)
{
    Vec<Dim> sum;
    for (const Vec<Dim>& p : x) sum += p;
    return sum / static_cast<Real>(x.size());
}

/// A drop falls as a body, keeps its shape and has no pressure. (1e-5 d0, 1e-6 of rho g R; the way
/// 0.1 %, for the first step is Euler's)
template <int Dim>
void expectAFall(Scene<Dim> scene, Real R)
{
    const std::vector<Vec<Dim>> before = scene.water.x;
    Real highest = 0;
    advance<Dim>(scene, dt, steps, [&](int, const StepFields<Dim>&) {
        for (const Real p : scene.water.p) highest = std::max(highest, std::abs(p));
    });
    const Real fallen = g * sqr(steps * dt) / 2;
    const Vec<Dim> moved = centre(scene.water.x) - centre(before);
    EXPECT_NEAR(moved[Dim - 1], -fallen, 1e-3 * fallen);
    EXPECT_LT(std::abs(moved[0]), 1e-6 * fallen);
    for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_LT(norm(scene.water.x[i] - before[i] - moved), 1e-5 * scene.scheme.spacing);
    EXPECT_LT(highest, 1e-6 * 1000 * g * R);
}

TEST(FreeFall, ADropFallsAsABodyInTwoDimensions)
{
    expectAFall(drop<2>(0.005, 10), 0.05);
}

TEST(FreeFall, ADropFallsAsABodyInThreeDimensions)
{
    expectAFall(drop<3>(0.01, 5), 0.05);
}

TEST(FreeFall, ASingleParticleFallsExactly)
{
    Scene<2> scene = SceneBuilder<2>(0.01).particle({0.3, 1}).build();
    advance(scene, dt, steps);
    // The first step is Euler's and its move takes the velocity 0: g dt^2/2 behind, ever after.
    EXPECT_NEAR(scene.water.x[0][1], 1 - g * (sqr(steps * dt) - sqr(dt)) / 2, 1e-12);
    EXPECT_NEAR(scene.water.u[0][1], -g * steps * dt, 1e-12);
    EXPECT_EQ(scene.water.x[0][0], 0.3);
    EXPECT_EQ(scene.water.p[0], 0);
}

TEST(FreeFall, ADropKeepsItsSidewaysSpeed)
{
    Scene<2> scene = drop<2>(0.005, 6);
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        scene.water.u[i] = scene.water.uOld[i] = {2, 1};
    const Vec<2> before = centre(scene.water.x);
    advance(scene, dt, steps);
    const Real t = steps * dt;
    const Vec<2> moved = centre(scene.water.x) - before;
    EXPECT_NEAR(moved[0], 2 * t, 1e-6);
    EXPECT_NEAR(moved[1], t - g * sqr(t) / 2, 1e-3 * g * sqr(t) / 2);
}

}  // namespace
