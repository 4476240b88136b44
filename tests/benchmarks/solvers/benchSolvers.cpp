// SPDX-License-Identifier: GPL-3.0-or-later
// Setup and solve of every pressure solver to a true residual of 1e-6.
//
//     benchSolvers [options of Google Benchmark] [<equation> ...]
//
// An equation is a file of postProcessing/pressureEquation (recordInterval in isphSolution writes
// them) or a layered tank, tank:3:2e5:column:1e4. Threads: OMP_NUM_THREADS. Columns: rows, the
// iterations and the residual of the last solve. Solvers that keep things between steps
// (lagCholmod, hypre with setupInterval) are measured in their steady state.
#include "EquationOf.hpp"

#include "pressure/solvers/Multigrid.hpp"

#include <benchmark/benchmark.h>

#include <filesystem>

using namespace isph;
using namespace isph::test;

namespace {

/// Rows up to which a factor is affordable: beyond, one takes minutes and gigabytes.
constexpr std::size_t kMostFactorRows2 = 300'000, kMostFactorRows3 = 20'000;

void solve(benchmark::State& state, const Equation& equation, const std::string& keys)
{
    const auto solver =
        PressureSolver::select(Dictionary::parse(keys + " tolerance 1e-6; maxIter 5000;", "bench"));
    std::vector<Real> x;
    SolverReport report;
    const auto once = [&] {
        x = equation.x;
        report = solver->solve(equation.matrix, equation.b, x);
    };
    once();  // first touch, kept orderings and hierarchies
    for (auto _ : state) once();
    state.counters["rows"] = static_cast<double>(x.size());
    state.counters["iterations"] = report.iterations;
    state.counters["residual"] = report.finalResidual;
    if (!report.converged) state.SkipWithError(("not converged: " + report.remark).c_str());
}

void setUpMultigrid(benchmark::State& state, const Equation& equation)
{
    Multigrid multigrid;
    multigrid.setUp(equation.matrix);
    for (auto _ : state) benchmark::DoNotOptimize(multigrid.setUp(equation.matrix));
    state.counters["rows"] = static_cast<double>(equation.b.size());
    state.counters["levels"] = static_cast<double>(multigrid.levels());
    state.counters["complexity"] = multigrid.operatorComplexity();
}

/// One product with the matrix, the unit that setup and iterations may be counted in.
void multiplyOnce(benchmark::State& state, const Equation& equation)
{
    std::vector<Real> y(equation.b.size());
    for (auto _ : state) multiply(equation.matrix, equation.b, y);
    const auto bytes = 12.0 * static_cast<double>(equation.matrix.column.size());
    state.counters["bytes/s"] =
        benchmark::Counter(bytes, benchmark::Counter::kIsIterationInvariantRate);
}

void enter(const std::string& word)
{
    const auto equation = std::make_shared<Equation>(equationOf(word));
    const std::size_t rows = equation->b.size();
    const auto most = equation->matrix.places.dimension == 3 ? kMostFactorRows3 : kMostFactorRows2;
    const std::string name = word.rfind("tank:", 0) == 0
                                 ? word
                                 : std::filesystem::path(word).lexically_normal().string();
    const auto add = [&](const std::string& what, auto run) {
        benchmark::RegisterBenchmark((name + "/" + what).c_str(),
                                     [=](benchmark::State& state) { run(state, *equation); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    const auto addSolver = [&](const std::string& what, const std::string& keys) {
        add(what, [keys](benchmark::State& s, const Equation& e) { solve(s, e, keys); });
    };
    add("matrixTimesVector", multiplyOnce);
    add("multigridSetup", setUpMultigrid);
    addSolver("multigridPCG", "solver multigridPCG;");
    addSolver("hypre", "solver hypre;");
    addSolver("hypreKept10", "solver hypre; setupInterval 10;");
    addSolver("PCG", "solver PCG;");
    if (rows > most) return;
    addSolver("cholmod", "solver cholmod;");
    addSolver("lagCholmod", "solver lagCholmod;");
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        benchmark::Initialize(&argc, argv);
        std::vector<std::string> words(argv + 1, argv + argc);
        if (words.empty())
            words = {"tank:2:1e4:column:1e4", "tank:2:2e5:column:1e4", "tank:3:2e5:column:1e4"};
        for (const std::string& word : words) enter(word);
        benchmark::RunSpecifiedBenchmarks();
        return 0;
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
