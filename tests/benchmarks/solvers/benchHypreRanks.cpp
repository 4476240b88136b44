// SPDX-License-Identifier: GPL-3.0-or-later
// BoomerAMG-PCG on several MPI ranks, each with a run of the rows.
//
//     mpirun -n 2 benchHypreRanks [-repeat 3] <equation> ...
//
// Prints the least time of copy, setup and solve to a residual of 1e-6, and the iterations.
#include "SolveTimes.hpp"

#include "pressure/hypre/BoomerAMG.hpp"

using namespace isph;
using namespace isph::test;

namespace {

/// A run of the rows.
struct Part {
    int ranks = 1, rank = 0;
    std::size_t rows = 0;

    Index first(int r) const
    {
        return static_cast<Index>(static_cast<std::int64_t>(rows) * r / ranks);
    }
    std::size_t size(int r) const { return static_cast<std::size_t>(first(r + 1) - first(r)); }
};

/// The true residual of what the ranks have found, over |b|.
Real trueResidual(const Part& part, const Equation& equation, std::vector<Real>& own)
{
    std::vector<int> count, start;
    for (int r = 0; r < part.ranks; ++r) {
        count.push_back(static_cast<int>(part.size(r)));
        start.push_back(part.first(r));
    }
    std::vector<Real> x(part.rows);
    MPI_Allgatherv(own.data(), count[part.rank], MPI_DOUBLE, x.data(), count.data(), start.data(),
                   MPI_DOUBLE, MPI_COMM_WORLD);
    return residualNorm(equation.matrix, x, equation.b) / bNorm(equation);
}

SolveTimes measure(BoomerAMG& solver, const Equation& equation, const Part& part)
{
    const Index first = part.first(part.rank);
    const std::size_t rows = part.size(part.rank);
    const Real target = 1e-6 * bNorm(equation);
    MPI_Barrier(MPI_COMM_WORLD);
    const double begin = MPI_Wtime();
    solver.setUpRows(equation.matrix, first, part.first(part.rank + 1), true);
    MPI_Barrier(MPI_COMM_WORLD);
    const double ready = MPI_Wtime();
    const Span<const Real> b = equation.b;
    std::vector<Real> x(equation.x.begin() + first, equation.x.begin() + first + rows);
    SolveTimes times;
    times.iterations = solver.iterate(b.subspan(first, rows), x, target, 500);
    MPI_Barrier(MPI_COMM_WORLD);
    times.setup = ready - begin, times.solve = MPI_Wtime() - ready;
    times.residual = trueResidual(part, equation, x);
    return times;
}

void run(const std::string& word, int repeats, Part part)
{
    const Equation equation = equationOf(word);
    part.rows = equation.b.size();
    BoomerAMG solver(Dictionary::parse("", "bench"), MPI_COMM_WORLD);
    const SolveTimes best = fastest(repeats, [&] {
        SolveTimes now = measure(solver, equation, part);
        MPI_Bcast(&now, sizeof now, MPI_BYTE, 0, MPI_COMM_WORLD);  // all ranks choose alike
        return now;
    });
    if (part.rank == 0) print(word, part.rows, part.ranks, best);
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    int exitCode = 0;
    try {
        Part part;
        MPI_Comm_rank(MPI_COMM_WORLD, &part.rank);
        MPI_Comm_size(MPI_COMM_WORLD, &part.ranks);
        const BenchWords words(argc, argv);
        for (const std::string& word : words.equations) run(word, words.repeats, part);
    } catch (const std::exception& error) {
        exitCode = reportFatal(error);
    }
    MPI_Finalize();
    return exitCode;
}
