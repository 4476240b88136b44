// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"
#include "integrator/Predictor.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

const std::string sand =
    "porousModel akbari; akbariCoeffs { porosity 0.4; D50 0.002; alphaC 1000; betaC 1.1; }";

/// The matrix of a scene as it stands, water at rest, with dt = 1 ms.
template <int Dim>
struct Equation {
    explicit Equation(Scene<Dim>& scene)
    {
        Timers timers;
        DragImplicitStep<Dim> step(scene, timers);
        step.look();
        const StepFields<Dim>& fields = step.fields();
        const std::vector<Vec<Dim>> v(fields.points.fluid);
        const std::vector<Real> divergence(fields.points.water, 0);
        const PressureSource<Dim> source{v, scene.water.forceGradient, divergence,
                                         scene.scheme.force};
        rows.number(fields.role, fields.points.water);
        const auto with = [&](const auto& medium) {
            assemble(fields.points, fields.pairs, fields.corrections, fields.role, medium, source,
                     rows, matrix, rhs, anchored);
        };
        std::vector<Real> resistance(fields.soil.linear);
        resistance.resize(fields.points.fluid);
        if (scene.porous) fields.points.refresh(resistance);
        if (scene.porous)
            with(WaterInSoil<Dim>{1e-3, fields.soil, resistance, scene.scheme.spacing});
        else with(ClearWater<Dim>{1e-3});
    }
    PressureRows rows;
    SymmetricMatrix matrix;
    std::vector<Real> rhs;
    std::vector<char> anchored;
};

Real entry(const SymmetricMatrix& m, Index row, Index column)
{
    for (PairIndex k = m.rowStart[row]; k < m.rowStart[row + 1]; ++k)
        if (m.column[k] == column) return m.offDiagonal[k];
    return 0;
}

void expectASymmetricMMatrix(const SymmetricMatrix& m, const std::vector<char>& anchored)
{
    ASSERT_GT(m.size(), 0u);
    std::size_t free = 0, held = 0;
    Real excess = 0;
    for (Index r = 0; r < static_cast<Index>(m.size()); ++r) {
        Real sum = m.diagonal[r];
        ASSERT_GT(m.diagonal[r], 0);
        for (PairIndex k = m.rowStart[r]; k < m.rowStart[r + 1]; ++k) {
            ASSERT_TRUE(k == m.rowStart[r] || m.column[k - 1] < m.column[k]);
            ASSERT_LE(m.offDiagonal[k], 0);
            ASSERT_NEAR(m.offDiagonal[k], entry(m, m.column[k], r),
                        1e-12 * m.diagonal[r]);  // images: round-off of x
            sum += m.offDiagonal[k];
        }
        if (anchored[r]) {
            ASSERT_GT(sum, -1e-13 * m.diagonal[r]);  // a surface particle may only just be in reach
            excess = std::max(excess, sum / m.diagonal[r]);
            ++held;
        } else {
            ASSERT_NEAR(sum, 0, 1e-13 * m.diagonal[r]);
            ++free;
        }
    }
    EXPECT_GT(free, 0u);
    EXPECT_TRUE(held == 0 || excess > 0.1);   // of a row below the surface row
}

TEST(PressureMatrix, IsSymmetricWithNonPositiveOffDiagonalsAndZeroRowSumsAwayFromTheSurface)
{
    Scene<2> flat = SceneBuilder<2>(0.01).water({0, 0}, {0.16, 0.12}).shakeWater(0.2)
                        .openTank({0, 0}, {0.16, 0.2}).build();
    const Equation<2> two(flat);
    expectASymmetricMMatrix(two.matrix, two.anchored);
    Scene<3> deep = SceneBuilder<3>(0.01).water({0, 0, 0}, {0.08, 0.08, 0.08}).shakeWater(0.2)
                        .openTank({0, 0, 0}, {0.08, 0.08, 0.2}).build();
    const Equation<3> three(deep);
    expectASymmetricMMatrix(three.matrix, three.anchored);
}

TEST(PressureMatrix, IsSymmetricAcrossASoilSurfaceAndThroughPeriodicSides)
{
    Scene<2> scene = SceneBuilder<2>(0.01)
                         .water({0, 0.1}, {0.24, 0.2})
                         .waterCells({0, 0}, {0.24, 0.1}, {16, 6})
                         .shakeWater(0.2)
                         .soil({0, 0}, {0.24, 0.1}, sand)
                         .tank({0, 0}, {0.24, 0.3},
                               [](const Vec<2>& x) { return x[1] > 0 || x[0] < 0 || x[0] > 0.24; })
                         .periodic({0, 0}, {0.24, 0.3}, {true, false})
                         .build();
    const Equation<2> equation(scene);
    expectASymmetricMMatrix(equation.matrix, equation.anchored);
}

TEST(PressureMatrix, OfAFullPeriodicBoxHasNoAnchoredRow)
{
    Scene<2> scene = SceneBuilder<2>(0.01).water({0, 0}, {0.12, 0.12}).shakeWater(0.2)
                         .periodic({0, 0}, {0.12, 0.12}, {true, true}).build();
    const Equation<2> equation(scene);
    EXPECT_EQ(equation.rows.size(), scene.water.size());
    expectASymmetricMMatrix(equation.matrix, equation.anchored);
}

TEST(PressureRows, AreTheParticlesThatAreNotAtTheSurface)
{
    PressureRows rows;
    rows.number({SurfaceRole::inner, SurfaceRole::surface, SurfaceRole::near, SurfaceRole::surface},
                3);
    EXPECT_EQ(rows.row, (std::vector<Index>{0, -1, 1}));
    EXPECT_EQ(rows.particle, (std::vector<Index>{0, 2}));
}

/// A lattice at rest: p = rho g below the surface, half a spacing above the centres of its row, to
/// the solver's tolerance times the condition of some hundred unknowns.
template <int Dim>
void expectHydrostaticPressure(Scene<Dim> scene, Real level)
{
    advance(scene, 1e-3, 1);
    for (std::size_t i = 0; i < scene.water.size(); ++i)
        ASSERT_NEAR(scene.water.p[i], 9810 * (level - scene.water.x[i][Dim - 1]),
                    1e-8 * 9810 * level)
            << "height " << scene.water.x[i][Dim - 1];
}

TEST(Pressure, OfALatticeAtRestIsHydrostaticExactly)
{
    expectHydrostaticPressure<2>(SceneBuilder<2>(0.01).water({0, 0}, {0.12, 0.1})
                                     .openTank({0, 0}, {0.12, 0.2}).build(), 0.1);
    expectHydrostaticPressure<3>(SceneBuilder<3>(0.01).water({0, 0, 0}, {0.07, 0.07, 0.08})
                                     .openTank({0, 0, 0}, {0.07, 0.07, 0.16}).build(), 0.08);
}

TEST(Pressure, OverSubmergedSoilIsHydrostaticExactly)
{
    expectHydrostaticPressure<2>(SceneBuilder<2>(0.01)
                                     .water({0, 0.1}, {0.12, 0.2})
                                     .waterCells({0, 0}, {0.12, 0.1}, {8, 6})
                                     .soil({0, 0}, {0.12, 0.1}, sand)
                                     .openTank({0, 0}, {0.12, 0.3})
                                     .build(),
                                 0.2);
}

}  // namespace
