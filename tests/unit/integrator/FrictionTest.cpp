// SPDX-License-Identifier: GPL-3.0-or-later
#include "../OpenStep.hpp"
#include "../SceneBuilder.hpp"
#include "boundaries/WallLaw.hpp"
#include "integrator/FaceCarry.hpp"
#include "integrator/FaceFilter.hpp"
#include "integrator/Predictor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace isph;

namespace {

constexpr Real kPi = 3.141592653589793;

constexpr StepWeights kStep{0.01, 0};

/// The fields of a scene after its predictor, without drag.
struct Predicted {
    explicit Predicted(Scene<2>& scene) : step(scene, timers)
    {
        step.look();
        const std::vector<Real> noDrag(fields().points.fluid, 0);
        if (scene.porous) {
            const auto porosity = fields().soil.porosity.begin();
            scene.water.porosity.assign(porosity, porosity + fields().points.water);
            scene.water.porosityOld = scene.water.porosity;
            carryThroughFaces(scene.water, kStep, fields());
        }
        if (scene.porous)
            in(scene, WaterInSoil<2>{kStep.dtPrime(), fields().soil, noDrag, scene.scheme.spacing});
        else in(scene, ClearWater<2>{kStep.dtPrime()});
    }
    template <class Medium>
    void in(const Scene<2>& scene, const Medium& medium)
    {
        predict(scene.water, scene.wallCloud, medium, scene.scheme, kStep, fields());
        if constexpr (Medium::hasSoil)
            filterAtFaces(scene.water, medium, scene.scheme, kStep, fields());
    }
    StepFields<2>& fields() { return step.open(); }

    Timers timers;
    OpenStep<2> step;
};

/// Error of the friction of a shear wave of `length` spacings in a periodic square, of its
/// amplitude: root mean square over the particles. Spacing and viscosity are 1.
Real frictionError(int length, Real shaken, Real dissipation = 0, Real stretched = 1)
{
    const Real L = length, k = 2 * kPi / L;
    const std::array<int, 2> cells{static_cast<int>(std::lround(L / stretched)),
                                   static_cast<int>(std::lround(L * stretched))};
    Scene<2> scene = SceneBuilder<2>(1)
                         .viscosity(1)
                         .force({})
                         .waterCells({0, 0}, {L, L}, cells)
                         .shakeWater(shaken)
                         .periodic({0, 0}, {L, L}, {true, true})
                         .build();
    scene.scheme.dissipation = dissipation;
    Water<2>& water = scene.water;
    for (std::size_t i = 0; i < water.size(); ++i)
        water.u[i] = water.uOld[i] = {std::sin(k * water.x[i][1]), 0};
    Predicted predicted(scene);
    const StepFields<2>& fields = predicted.fields();
    Real sum = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<2> rate = (fields.v[i] - water.u[i]) / kStep.dt;
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

/// Water at y < 20, soil of porosity 1/4 above, both shaken; v_x = y/1000, so slow that noise is
/// filtered, with a uniform stress. Largest friction within 12 spacings of the face over nu v'/d0.
Real frictionOfUniformStress(Real shaken)
{
    const Real eps = 0.25, face = 20, shear = 1e-3;
    Scene<2> scene =
        SceneBuilder<2>(1)
            .viscosity(1)
            .force({})
            .water({0, 0}, {20, face})
            .waterCells({0, face}, {20, 40}, {10, 10})
            .shakeWater(shaken)
            .soil({0, face}, {20, 40}, "porousModel darcy; darcyCoeffs { porosity 0.25; K 1; }")
            .periodic({0, 0}, {20, 40}, {true, true})
            .build();
    scene.scheme.dissipation = 0;
    Water<2>& water = scene.water;
    PorousState<2> state;
    scene.porous->evaluate(water.x, state);
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Real y = water.x[i][1], v = y < face ? y : face + eps * (y - face);
        water.u[i] = water.uOld[i] = {shear * v / state.porosity[i], 0};
    }
    Predicted predicted(scene);
    const StepFields<2>& fields = predicted.fields();
    Real largest = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        if (std::abs(water.x[i][1] - face) > 12) continue;
        const Vec<2> change = fields.v[i] - state.porosity[i] * water.u[i];
        largest = std::max(largest, norm(change) / (state.mobility[i] * kStep.dt * shear));
    }
    return largest;
}

