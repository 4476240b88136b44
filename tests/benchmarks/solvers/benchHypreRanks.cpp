// SPDX-License-Identifier: GPL-3.0-or-later
// BoomerAMG-PCG on several MPI ranks, each with a run of the rows.
//
//     mpirun -n 2 benchHypreRanks [-repeat 3] <equation> ...
//
// Prints the least time of copy, setup and solve to a residual of 1e-6, and the iterations.
#include "EquationOf.hpp"

#include "pressure/hypre/BoomerAMG.hpp"

using namespace isph;
using namespace isph::test;

namespace {

struct Times {
    double setup = 0, solve = 0;
    int iterations = 0;
    double total() const { return setup + solve; }
};

Times measure(BoomerAMG& solver, const Equation& equation, Index first, Index last)
{
    std::vector<Real> r(equation.b.size());
    const Real target =
        1e-6 * std::sqrt(orderedSum(r.size(), [&](Index i) { return sqr(equation.b[i]); }));
    MPI_Barrier(MPI_COMM_WORLD);
    const double begin = MPI_Wtime();
    solver.setUpRows(equation.matrix, first, last, true);
    MPI_Barrier(MPI_COMM_WORLD);
    const double ready = MPI_Wtime();
    const Span<const Real> b = equation.b;
    std::vector<Real> x(equation.x.begin() + first, equation.x.begin() + last);
    Times times;
    times.iterations = solver.iterate(b.subspan(first, x.size()), x, target, 500);
    MPI_Barrier(MPI_COMM_WORLD);
    times.setup = ready - begin, times.solve = MPI_Wtime() - ready;
    return times;
}

void run(const std::string& word, int repeats, int rank, int ranks)
{
    const Equation equation = equationOf(word);
    const auto rows = static_cast<std::int64_t>(equation.b.size());
    const auto first = static_cast<Index>(rows * rank / ranks);
    const auto last = static_cast<Index>(rows * (rank + 1) / ranks);
    BoomerAMG solver(Dictionary::parse("", "bench"), MPI_COMM_WORLD);
    Times best;
    for (int i = 0; i <= repeats; ++i) {  // the first is left out
        const Times now = measure(solver, equation, first, last);
        if (i <= 1 || now.total() < best.total()) best = now;
    }
    if (rank == 0)
        fmt::print(
            "{}  {} rows  {} ranks  setup {:.4f} s  solve {:.4f} s  sum {:.4f} s  {} iterations\n",
            word, rows, ranks, best.setup, best.solve, best.total(), best.iterations);
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    int exitCode = 0;
    try {
        int rank = 0, ranks = 1, repeats = 3;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        MPI_Comm_size(MPI_COMM_WORLD, &ranks);
        std::vector<std::string> words(argv + 1, argv + argc);
        if (words.size() > 1 && words[0] == "-repeat") {
            repeats = std::stoi(words[1]);
            words.erase(words.begin(), words.begin() + 2);
        }
        for (const std::string& word : words) run(word, repeats, rank, ranks);
    } catch (const std::exception& error) {
        exitCode = reportFatal(error);
    }
    MPI_Finalize();
    return exitCode;
}
