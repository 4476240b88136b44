// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "integrator/Predictor.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

constexpr Real kPi = 3.141592653589793;

/// A step whose fields a test may change.
struct OpenStep : DragImplicitStep<2> {
    using DragImplicitStep<2>::DragImplicitStep;
    StepFields<2>& open() { return this->ProjectionStep<2>::fields_; }
};

/// Error of the friction of a shear wave of `length` spacings in a periodic square, of its amplitude: root
/// mean square over the particles. Spacing and viscosity are 1.
Real frictionError(int length, Real shaken, Real dissipation = 0, Real stretched = 1)
{
    const Real L = length, k = 2 * kPi / L;
    const std::array<int, 2> cells{static_cast<int>(std::lround(L / stretched)), static_cast<int>(std::lround(L * stretched))};
    Scene<2> scene = SceneBuilder<2>(1).viscosity(1).force({}).waterCells({0, 0}, {L, L}, cells).shakeWater(shaken)
                         .periodic({0, 0}, {L, L}, {true, true}).build();
    scene.scheme.dissipation = dissipation;
    Water<2>& water = scene.water;
    for (std::size_t i = 0; i < water.size(); ++i) water.u[i] = water.uOld[i] = {std::sin(k * water.x[i][1]), 0};
    Timers timers;
    OpenStep step(scene, timers);
    step.look();
    StepFields<2>& fields = step.open();
    const StepWeights weights{0.01, 0};
    predict(water, scene.wallCloud, ClearWater<2>{weights.dtPrime()}, scene.scheme, weights, fields);
    Real sum = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<2> rate = (fields.v[i] - water.u[i]) / weights.dt;
        sum += normSqr(rate + k * k * water.u[i]);
    }
    return std::sqrt(sum / static_cast<Real>(water.size())) / (k * k / std::sqrt(Real(2)));
}

TEST(Friction, OfAnEvenPackingConvergesWithTheFourthOrder)
{
    const Real coarse = frictionError(16, 0), fine = frictionError(32, 0);
    EXPECT_LT(coarse, 5e-3);           // the plain sum of pairs is 2.4 % short
    EXPECT_GT(coarse / fine, 12);      // 16 in the limit
}

TEST(Friction, OfDisorderedWaterDoesNotSeeItsMeanShear)
{
    // What is left is the anisotropy of the packing; without the gradient term 30 %.
    EXPECT_LT(frictionError(32, 0.1), 0.1);
}

TEST(Friction, OfAPackingThatTheFlowHasDrawnOutIsIsotropic)
{
    EXPECT_LT(frictionError(40, 0, 0, 1.25), 5e-3);   // without second moments 10 %
}

TEST(Dissipation, LeavesToFrictionWhatItDoesByItself)
{
    // Largest 8 c_r |a| of this wave, 8 c_r k^3 r^4/12 = 0.4, is below the viscosity, 1.
    EXPECT_EQ(frictionError(32, 0, 1), frictionError(32, 0, 0));
}

}  // namespace