TEST(Friction, OfAUniformStressThroughAFaceIsNone)
{
    // Media in series: v has a kink at the face. With the mean of both viscosities 0.13 and 0.18,
    // with nu grad v in place of the stress 0.04 and 0.08.
    EXPECT_LT(frictionOfUniformStress(0), 1e-6);
    EXPECT_LT(frictionOfUniformStress(0.1), 1e-6);
}

/// Change of the velocity of water at rest but for one particle, where passes before have left no
/// numbers behind.
Real changeAfterNoNumbers(Real viscosity, Real eddyViscosity)
{
    Scene<2> scene = SceneBuilder<2>(1)
                         .viscosity(viscosity)
                         .force({})
                         .waterCells({0, 0}, {20, 20}, {20, 20})
                         .periodic({0, 0}, {20, 20}, {true, true})
                         .build();
    scene.scheme.dissipation = 0;
    scene.water.u[210] = scene.water.uOld[210] = {1, 0};
    Timers timers;
    OpenStep<2> step(scene, timers);
    step.look();
    StepFields<2>& fields = step.open();
    if (eddyViscosity > 0) fields.eddyViscosity.assign(fields.points.fluid, eddyViscosity);
    constexpr int size = 16;
    const auto left = fields.pairs.records<size>();
    std::fill_n(left[0], size * fields.points.fluid, std::numeric_limits<Real>::quiet_NaN());
    predict(scene.water, scene.wallCloud, ClearWater<2>{kStep.dtPrime()}, scene.scheme, kStep,
            fields);
    return norm(fields.v[210] - scene.water.u[210]);
}

TEST(Friction, NeedsNothingWhereThereIsNone)
{
    EXPECT_EQ(changeAfterNoNumbers(0, 0), 0);
}

TEST(Friction, OfEddiesAloneIsThatOfAsMuchViscosity)
{
    EXPECT_GT(changeAfterNoNumbers(0, 1e-3), 0);
    EXPECT_EQ(changeAfterNoNumbers(0, 1e-3), changeAfterNoNumbers(1e-3, 0));
}

/// Largest change of velocity that dissipation makes in a step of a drop that a smooth flow
/// strains.
Real lossOfStrainedDrop(bool wholeAtSurface)
{
    SceneBuilder<2> builder(1);
    for (const Vec<2>& x : lattice<2>({-8, -8}, {8, 8}, {16, 16}))
        if (norm(x) < 8) builder.particle(x);   // round: at a corner gradients are not exact
    Scene<2> scene = builder.viscosity(0).force({}).shakeWater(0.05).build();
    scene.scheme.dissipation = 16;
    scene.scheme.wholeAtSurface = wholeAtSurface;
    Water<2>& water = scene.water;
    for (std::size_t i = 0; i < water.size(); ++i)
        water.u[i] = water.uOld[i] = {-water.x[i][0], water.x[i][1]};
    Predicted predicted(scene);
    const StepFields<2>& fields = predicted.fields();
    Real most = 0;
    for (std::size_t i = 0; i < water.size(); ++i)
        most = std::max(most, norm(fields.v[i] - water.u[i]));
    return most;
}

TEST(Dissipation, LeavesASmoothStrainAtTheSurfaceAloneWhereOnlyItsRoughPartDissipates)
{
    EXPECT_LT(lossOfStrainedDrop(false), 1e-12);
    EXPECT_GT(lossOfStrainedDrop(true), 0.1);
}

TEST(Dissipation, LeavesToFrictionWhatItDoesByItself)
{
    // Largest 8 c_r |a| of this wave, 8 c_r k^3 r^4/12 = 0.4, is below the viscosity, 1.
    EXPECT_EQ(frictionError(32, 0, 1), frictionError(32, 0, 0));
}

/// Share of its energy that dissipation takes in a step from a periodic square of 20 spacings: a
/// shear wave of unit speed times `wave` with random velocities up to `noise`. Spacing 1.
Real lossOf(Real wave, Real noise, Real nu)
{
    constexpr Real L = 20, k = 2 * kPi / L;
    const auto energyAfter = [&](Real dissipation) {
        Scene<2> scene = SceneBuilder<2>(1).viscosity(nu).force({}).water({0, 0}, {L, L})
                             .periodic({0, 0}, {L, L}, {true, true}).build();
        scene.scheme.dissipation = dissipation;
        Water<2>& water = scene.water;
        std::vector<Vec<2>> rough(water.size());
        shake(rough, noise);
        for (std::size_t i = 0; i < water.size(); ++i)
            water.u[i] = water.uOld[i] = rough[i] + Vec<2>{wave * std::sin(k * water.x[i][1]), 0};
        const Real before = kineticEnergy(water);
        Predicted predicted(scene);
        std::copy_n(predicted.fields().v.begin(), water.size(), water.u.begin());
        return kineticEnergy(water) / before;
    };
    return energyAfter(0) - energyAfter(16);
}

