// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and disorder that take minutes.
#include "LayeredTank.hpp"
#include "SolverTesting.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {

int iterations(const LayeredTank& tank, const std::string& solver = "multigridPCG")
{
    const PressureSystem s = pressureSystem(tank);
    std::vector<Real> x(s.b.size(), 0);
    const SolverReport report = solverOf("solver " + solver + ";")->solve(s.matrix, s.b, x);
    EXPECT_TRUE(report.converged) << report.remark;
    EXPECT_LE(trueResidual(s.matrix, x, s.b), 1e-6 * norm(s.b) * (1 + 1e-6));
    return report.iterations;
}

}  // namespace

TEST(MultigridLong, IterationsAtAMillionRowsAreThoseAtTenThousand)
{
    for (const int dimension : {2, 3}) {
        LayeredTank tank;
        tank.dimension = dimension, tank.jump = 1e4;
        const int few = iterations(tank);
        tank.particles = 1e6;
        EXPECT_LE(iterations(tank), 1.3 * few) << dimension << "-D";
    }
}

TEST(MultigridLong, IterationsAtAJumpOfAMillionAreThoseAtNone)
{
    for (const int dimension : {2, 3})
        for (int layers = 0; layers < 3; ++layers) {
            LayeredTank tank;
            tank.dimension = dimension, tank.particles = 2e5;
            tank.layers = static_cast<LayeredTank::Layers>(layers);
            tank.jump = 1;
            const int even = iterations(tank);
            tank.jump = 1e6;
            EXPECT_LE(iterations(tank), 1.4 * even) << dimension << "-D, layers " << layers;
        }
}

TEST(MultigridLong, HypreNeedsAsManyIterationsOnTheSameMatrix)
{
    LayeredTank tank;
    tank.dimension = 3, tank.particles = 1e5;
    EXPECT_LE(iterations(tank), 1.5 * iterations(tank, "hypre"));
}
