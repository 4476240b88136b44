// SPDX-License-Identifier: GPL-3.0-or-later
// What cholmod and lagCholmod keep from step to step.
#include "SolverTesting.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {
SolverReport solveFromZero(PressureSolver& solver, const ParticleSystem& s)
{
    std::vector<Real> x(s.b.size(), 0);
    const SolverReport report = solver.solve(s.matrix, s.b, x);
    EXPECT_NEAR(report.finalResidual, trueResidual(s.matrix, x, s.b) / norm(s.b), 1e-11);
    return report;
}

/// The particles a little elsewhere: same rows, other coefficients, other pairs.
ParticleSystem moved(Real jitter)
{
    Scene scene(50, 40);
    scene.jitter = jitter;
    return particleSystem(scene);
}
}  // namespace

TEST(Cholmod, GivesTheSameBitsWithTheSymbolicFactorItKept)
{
    const ParticleSystem s = particleSystem(Scene(50, 40));
    ParticleSystem other = s;
    for (Real& d : other.matrix.diagonal) d *= 1.5;
    std::vector<Real> x(s.b.size(), 0), kept(s.b.size(), 0), fresh(s.b.size(), 0);
    const auto solver = solverOf("solver cholmod;");
    solver->solve(s.matrix, s.b, x);
    solver->solve(other.matrix, s.b, kept);
    solverOf("solver cholmod;")->solve(other.matrix, s.b, fresh);
    EXPECT_EQ(kept, fresh);
}

TEST(Cholmod, SolvesInOneIterationWhateverChangedSinceTheLastStep)
{
    const auto solver = solverOf("solver cholmod; tolerance 1e-9;");
    Scene grown(50, 41);
    for (const ParticleSystem& s :
         {moved(0.2), moved(0.21), moved(0.29), particleSystem(grown), moved(0.2)}) {
        const SolverReport report = solveFromZero(*solver, s);
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.iterations, 1);
    }
}

TEST(Cholmod, NoticesOtherColumnsInRowsOfTheSameLength)
{
    // rings: row i is coupled to i +- 1 and i +- stride, so rows of all rings have four entries
    const auto ring = [](std::size_t n, std::size_t stride) {
        ParticleSystem s{{}, {}, std::vector<Real>(n, 0)};
        s.matrix.diagonal.assign(n, 4.01);
        for (std::size_t i = 0; i < n; ++i) {
            s.b[i] = std::sin(0.01 * static_cast<Real>(sqr(static_cast<Real>(i))));
            for (const std::size_t j : {i + 1, i + n - 1, i + stride, i + n - stride})
                s.matrix.column.push_back(static_cast<Index>(j % n));
            std::sort(s.matrix.column.end() - 4, s.matrix.column.end());
            s.matrix.rowStart.push_back(static_cast<PairIndex>(s.matrix.column.size()));
        }
        s.matrix.offDiagonal.assign(s.matrix.column.size(), -1);
        return s;
    };
    const auto solver = solverOf("solver cholmod; tolerance 1e-9;");
    for (const std::size_t stride : {50, 7, 300}) {
        const SolverReport report = solveFromZero(*solver, ring(3000, stride));
        EXPECT_TRUE(report.converged) << stride;
        EXPECT_EQ(report.iterations, 1) << stride;
    }
}

TEST(Cholmod, SolvesAlsoWhereParticlesWereRenumbered)
{
    const ParticleSystem s = particleSystem(Scene(50, 40));
    const std::size_t n = s.b.size();
    std::vector<Index> rowOf(n);
    for (std::size_t i = 0; i < n; ++i)
        rowOf[i] = static_cast<Index>(i * 7 % n);  // 7 does not divide n
    ASSERT_NE(n % 7, 0u);
    std::vector<std::vector<Real>> dense(n, std::vector<Real>(n, 0));
    for (std::size_t i = 0; i < n; ++i) {
        dense[rowOf[i]][rowOf[i]] = s.matrix.diagonal[i];
        for (PairIndex k = s.matrix.rowStart[i]; k < s.matrix.rowStart[i + 1]; ++k)
            dense[rowOf[i]][rowOf[s.matrix.column[k]]] = s.matrix.offDiagonal[k];
    }
    const ParticleSystem renumbered{fromDense(dense), {}, s.b};
    const auto solver = solverOf("solver cholmod; tolerance 1e-9;");
    solveFromZero(*solver, s);
    EXPECT_TRUE(solveFromZero(*solver, renumbered).converged);
    EXPECT_TRUE(solveFromZero(*solver, s).converged);
}

TEST(LagCholmod, NeedsFewIterationsWithTheFactorOfAnEarlierStep)
{
    const auto solver = solverOf("solver lagCholmod;");
    EXPECT_EQ(solveFromZero(*solver, moved(0.2)).iterations, 1);
    for (const Real jitter : {0.201, 0.202, 0.205}) {  // pairs enter and leave the support
        const ParticleSystem s = moved(jitter);
        const SolverReport report = solveFromZero(*solver, s);
        EXPECT_TRUE(report.converged);
        EXPECT_GT(report.iterations, 1) << "the factor was made anew";
        EXPECT_LE(report.iterations, 5);  // 3 to 4 are usual where particles move by 1 % of d0
    }
}

TEST(LagCholmod, MakesANewFactorWhereTheOldOneServesBadly)
{
    const auto solver = solverOf("solver lagCholmod; refactorIterations 6; tolerance 1e-9;");
    solveFromZero(*solver, moved(0.2));
    Scene soil(50, 40);
    soil.beta = [](int ix, int iy) { return (ix / 5 + iy / 5) % 2 ? 1.0 : 1e-4; };
    const ParticleSystem s = particleSystem(soil);
    const SolverReport first = solveFromZero(*solver, s);
    EXPECT_TRUE(first.converged);
    EXPECT_GT(first.iterations, 6);
    EXPECT_LE(first.iterations, 6 + 2);  // the new factor is exact but for rounding
    EXPECT_LE(solveFromZero(*solver, s).iterations, 2);
}

TEST(LagCholmod, MakesANewFactorWhereRowsWithoutNumbersChanged)
{
    const auto solver = solverOf("solver lagCholmod;");
    solveFromZero(*solver, particleSystem(Scene(50, 40)));
    for (const int rows : {41, 39}) {
        Scene scene(50, rows);
        scene.withPlaces = false;  // whose rows they are is not known
        const SolverReport report = solveFromZero(*solver, particleSystem(scene));
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.iterations, 1);
    }
}

TEST(LagCholmod, KeepsItsFactorWhereParticlesComeToTheSurfaceOrLeaveIt)
{
    const auto solver = solverOf("solver lagCholmod;");
    Scene scene(50, 40);
    solveFromZero(*solver, particleSystem(scene));
    Scene later(50, 40);  // a pocket of air below the surface; the surface covered at another place
    later.atmosphere = [](int ix, int iy) {
        return (iy == 39 && ix != 30) || (iy == 36 && ix > 10 && ix < 14);
    };
    const SolverReport report = solveFromZero(*solver, particleSystem(later));
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.iterations, 1) << "the factor was made anew";
    EXPECT_LE(report.iterations, 12) << "the old factor did not serve";
}

TEST(LagCholmod, SaysThatItWasStoppedWithTheOldFactor)
{
    const auto solver = solverOf("solver lagCholmod; maxIter 2;");
    solveFromZero(*solver, moved(0.2));
    const SolverReport report = solveFromZero(*solver, moved(0.28));
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 2);
}
