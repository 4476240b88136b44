// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "integrator/Corrector.hpp"
#include "integrator/FaceCarry.hpp"
#include "integrator/Predictor.hpp"

#include <gtest/gtest.h>

#include <cstring>

using namespace isph;

namespace {

const std::string sand =
    "porousModel akbari; akbariCoeffs { porosity 0.4; D50 0.002; alphaC 1000; betaC 1.1; }";

/// Some 1000 particles, so that every loop is shared: water that falls on soil, periodic in x.
Scene<2> disturbed()
{
    Scene<2> scene = SceneBuilder<2>(0.01)
                         .water({0, 0.1}, {0.48, 0.3})
                         .waterCells({0, 0}, {0.48, 0.1}, {32, 6})
                         .shakeWater(0.2)
                         .soil({0, 0}, {0.48, 0.1}, sand)
                         .tank({0, 0}, {0.48, 0.5},
                               [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 0.48; })
                         .periodic({0, 0}, {0.48, 0.5}, {true, false})
                         .build();
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        scene.water.u[i] = scene.water.uOld[i] = {std::sin(20 * scene.water.x[i][1]),
                                                  std::cos(13 * scene.water.x[i][0])};
    return scene;
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// f() with that number of threads.
template <class F>
auto with(int threads, F&& f)
{
    const int before = threadCount();
    setThreadCount(threads);
    auto result = f();
    setThreadCount(before);
    return result;
}

struct OneStep {
    std::vector<Vec<2>> predicted, corrected, force;
};

/// The fields of a step, for its parts to be called one by one.
struct StepInParts : ProjectionStep<2> {
    using ProjectionStep<2>::ProjectionStep;
    using ProjectionStep<2>::fields_;
    StepReport advance(Real, Real) override { return {}; }
    void release() override {}
};

/// Predictor and corrector of a disturbed scene, under the pressure of a polynomial.
OneStep predictAndCorrect()
{
    Scene<2> scene = disturbed();
    Timers timers;
    StepInParts step(scene, timers);
    step.look();
    StepFields<2>& fields = step.fields_;
    fields.resistance = fields.soil.linear;
    fields.resistance.resize(fields.points.fluid);
    fields.points.refresh(fields.resistance);
    const StepWeights weights{1e-3, 0.8};
    const auto end = fields.soil.porosity.begin() + fields.points.water;
    scene.water.porosity.assign(fields.soil.porosity.begin(), end),
        scene.water.porosityOld = scene.water.porosity;
    for (Real& eps : scene.water.porosityOld) eps = 0.9 * eps;   // as if all had come to a face
    carryThroughFaces(scene.water, weights, fields);
    const WaterInSoil<2> medium{weights.dtPrime(),    fields.soil,   fields.resistance,
                                scene.scheme.spacing, fields.face.v, fields.face.carriesDarcy};
    predict(scene.water, scene.wallCloud, medium, scene.scheme, weights, fields);
    OneStep result;
    result.predicted = fields.v;
    for (const Vec<2>& x : fields.points.x) fields.p.push_back(10 * sqr(x[1]) - x[0]);
    correct(medium, scene.scheme, fields, scene.water);
    result.corrected = scene.water.u, result.force = scene.water.forceGradient;
    return result;
}

TEST(PredictorAndCorrector, OneAndThreeThreadsAgreeBitForBit)
{
    const OneStep one = with(1, predictAndCorrect), three = with(3, predictAndCorrect);
    EXPECT_TRUE(sameBits(one.predicted, three.predicted));
    EXPECT_TRUE(sameBits(one.corrected, three.corrected));
    EXPECT_TRUE(sameBits(one.force, three.force));
}

TEST(Step, OneAndThreeThreadsAgreeBitForBitAfterTenSteps)
{
    for (const char* solver : {"PCG", "lagCholmod", "cholmod"}) {
        const auto run = [&] {
            Scene<2> scene = disturbed();
            scene.solver = PressureSolver::select(Dictionary::parse(
                std::string("solver ") + solver + "; tolerance 1e-8; maxIter 2000;"));
            advance(scene, 5e-4, 10);
            return std::move(scene.water);
        };
        const Water<2> one = with(1, run), three = with(3, run);
        EXPECT_TRUE(sameBits(one.x, three.x)) << solver;
        EXPECT_TRUE(sameBits(one.u, three.u)) << solver;
        EXPECT_TRUE(sameBits(one.p, three.p)) << solver;
    }
}

}  // namespace
