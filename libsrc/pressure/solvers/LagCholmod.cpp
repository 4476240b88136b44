// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/LagCholmod.hpp"

namespace isph {

namespace {
const PressureSolver::Table::Entry<LagCholmod> entry{"lagCholmod"};
}

Schema LagCholmod::keys()
{
    return SolverControls::keys().add(
        Key::integer("refactorIterations",
                     "Iterations after which the kept factor is replaced by a new one.")
            .byDefault("12")
            .atLeast(1));
}

LagCholmod::LagCholmod(const Dictionary& pressure)
    : controls_(pressure), refactorIterations_(keys().get<int>(pressure, "refactorIterations"))
{
}

SolverReport LagCholmod::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    r_.resize(matrix.size());
    Solve solve("lagCholmod", controls_, matrix, b, x, r_);
    if (!solve.done() && factor_.holds(matrix.size()))
        conjugateGradients_.run(solve, factor_,
                                std::min(refactorIterations_, solve.iterationsLeft()));
    if (solve.done() || solve.iterationsLeft() == 0) return solve.report();
    if (factor_.factorise(matrix))
        conjugateGradients_.run(solve, factor_, solve.iterationsLeft());
    else
        solve.remark("the matrix is not positive definite");
    return solve.report();
}

}  // namespace isph
