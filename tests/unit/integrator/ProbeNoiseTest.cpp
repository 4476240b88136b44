// SPDX-License-Identifier: GPL-3.0-or-later
// What a pressure gauge in a tank would record from step to step.
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isph;

namespace {

constexpr Real L = 0.4, H = 0.2, pi = 3.141592653589793;
constexpr Real rhogH = 1000 * 9.81 * H;

/// Pressure at a point, by the plane that fits best to the particles within three spacings.
Real pressureAt(const Water<2>& water, const Vec<2>& at, Real spacing)
{
    const Real reach = 3 * spacing;
    Real W = 0, WP = 0;
    Vec<2> Wx, WxP;
    Mat<2> Wxx;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<2> x = water.x[i] - at;
        const Real w = sqr(std::max(Real(0), 1 - normSqr(x) / sqr(reach)));
        W += w, WP += w * water.p[i], Wx += w * x, WxP += w * water.p[i] * x;
        Wxx += outer(w * x, x);
    }
    for (int d = 0; d < 2; ++d) Wxx[d] -= (Wx[d] / W) * Wx;
    return WP / W - dot(Wx, inverse(Wxx) * (WxP - (WP / W) * Wx)) / W;
}

/// Jumps of a pressure from step to step, of rho g H: the largest, and what 99 of 100 do not
/// exceed.
struct Noise {
    Real largest, usual;
};

/// Of the pressure on a side wall, from 0.1 to 0.5 s, in water that sloshes in its first mode with
/// a surface that rises by `amplitude`.
Noise noiseOfGauge(Real amplitude, Real dt, Real shaken,
                   Stabilisation stabilisation = Stabilisation::relaxedDensity)
{
    constexpr Real spacing = 0.01, k = pi / L, from = 0.1, duration = 0.5;
    Scene<2> scene = SceneBuilder<2>(spacing)
                         .water({0, 0}, {L, H})
                         .shakeWater(shaken)
                         .openTank({0, 0}, {L, 0.3})
                         .build();
    scene.scheme.stabilisation = stabilisation, scene.scheme.alpha = 0.3;
    const Real speed = amplitude * std::sqrt(9.81 * k * std::tanh(k * H)) / std::sinh(k * H);
    for (std::size_t i = 0; i < scene.water.size(); ++i) {
        const Vec<2> x = scene.water.x[i];
        scene.water.u[i] = {-speed * std::sin(k * x[0]) * std::cosh(k * x[1]),
                            speed * std::cos(k * x[0]) * std::sinh(k * x[1])};
        scene.water.uOld[i] = scene.water.u[i];
    }
    Real last = 0;
    std::vector<Real> jumps;
    advance<2>(scene, dt, static_cast<int>(duration / dt), [&](int n, const StepFields<2>&) {
        const Real p = pressureAt(scene.water, {0, 0.05}, spacing);
        EXPECT_NEAR(p, 0.75 * rhogH, 0.2 * rhogH) << "at " << n * dt << " s";
        if (n * dt > from) jumps.push_back(std::abs(p - last) / rhogH);
        last = p;
    });
    std::sort(jumps.begin(), jumps.end());
    return {jumps.back(), jumps[jumps.size() * 99 / 100]};
}

// Gentle sloshing changes the pressure by 0.03 % of rho g H in a step of 1 ms; what is more is
// noise.
TEST(PressureGauge, IsQuietInWaterThatSloshes)
{
    const Noise noise = noiseOfGauge(0.04 * H, 1e-3, 0);
    EXPECT_LT(noise.largest, 0.02);
    EXPECT_LT(noise.usual, 0.001);
}

// What changes within a step, as the place of the surface, shows as 1/dt; a packing that is
// repaired by a share of its error in every step makes such noise all the time.
TEST(PressureGauge, IsQuietInSmallSteps)
{
    const Noise noise = noiseOfGauge(0.04 * H, 2.5e-4, 0);
    EXPECT_LT(noise.largest, 0.02);
    EXPECT_LT(noise.usual, 0.001);
    EXPECT_GT(noiseOfGauge(0.04 * H, 2.5e-4, 0, Stabilisation::constantAlpha).usual, 0.001);
}

TEST(PressureGauge, IsQuietInWaterAtRest)
{
    EXPECT_LT(noiseOfGauge(0, 1e-3, 0).largest, 1e-6);
}

// Particles of a disordered packing move until it has settled.
TEST(PressureGauge, IsQuietInADisorderedPacking)
{
    EXPECT_LT(noiseOfGauge(0.04 * H, 1e-3, 0.1).largest, 0.02);
}

}  // namespace
