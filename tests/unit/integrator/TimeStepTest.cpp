// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "core/Error.hpp"
#include "integrator/TimeStep.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

Scheme<2> scheme()
{
    Scheme<2> s;
    s.spacing = 0.01, s.h0 = 0.015, s.force = {0, -9.81};
    return s;
}
constexpr Real none = 1e9;   // a limit that does not act

TEST(TimeStep, CourantRateUsesThePoreVelocityOverTheLocalSpacing)
{
    Water<2> water;
    water.resize(2);
    water.u = {{3, 4}, {0, 1}};
    const CourantNumber c = courantRate<2>(scheme(), water, std::vector<Real>{0.25, 1});
    EXPECT_NEAR(c.max, 5 * 0.5 / 0.01, 1e-10);               // the spacing in soil is 0.02
    EXPECT_NEAR(c.mean, (250 + 100) / 2.0, 1e-10);
}

TEST(TimeStep, IsTheSmallestOfItsLimits)
{
    const Scheme<2> s = scheme();
    EXPECT_EQ(stepSize<2>(s, 0.2, none, none, 0, 2000, {}), 1e-4);                        // Courant
    EXPECT_EQ(stepSize<2>(s, 0.2, 3e-4, none, 0, 0, {}), 3e-4);  // maxDeltaT
    EXPECT_EQ(stepSize<2>(s, 0.2, none, 2e-5, 0, 0, {}), 2e-5);  // the first step
    EXPECT_NEAR(stepSize<2>(s, 0.2, none, none, 0, 0, {}), 0.25 * std::sqrt(0.015 / 9.81), 1e-15);
    EXPECT_NEAR(stepSize<2>(s, 0.2, none, none, 1e-4, 0, {}), 1.2e-4, 1e-18);             // growth
    const std::vector<Real> eddy = {0, 0.1, 0};
    EXPECT_NEAR(stepSize<2>(s, 0.2, none, none, 0, 0, eddy), 0.125 * sqr(0.015) / (0.1 + 1e-6),
                1e-15);
}

TEST(TimeStep, AFlowThatBecameUnstableEndsTheRun)
{
    EXPECT_THROW(stepSize<2>(scheme(), 0.2, none, 1e-3, 0, 1e9, {}), FatalError);
}

TEST(TimeStep, AStepThatShrankByDegreesEndsTheRunAsWell)
{
    // Each step is half of the one before: the growth limit is never far, the calm step is.
    Real dt = 1e-3;
    const auto shrink = [&] {
        for (int n = 0; n < 100; ++n)
            dt = stepSize<2>(scheme(), 0.2, none, 1e-3, dt, 0.2 / (dt / 2), {});
    };
    EXPECT_THROW(shrink(), FatalError);
    EXPECT_GT(dt, 1e-5 * 1e-3 / 2);
}

TEST(TimeStep, WaterThatIsFastFromTheStartIsNoCollapse)
{
    Scheme<2> calm = scheme();
    calm.force = {}, calm.viscosity = 0;
    const Real rate = 100 / calm.spacing;
    EXPECT_DOUBLE_EQ(stepSize<2>(calm, 0.2, none, 1e3, 0, rate, {}, rate), 0.2 / rate);
    EXPECT_DOUBLE_EQ(stepSize<2>(calm, 0.2, none, 1e3, 0.2 / rate, rate, {}, rate), 0.2 / rate);
}

std::string messageOf(const std::function<void()>& f)
{
    try {
        f();
    } catch (const FatalError& error) {
        return error.what();
    }
    return "";
}

TEST(TimeStep, AGivenStepBeyondItsLimitIsRefusedWithTheLimit)
{
    const Scheme<2> s = scheme();
    EXPECT_NO_THROW(requireStableStep<2>(s, 1e-3, 999, {}));
    EXPECT_NE(messageOf([&] { requireStableStep<2>(s, 1e-2, 400, {}); }).find("limit is 0.0025 s"),
              std::string::npos);
    const std::vector<Real> eddy = {0, 0.1 - 1e-6};
    EXPECT_NO_THROW(requireStableStep<2>(s, 3e-4, 0, eddy));
    EXPECT_NE(
        messageOf([&] { requireStableStep<2>(s, 4e-4, 0, eddy); }).find("limit is 0.000315 s"),
        std::string::npos);
}

TEST(TimeStep, AStateThatIsNoNumberNamesItsParticle)
{
    Water<2> water;
    water.resize(3);
    water.id = {5, 6, 7};
    EXPECT_NO_THROW(requireFinite<2>(water, 1, 1e-3));
    water.u[1][0] = std::nan("");
    try {
        requireFinite<2>(water, 1, 1e-3);
        FAIL();
    } catch (const FatalError& error) {
        EXPECT_NE(std::string(error.what()).find("particle 6"), std::string::npos) << error.what();
    }
}

TEST(StepWeights, DifferentiateAQuadraticExactly)
{
    // (u^{n+1} - now u^n - before u^{n-1})/dt' of u = t^2 at t = 0: steps 0.3 after 0.2
    const StepWeights w{0.3, 0.3 / 0.2};
    const auto u = [](Real t) { return sqr(t); };
    EXPECT_NEAR((u(0.5) - w.now() * u(0.2) - w.before() * u(0)) / w.dtPrime(), 2 * 0.5, 1e-14);
    EXPECT_NEAR(w.now() + w.before(), 1, 1e-15);
}

}  // namespace
