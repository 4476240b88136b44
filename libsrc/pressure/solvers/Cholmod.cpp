// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Cholmod.hpp"

#include "core/Parallel.hpp"

namespace isph {

namespace {
const PressureSolver::Table::Entry<Cholmod> entry{"cholmod"};
/// A refinement that does not halve the residual shows that rounding limits it.
constexpr Real kLeastGain = 0.5;
}  // namespace

SolverReport Cholmod::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    r_.resize(matrix.size()), correction_.resize(matrix.size());
    Solve solve("cholmod", controls_, matrix, b, x, r_);
    if (solve.done()) return solve.report();
    if (!factor_.factorise(matrix)) {
        solve.remark("the matrix is not positive definite");
        return solve.report();
    }
    while (!solve.done() && solve.iterationsLeft() > 0) {
        const Real before = solve.norm();
        factor_.apply(r_, correction_);
        parallelFor(matrix.size(), [&](Index i) { x[i] += correction_[i]; });
        solve.measure();
        solve.countIterations(1);
        if (!solve.done() && !(solve.norm() < kLeastGain * before)) {
            solve.remark("the residual does not fall any further");
            break;
        }
    }
    return solve.report();
}

}  // namespace isph
