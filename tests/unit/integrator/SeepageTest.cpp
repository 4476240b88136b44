// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

using namespace isph;

namespace {

/// A periodic column, its middle half soil, driven by a body force f: f L = (a v + b v^2) L/2.
struct DarcyColumn {
    Real D50;
    int cells;                         ///< over the column of 1 m
    Real f = 0.981;

    Scene<2> scene() const
    {
        const Real d0 = 1.0 / cells, width = 12.0 / 40;
        const std::array<int, 2> pores = {cells * 8 / 40,
                                          cells * 12 / 40};  // 0.15 m2 of soil, 0.06 m2 of pores
        return SceneBuilder<2>(d0)
            .force({0, -f})
            .water({0, 0}, {width, 0.25})
            .waterCells({0, 0.25}, {width, 0.75}, pores)
            .water({0, 0.75}, {width, 1})
            .soil({0, 0.25}, {width, 0.75},
                  "porousModel akbari; akbariCoeffs { porosity 0.4; D50 " + fmt::format("{}", D50) +
                      "; alphaC 1000; betaC 1.1; }")
            .periodic({0, 0}, {width, 1}, {true, true})
            .build();
    }
    /// Mean discharge in the soil, where the share of soil is whole, over the last third [m/s]. The
    /// start dies away at the rate a + 2 b v, 100/s in the coarsest grains.
    Real discharge() const
    {
        Scene<2> s = scene();
        Real sum = 0, volume = 0;
        const int steps = D50 > 5e-3 ? 600 : 150;
        advance<2>(s, 1e-3, steps, [&](int n, const StepFields<2>& fields) {
            if (3 * n <= 2 * steps) return;
            for (std::size_t i = 0; i < s.water.size(); ++i) {
                if (fields.soil.share[i] < 0.95) continue;
                sum -= fields.points.volume[i] * fields.soil.porosity[i] * s.water.u[i][1];
                volume += fields.points.volume[i];
            }
        });
        return sum / volume;
    }
    Real exact() const
    {
        const Real n = 0.4, a = 1000 * 1e-6 * sqr(1 - n) / (cube(n) * sqr(D50)),
                   b = 1.1 * (1 - n) / (cube(n) * D50);
        return 4 * f / (a + std::sqrt(sqr(a) + 8 * b * f));
    }
    Real error() const { return std::abs(discharge() / exact() - 1); }
};

/// What a step makes of the steady flow v through the column when every particle has it already:
/// the largest difference from v over v. `layers` of the soil, beneath and above 0.5 m, in an even
/// or an uneven packing.
Real changeOfSteadyFlow(const std::array<std::string, 2>& layers, Real shaken)
{
    constexpr Real f = 0.981, dt = 1e-3;
    Scene<2> s = SceneBuilder<2>(0.025)
                     .force({0, -f})
                     .water({0, 0}, {0.3, 0.25})
                     .waterCells({0, 0.25}, {0.3, 0.75}, {8, 12})
                     .water({0, 0.75}, {0.3, 1})
                     .shakeWater(shaken)
                     .soil({0, 0.25}, {0.3, 0.5}, layers[0])
                     .soil({0, 0.5}, {0.3, 0.75}, layers[1])
                     .periodic({0, 0}, {0.3, 1}, {true, true})
                     .build();
    // Uneven packings are at rest without these.
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0;
    const auto& zones = s.porous->zones();
    const Real v = 4 * f / (zones[0].resistance.linear + zones[1].resistance.linear);
    PorousState<2> state;
    s.porous->evaluate(s.water.x, state);
    for (std::size_t i = 0; i < s.water.size(); ++i)
        s.water.u[i] = s.water.uOld[i] = {0, -v / state.porosity[i]};
    Real worst = 0;
    advance<2>(s, dt, 3, [&](int, const StepFields<2>& fields) {
        for (std::size_t i = 0; i < s.water.size(); ++i) {
            const Vec<2> difference = fields.soil.porosity[i] * s.water.u[i] - Vec<2>{0, -v};
            worst = std::max(worst, norm(difference) / v);
        }
    });
    return worst;
}

std::string permeable(Real K)
{
    return fmt::format("porousModel darcy; darcyCoeffs {{ porosity 0.4; K {}; }}", K);
}

class Darcy : public testing::TestWithParam<Real> {};

// dt = 1 ms is 10 to 1e7 times what explicit drag would stand.
TEST_P(Darcy, DischargeIsExactAtEverySpacing)
{
    // The solver's tolerance, 1e-11, times the condition of a thousand unknowns. Through the
    // coarsest grains, at 0.1 m/s, rows of particles pass the faces one after the other.
    const Real bound = GetParam() > 5e-3 ? 1e-3 : 1e-5;
    EXPECT_LT((DarcyColumn{GetParam(), 40}.error()), bound);
    EXPECT_LT((DarcyColumn{GetParam(), 80}.error()), bound);
}

INSTANTIATE_TEST_SUITE_P(GrainSizes, Darcy, testing::Values(1e-2, 1e-3, 1e-4, 1e-5),
                         [](const auto& grains) {
                             return fmt::format("{:.0f}Micrometres", grains.param * 1e6);
                         });

TEST(SteadySeepage, ThroughFacesIsAnExactSolution)
{
    // In a step water moves by a millionth of a spacing, and its porosity changes by as much.
    const Real moves = 1e-4;
    EXPECT_LT(changeOfSteadyFlow({permeable(1e-10), permeable(1e-10)}, 0), moves);
    EXPECT_LT(changeOfSteadyFlow({permeable(1e-10), permeable(1e-10)}, 0.1), moves);
    EXPECT_LT(changeOfSteadyFlow({permeable(1e-11), permeable(1e-8)}, 0.1), moves);
}

TEST(SteadySeepage, KeepsItsSpeedWhenRowsOfParticlesCrossTheFaces)
{
    // Twelve particles at once change their drag from one step to the next, by a tenth of their
    // momentum. A pressure equation that expects the force of the step before would change the flow
    // by 1 % in that step and back in the next.
    constexpr Real f = 0.981, dt = 1e-2, a = 50, v = 2 * f / a;
    Scene<2> s = SceneBuilder<2>(0.025)
                     .force({0, -f})
                     .water({0, 0}, {0.3, 0.25})
                     .waterCells({0, 0.25}, {0.3, 0.75}, {8, 12})
                     .water({0, 0.75}, {0.3, 1})
                     .soil({0, 0.25}, {0.3, 0.75}, permeable(1e-6 / a))
                     .periodic({0, 0}, {0.3, 1}, {true, true})
                     .build();
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0;
    PorousState<2> state;
    s.porous->evaluate(s.water.x, state);
    for (std::size_t i = 0; i < s.water.size(); ++i)
        s.water.u[i] = s.water.uOld[i] = {0, -v / state.porosity[i]};
    Real worst = 0;
    advance<2>(s, dt, 80,
               [&](int, const StepFields<2>& fields) {  // rows go 1.3 spacings in clear water
                   Real sum = 0, volume = 0;
                   for (std::size_t i = 0; i < s.water.size(); ++i) {
                       sum -= fields.points.volume[i] * fields.soil.porosity[i] * s.water.u[i][1];
                       volume += fields.points.volume[i];
                   }
                   worst = std::max(worst, std::abs(sum / volume / v - 1));
               });
    EXPECT_LT(worst, 2e-3);
}

TEST(SteadySeepage, StaysSmoothHoweverSmallTheStep)
{
    // Noise beside the faces that the projection cannot see would grow by a per cent a step,
    // whatever the step.
    Scene<2> s = SceneBuilder<2>(0.05)
                     .force({})
                     .water({0, 0}, {0.6, 0.25})
                     .waterCells({0, 0.25}, {0.6, 0.75}, {8, 6})
                     .water({0, 0.75}, {0.6, 1})
                     .soil({0, 0.25}, {0.6, 0.75}, permeable(1e-8))
                     .periodic({0, 0}, {0.6, 1}, {true, true})
                     .build();
    for (std::size_t i = 0; i < s.water.size(); ++i) {
        const auto k = static_cast<Real>(i * i);
        s.water.u[i] = s.water.uOld[i] = {1e-6 * std::sin(7 * k), 1e-6 * std::sin(5 * k)};
    }
    const auto noise = [&](int steps) {
        advance<2>(s, 1e-6, steps);
        Real sum = 0;
        for (const Vec<2>& u : s.water.u) sum += normSqr(u);
        return std::sqrt(sum);
    };
    const Real before = noise(50);
    EXPECT_LT(noise(350), before);   // without (7.6) 40 times as much
}

TEST(SandBed, LetsWaterBesideItFeelTheWholeForceAlongIt)
{
    // From rest a step gives clear water dt f k/eps = dt f/C_r, and that beside sand no less: half
    // of its partners conduct nothing. The lattice is even along the face, so that no pressure
    // stands against the force.
    constexpr Real f = 0.5, dt = 1e-3;
    Scene<2> s = SceneBuilder<2>(0.025)
                     .force({f, 0})
                     .water({0, 0}, {0.3, 0.25})
                     .waterCells({0, 0.25}, {0.3, 0.75}, {8, 12})
                     .water({0, 0.75}, {0.3, 1})
                     .soil({0, 0.25}, {0.3, 0.75}, permeable(1e-11))
                     .periodic({0, 0}, {0.3, 1}, {true, true})
                     .build();
    advance<2>(s, dt, 1, [&](int, const StepFields<2>& fields) {
        for (std::size_t i = 0; i < s.water.size(); ++i) {
            if (fields.soil.zone[i] != kClearWater) continue;
            const Real expected = dt * f * fields.soil.mobility[i] / fields.soil.porosity[i];
            EXPECT_NEAR(s.water.u[i][0] / expected, 1, 0.02) << "at " << s.water.x[i][1];
        }
    });
}

TEST(SandBed, IsNoNoSlipWallToTheWaterAboveIt)
{
    const Real d0 = 0.01, bed = 0.1, L = 0.24;
    Scene<2> scene = SceneBuilder<2>(d0)
                         .water({0, bed}, {L, 0.2}, {1, 0})
                         .waterCells({0, 0}, {L, bed}, {16, 6})
                         .soil({0, 0}, {L, bed},
                               "porousModel akbari; akbariCoeffs { porosity 0.4; D50 3e-4; alphaC "
                               "1000; betaC 1.1; }")
                         .tank({0, 0}, {L, 0.3},
                               [&](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > L; })
                         .periodic({0, 0}, {L, 0.3}, {true, false})
                         .build();
    advance(scene, 1e-3, 300);
    std::vector<Real> speed(20, 0), count(20, 0);
    for (std::size_t i = 0; i < scene.water.size(); ++i) {
        const auto layer =
            static_cast<std::size_t>(std::max(0.0, (scene.water.x[i][1] - bed) / d0));
        if (scene.water.x[i][1] > bed + d0 && layer < speed.size())
            speed[layer] += scene.water.u[i][0], count[layer] += 1;
    }
    int layers = 0;
    for (std::size_t k = 1; k < speed.size(); ++k) {
        if (count[k] < 12) continue;   // half a layer
        ++layers;
        EXPECT_NEAR(speed[k] / count[k], 1, 0.05) << "mean of layer " << k << " above the bed";
    }
    EXPECT_GE(layers, 8);
}

}  // namespace
