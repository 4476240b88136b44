// SPDX-License-Identifier: GPL-3.0-or-later
// multigridPCG as a step calls it, from nothing held to a true residual of 1e-6.
//
//     benchMultigrid [-repeat 3] <equation> ...
//
// Threads: OMP_NUM_THREADS. Equations as those of benchSolvers. Prints the least time of setup and
// solve, and the iterations, in the words of benchHypreRanks.
#include "SolveTimes.hpp"

#include "core/Timers.hpp"
#include "pressure/solvers/Multigrid.hpp"

using namespace isph;
using namespace isph::test;

namespace {

double setupSeconds(const Equation& equation)
{
    const double begin = wallSeconds();
    Multigrid multigrid;
    multigrid.setUp(equation.matrix);
    return wallSeconds() - begin;
}

/// The whole solve is timed as one; the setup is measured apart and taken off.
SolveTimes measure(PressureSolver& solver, const Equation& equation)
{
    SolveTimes times;
    times.setup = setupSeconds(equation);
    std::vector<Real> x(equation.x);
    const double begin = wallSeconds();
    const SolverReport report = solver.solve(equation.matrix, equation.b, x);
    solver.rest();
    times.solve = wallSeconds() - begin - times.setup;
    times.iterations = report.iterations;
    times.residual = residualNorm(equation.matrix, x, equation.b) / bNorm(equation);
    return times;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        const BenchWords words(argc, argv);
        const auto solver = PressureSolver::select(
            Dictionary::parse("solver multigridPCG; tolerance 1e-6;", "bench"));
        for (const std::string& word : words.equations) {
            const Equation equation = equationOf(word);
            print(word, equation.b.size(), threadCount(),
                  fastest(words.repeats, [&] { return measure(*solver, equation); }));
        }
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