// The Reynolds number of the spacing is 0.3/nu, 8 c_r times the rough part of the wave up to 4.
TEST(Dissipation, LeavesAShearAloneThatFrictionResolves)
{
    EXPECT_EQ(lossOf(1, 0, 0.1), 0);
    EXPECT_GT(lossOf(1, 0, 0.01), 1e-5);
}

// The gradient of noise is of the size of noise: it tells no shear from it, rough parts do.
TEST(Dissipation, TakesNoiseHoweverViscousTheWaterIs)
{
    EXPECT_GT(lossOf(0, 1, 0.1), 0.01);
}

/// The force per area that a wall law takes from a uniform stream of `speed` over it, over the
/// density: the loss of momentum of all water. Spacing 1; the stream is 10 deep and 12 long. The
/// wall moves along itself.
Real dragOfStream(Real speed, Real nu, Real shaken, const Vec<2>& wallVelocity = {},
                  Real sinking = 0, Real lowered = 0)
{
    constexpr Real L = 12, depth = 10;
    SceneBuilder<2> builder(1);
    Scene<2> scene = builder.viscosity(nu)
                         .force({})
                         .water({0, 0}, {L, depth}, {speed, -sinking})
                         .shakeWater(shaken)
                         .tank({0, 0}, {L, 2 * depth},
                               [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > L; })
                         .periodic({0, 0}, {L, 2 * depth}, {true, false})
                         .build();
    for (Vec<2>& x : scene.water.x) x[1] -= lowered;
    WallCloud<2>& walls = scene.wallCloud;
    walls.wallLaw.assign(walls.size(), 1), walls.velocity.assign(walls.size(), wallVelocity);
    Predicted predicted(scene);
    Real loss = 0;
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        loss += (scene.water.u[i] - predicted.fields().v[i])[0] / kStep.dt;
    return loss / L;
}

TEST(WallLaw, TakesItsStressFromTheWaterAtTheWall)
{
    // speed = 8.3 u* (y u*/nu)^(1/7) at y = d0/2 with u* = 0.1 and nu = 1e-5; y u*/nu = 5000
    const Real speed = 8.3 * 0.1 * std::pow(5000, 1.0 / 7);
    EXPECT_NEAR(dragOfStream(speed, 1e-5, 0) / sqr(0.1), 1, 1e-10);
    EXPECT_NEAR(dragOfStream(-speed, 1e-5, 0) / sqr(0.1), -1, 1e-10);
}

TEST(WallLaw, SharesItsStressOverTheLayer)
{
    constexpr Real spacing = 0.02, step = 1e-4 * spacing;
    Real sum = 0;
    for (int k = 0; k < 20000; ++k) sum += step * wallLayer((k + 0.5) * step, spacing);
    EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(WallLaw, IsLaminarWhereTheLayerIsThick)
{
    EXPECT_NEAR(dragOfStream(1e-3, 1e-3, 0) / (1e-3 * 1e-3 / 0.5), 1, 1e-10);   // y u*/nu = 0.7
}

TEST(WallLaw, TakesItWhereverTheParticlesOfTheLayerStand)
{
    const Real still = dragOfStream(1, 1e-5, 0);
    EXPECT_NEAR(dragOfStream(1, 1e-5, 0.2) / still, 1, 0.05);
    EXPECT_NEAR(dragOfStream(1, 1e-5, 0, {}, 0, 0.2) / still, 1,
                1e-10);  // the stress of half a spacing
}

TEST(WallLaw, IsThatOfTheSpeedAlongTheWallRelativeToIt)
{
    const Real still = dragOfStream(1, 1e-5, 0);
    EXPECT_EQ(dragOfStream(1, 1e-5, 0, {1, 0}), 0);
    EXPECT_NEAR(dragOfStream(3, 1e-5, 0, {2, 0}) / still, 1, 1e-10);
    EXPECT_NEAR(dragOfStream(0, 1e-5, 0, {1, 0}) / still, -1, 1e-10);
    EXPECT_NEAR(dragOfStream(1, 1e-5, 0, {}, 0.5) / still, 1, 1e-10);   // water that falls on it
}

TEST(WallLaw, OfAFrictionlessFluidIsNone)
{
    EXPECT_EQ(dragOfStream(1, 0, 0.2), 0);
}

}  // namespace
