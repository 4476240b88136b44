// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/MultigridPCG.hpp"

namespace isph {

namespace {
const PressureSolver::Table::Entry<MultigridPCG> entry{"multigridPCG"};
}

SolverReport MultigridPCG::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    r_.resize(matrix.size());
    Solve solve("multigridPCG", controls_, matrix, b, x, r_);
    if (solve.done()) return solve.report();
    if (multigrid_->setUp(matrix))
        conjugateGradients_.run(solve, *multigrid_, solve.iterationsLeft());
    else
        solve.remark("the matrix is not positive definite");
    return solve.report();
}

}  // namespace isph
