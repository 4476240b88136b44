// SPDX-License-Identifier: GPL-3.0-or-later
// What every pressure solver must do, whatever its method.
#include "LayeredTank.hpp"
#include "SolverTesting.hpp"

#include "core/Error.hpp"
#include "pressure/Components.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace isph;
using namespace isph::test;

namespace {
const std::vector<std::string> kSolvers{"solver cholmod;",
                                        "solver lagCholmod;",
                                        "solver multigridPCG;",
                                        "solver hypre;",
                                        "solver auto;",
                                        "solver PCG;",  // MIC0
                                        "solver PCG; preconditioner IC0;",
                                        "solver PCG; preconditioner Jacobi;"};

class EverySolver : public testing::TestWithParam<std::string> {
protected:
    static std::unique_ptr<PressureSolver> make(
        const std::string& keys = "tolerance 1e-8; maxIter 20000;")
    {
        return solverOf(GetParam() + " " + keys);
    }

    /// Solves from x = 0 and holds the report against the residual, and x against CHOLMOD's answer.
    /// With r, r' the residuals of two answers |x - x'| <= |A^-1| |r - r'| in the largest norm, and
    /// |A^-1| = max_i (A^-1 1)_i since A^-1 has no negative entry (A is an M-matrix).
    static SolverReport solveAndCompare(const SymmetricMatrix& a, const std::vector<Real>& b)
    {
        std::vector<Real> x(b.size(), 0), direct(b.size(), 0), sum(b.size(), 0);
        const SolverReport report = make()->solve(a, b, x);
        const Real r = trueResidual(a, x, b);
        // r is recomputed in double by the solver: rounding of some 20 terms, each up to |A||x|
        Real largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, a.diagonal[i] * std::abs(x[i]));
        const Real rounding =
            40 * std::numeric_limits<Real>::epsilon() * largest * std::sqrt(a.size());
        EXPECT_NEAR(report.finalResidual * norm(b), r, 1e-12 * r + rounding);
        EXPECT_EQ(report.converged, report.finalResidual <= 1e-8);
        EXPECT_TRUE(report.converged || !report.remark.empty());

        const auto cholmod = solverOf("solver cholmod; tolerance 1e-8;");
        cholmod->solve(a, b, direct);
        cholmod->solve(a, std::vector<Real>(b.size(), 1), sum);
        const Real inverse = 1.01 * *std::max_element(sum.begin(), sum.end());
        Real difference = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            difference = std::max(difference, std::abs(x[i] - direct[i]));
        EXPECT_LE(difference, inverse * (r + trueResidual(a, direct, b)) * (1 + 1e-6));
        return report;
    }

    static SolverReport solveAndCompare(const Scene& scene)
    {
        const ParticleSystem s = particleSystem(scene);
        return solveAndCompare(s.matrix, s.b);
    }

    /// Solves a scene some of whose particles have no level of their own; how many components they
    /// make.
    static std::size_t solveFloating(const Scene& scene)
    {
        ParticleSystem s = particleSystem(scene);
        ComponentFinder finder;
        const FloatingComponents& floating = finder.find(s.matrix, s.anchored);
        makeSolvable(s.matrix, s.b, floating);
        EXPECT_TRUE(solveAndCompare(s.matrix, s.b).converged);
        return floating.size();
    }
};
}  // namespace

INSTANTIATE_TEST_SUITE_P(Pressure, EverySolver, testing::ValuesIn(kSolvers), [](const auto& keys) {
    std::string name;
    for (const char c : keys.param)
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
    return name;
});

TEST_P(EverySolver, SolvesATankOfJitteredParticles)
{
    EXPECT_TRUE(solveAndCompare(Scene(60, 50)).converged);
}

TEST_P(EverySolver, SolvesAColumnOfAThousandRows)
{
    EXPECT_TRUE(solveAndCompare(Scene(3, 1001)).converged);
}

TEST_P(EverySolver, SolvesFiveDisconnectedParts)
{
    Scene scene(60, 20);
    scene.present = [](int ix, int) { return ix % 12 < 8; };
    EXPECT_TRUE(solveAndCompare(scene).converged);
}

TEST_P(EverySolver, SolvesASprayWithThirtyPercentOfTheParticlesMissing)
{
    Scene scene(60, 50);
    std::mt19937 random(7);
    std::vector<char> there(60 * 50);
    for (char& t : there) t = random() % 10 >= 3;
    scene.present = [&](int ix, int iy) { return there[iy * 60 + ix] != 0; };
    scene.atmosphere = [](int ix, int iy) { return iy == 49 || (7 * ix + 3 * iy) % 40 == 0; };
    solveFloating(scene);
}

