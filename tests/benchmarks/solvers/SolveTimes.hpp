// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs of the table of solvers print of a solve.
#pragma once
#include "EquationOf.hpp"

#include <cmath>

namespace isph::test {

struct SolveTimes {
    double setup = 0, solve = 0;  ///< [s]
    int iterations = 0;
    Real residual = 0;  ///< the true one over |b|
    double total() const { return setup + solve; }
};

/// The options -repeat <n>, and the equations behind it.
struct BenchWords {
    int repeats = 3;
    std::vector<std::string> equations;

    BenchWords(int argc, char** argv) : equations(argv + 1, argv + argc)
    {
        if (equations.size() < 2 || equations[0] != "-repeat") return;
        repeats = std::stoi(equations[1]);
        equations.erase(equations.begin(), equations.begin() + 2);
    }
};

/// The fastest of the repeats, after one that is left out.
template <class Measure>
SolveTimes fastest(int repeats, Measure&& measure)
{
    SolveTimes best;
    for (int i = 0; i <= repeats; ++i) {
        const SolveTimes now = measure();
        if (i <= 1 || now.total() < best.total()) best = now;
    }
    return best;
}

inline Real bNorm(const Equation& equation)
{
    return std::sqrt(orderedSum(equation.b.size(), [&](Index i) { return sqr(equation.b[i]); }));
}

inline void print(const std::string& word, std::size_t rows, int workers, const SolveTimes& times)
{
    fmt::print(
        "{}  {} rows  {} cores  setup {:.4f} s  solve {:.4f} s  sum {:.4f} s  {} iterations  "
        "residual {:.2g}\n",
        word, rows, workers, times.setup, times.solve, times.total(), times.iterations,
        times.residual);
}

}  // namespace isph::test
