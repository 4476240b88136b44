// SPDX-License-Identifier: GPL-3.0-or-later
// Water that fills a box: no surface, so that its pressure has no level of its own.
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

constexpr Real L = 0.16, k = 3.141592653589793 / L, U = 0.2;

/// A full box of shaken water with one vortex, free of divergence and along the walls.
Scene<2> vortex(Real nu)
{
    Scene<2> scene = SceneBuilder<2>(0.01).viscosity(nu).water({0, 0}, {L, L}).shakeWater(0.1)
                         .tank({0, 0}, {L, L}).build();
    for (std::size_t i = 0; i < scene.water.size(); ++i) {
        const Vec<2> x = scene.water.x[i];
        scene.water.u[i] = scene.water.uOld[i] = {U * std::sin(k * x[0]) * std::cos(k * x[1]),
                                                  -U * std::cos(k * x[0]) * std::sin(k * x[1])};
    }
    return scene;
}

void expectInside(const Water<2>& water)
{
    for (const Vec<2>& x : water.x)
        for (int d = 0; d < 2; ++d) {
            ASSERT_GT(x[d], 0);
            ASSERT_LT(x[d], L);
        }
}

TEST(SealedBox, AVortexComesToRestAsItsViscositySays)
{
    const Real nu = 0.01;
    Scene<2> scene = vortex(nu);
    const Real before = kineticEnergy(scene.water);
    Real halfway = 0;
    advance<2>(scene, 1e-3, 600, [&](int n, const StepFields<2>& fields) {
        for (const SurfaceRole role : fields.role) ASSERT_EQ(role, SurfaceRole::inner);
        if (n == 200) halfway = kineticEnergy(scene.water);
    });
    // Between slip walls u falls as exp(-2 nu k^2 t). 16 spacings a vortex: 10 % of the rate.
    EXPECT_NEAR(std::log(before / halfway) / (4 * nu * sqr(k) * 0.2), 1, 0.1);
    EXPECT_LT(kineticEnergy(scene.water), 1e-3 * before);
    expectInside(scene.water);
}

TEST(SealedBox, TheKineticEnergyOfWaterFalls)
{
    Scene<2> scene = vortex(1e-6);
    std::vector<Real> energy(1, kineticEnergy(scene.water));
    advance<2>(scene, 1e-3, 500, [&](int n, const StepFields<2>&) {
        if (n % 100 == 0) energy.push_back(kineticEnergy(scene.water));
    });
    for (std::size_t n = 1; n < energy.size(); ++n) EXPECT_LT(energy[n], energy[n - 1]);
    expectInside(scene.water);
}

TEST(SealedBox, ShakenWaterAtRestStaysSlow)
{
    Scene<2> scene =
        SceneBuilder<2>(0.01).water({0, 0}, {L, L}).shakeWater(0.2).tank({0, 0}, {L, L}).build();
    Real fastest = 0, meanPressure = 0;
    advance<2>(scene, 1e-3, 1000, [&](int, const StepFields<2>&) {
        for (const Vec<2>& u : scene.water.u) fastest = std::max(fastest, norm(u));
    });
    EXPECT_LT(fastest, 0.01 * std::sqrt(9.81 * L));
    for (const Real p : scene.water.p) meanPressure += p / static_cast<Real>(scene.water.size());
    EXPECT_NEAR(meanPressure, 0, 1e-6);   // the mean of a floating pressure is 0
}

}  // namespace