TEST_P(EverySolver, SolvesFilmsDropsAndLoneParticles)
{
    Scene scene(120,
                60);  // a film two particles thick along p = 0, drops of nine, single particles
    scene.present = [](int ix, int iy) {
        const bool film = iy >= 57;
        const bool drop = iy < 48 && iy % 8 < 3 && ix % 8 < 3;
        const bool alone = iy < 48 && iy % 8 == 6 && ix % 8 == 6;
        return film || drop || alone;
    };
    // one particle of each second drop is at the surface; the others have no level of their own
    scene.atmosphere = [](int ix, int iy) { return iy == 59 || (ix % 16 == 0 && iy % 8 == 0); };
    EXPECT_GT(solveFloating(scene), 100u);
}

TEST_P(EverySolver, SolvesATankIn3DWithLayersOfSoil)
{
    LayeredTank tank;
    tank.dimension = 3, tank.particles = 3000, tank.jump = 1e4;
    const PressureSystem s = pressureSystem(tank);
    EXPECT_TRUE(solveAndCompare(s.matrix, s.b).converged);
}

TEST_P(EverySolver, SolvesASingleRow)
{
    SymmetricMatrix a;
    a.diagonal = {3};
    a.rowStart = {0, 0};
    std::vector<Real> x{0};
    const SolverReport report = make()->solve(a, std::vector<Real>{6}, x);
    EXPECT_TRUE(report.converged);
    EXPECT_NEAR(x[0], 2, 1e-6);  // a factor in single precision, refined by the iteration
}

TEST_P(EverySolver, SolvesABoxWithoutAFreeSurface)
{
    Scene scene(30, 30);
    scene.atmosphere = [](int, int) { return false; };
    EXPECT_EQ(solveFloating(scene), 1u);
}

TEST_P(EverySolver, SolvesJumpsOfTheCoefficientOrSaysThatItDidNot)
{
    for (const Real jump : {1.0, 1e2, 1e4, 1e6, 1e8}) {
        Scene scene(40, 40);  // a soil layer with a pocket of water in it, water above and below
        scene.beta = [&](int ix, int iy) {
            const bool pocket = ix > 14 && ix < 24 && iy > 15 && iy < 21;
            return iy > 10 && iy < 30 && !pocket ? 1 / jump : 1.0;
        };
        const SolverReport report = solveAndCompare(scene);
        // Sources in the pocket need p ~ jump * size^2 there, and the residual is a difference of
        // terms that large: beyond 1e4, rounding alone may exceed 1e-8.
        EXPECT_TRUE(report.converged || jump > 1e4) << "jump " << jump;
        EXPECT_LT(report.finalResidual, 1e-3) << "jump " << jump;
    }
}

TEST_P(EverySolver, OneAndTwoThreadsAgreeBitForBit)
{
    Scene scene(70, 60);  // several sum blocks, and more rows than IncompleteCholesky takes in one
    scene.beta = [](int ix, int) { return ix < 30 ? 1.0 : 1e-3; };
    const ParticleSystem s = particleSystem(scene);
    std::vector<Real> one(s.b.size(), 0), two(s.b.size(), 0);
    SolverReport first, second;
    {
        const Threads threads(1);
        first = make()->solve(s.matrix, s.b, one);
    }
    {
        const Threads threads(2);
        second = make()->solve(s.matrix, s.b, two);
    }
    EXPECT_EQ(one, two);
    EXPECT_EQ(first.iterations, second.iterations);
    EXPECT_EQ(first.finalResidual, second.finalResidual);
}

TEST_P(EverySolver, AfterForgetGivesTheBitsOfANewSolver)
{
    const ParticleSystem s = particleSystem(Scene(40, 30));
    Scene moved(40, 30);
    moved.seed = 2;
    const ParticleSystem earlier = particleSystem(moved);
    std::vector<Real> x(s.b.size(), 0), fresh(s.b.size(), 0), scratch(s.b.size(), 0);
    const auto solver = make();
    solver->solve(earlier.matrix, earlier.b, scratch);
    solver->forget();
    solver->solve(s.matrix, s.b, x);
    make()->solve(s.matrix, s.b, fresh);
    EXPECT_EQ(x, fresh);
}

TEST_P(EverySolver, GivesZeroForAZeroRightHandSideAtOnce)
{
    const ParticleSystem s = particleSystem(Scene(20, 20));
    std::vector<Real> x(s.b.size(), 5.0);
    const SolverReport report = make()->solve(s.matrix, std::vector<Real>(s.b.size(), 0), x);
    EXPECT_EQ(x, std::vector<Real>(s.b.size(), 0));
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(report.initialResidual, 0);
    EXPECT_EQ(report.finalResidual, 0);
}

TEST_P(EverySolver, TakesAnEquationWithoutRows)
{
    std::vector<Real> none;
    EXPECT_TRUE(make()->solve(SymmetricMatrix{}, none, none).converged);
}

TEST_P(EverySolver, LeavesAGuessThatIsGoodEnoughAlone)
{
    const ParticleSystem s = particleSystem(Scene(20, 20));
    std::vector<Real> x(s.b.size(), 0);
    make("tolerance 1e-10;")->solve(s.matrix, s.b, x);
    const std::vector<Real> before = x;
    const SolverReport report = make("tolerance 1e-8;")->solve(s.matrix, s.b, x);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(x, before);
}

TEST_P(EverySolver, StopsAtTheShareOfTheFirstResidualThatRelTolAsksFor)
{
    const ParticleSystem s = particleSystem(Scene(40, 30));
    std::vector<Real> x(s.b.size(), 0.1);
    const SolverReport report = make("tolerance 1e-12; relTol 0.1;")->solve(s.matrix, s.b, x);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.finalResidual, 0.1 * report.initialResidual);
}

TEST_P(EverySolver, NamesTheRowThatIsNotFinite)
{
    const ParticleSystem good = particleSystem(Scene(20, 20));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto message = [&](const ParticleSystem& s, std::vector<Real> x) -> std::string {
        try {
            make()->solve(s.matrix, s.b, x);
        } catch (const FatalError& error) {
            return error.what();
        }
        return "no error";
    };
    const std::vector<Real> zero(good.b.size(), 0);
    ParticleSystem s = good;
    s.b[7] = nan;
    EXPECT_NE(message(s, zero).find("right-hand side of row 7 is nan"), std::string::npos)
        << message(s, zero);
    s = good;
    s.matrix.diagonal[11] = std::numeric_limits<Real>::infinity();
    EXPECT_NE(message(s, zero).find("diagonal of row 11 is inf"), std::string::npos)
        << message(s, zero);
    s = good;
    s.matrix.offDiagonal[s.matrix.rowStart[3]] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(message(s, zero).find("off-diagonal coefficient of row 3"), std::string::npos)
        << message(s, zero);
    std::vector<Real> guess = zero;
    guess[5] = nan;
    EXPECT_NE(message(good, guess).find("guess of the pressure of row 5"), std::string::npos);
}

TEST_P(EverySolver, SaysThatAnIndefiniteMatrixIsNotSolved)
{
    // symmetric, of positive diagonal, eigenvalues -1 and 3: nothing here solves it by right
    const SymmetricMatrix a = fromDense({{1, -2, 0}, {-2, 1, 0}, {0, 0, 1}});
    std::vector<Real> x(3, 0);
    const SolverReport report = make()->solve(a, std::vector<Real>{1, 1, 1}, x);
    EXPECT_EQ(report.converged, trueResidual(a, x, {1, 1, 1}) <= 1e-8 * std::sqrt(3.0));
    EXPECT_TRUE(report.converged ||
                report.remark.find("not positive definite") != std::string::npos);
    for (const Real value : x) EXPECT_TRUE(std::isfinite(value));
}

TEST(IterativeSolvers, SayThatOneIterationWasNotEnough)
{
    const ParticleSystem s = particleSystem(Scene(40, 30));
    for (const std::string preconditioner : {"MIC0", "IC0", "Jacobi"}) {
        std::vector<Real> x(s.b.size(), 0);
        const SolverReport report =
            solverOf("solver PCG; maxIter 1; preconditioner " + preconditioner + ";")
                ->solve(s.matrix, s.b, x);
        EXPECT_FALSE(report.converged);
        EXPECT_EQ(report.iterations, 1);
        EXPECT_GT(report.finalResidual, 1e-6);
        EXPECT_NEAR(report.finalResidual, trueResidual(s.matrix, x, s.b) / norm(s.b), 1e-12);
    }
}

TEST(PressureSolver, IsChosenByItsNameAndRefusesKeysItDoesNotHave)
{
    const auto messageOf = [](const std::string& keys) -> std::string {
        try {
            solverOf(keys);
        } catch (const FatalIOError& error) {
            return error.what();
        }
        return "no error";
    };
    for (const std::string name : {"cholmod", "lagCholmod", "PCG", "multigridPCG", "hypre"}) {
        std::vector<Real> x(1, 0);
        SymmetricMatrix a;
        a.diagonal = {1};
        a.rowStart = {0, 0};
        EXPECT_EQ(solverOf("solver " + name + ";")->solve(a, std::vector<Real>{1}, x).solver, name);
    }
    EXPECT_NE(messageOf("solver PGC;").find("PCG"), std::string::npos);
    EXPECT_NE(messageOf("solver PCG; tolerence 1e-5;").find("tolerance"), std::string::npos);
    EXPECT_NE(messageOf("solver cholmod; preconditioner IC0;").find("preconditioner"),
              std::string::npos);
    EXPECT_NE(messageOf("solver PCG; tolerance 0;").find("tolerance"), std::string::npos);
    EXPECT_NE(messageOf("solver PCG; preconditioner ILU;").find("ILU"), std::string::npos);
}
