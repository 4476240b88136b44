// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/PCG.hpp"

#include "core/Parallel.hpp"

#include <fmt/core.h>

namespace isph {

namespace {
const PressureSolver::Table::Entry<PCG> entry{"PCG"};
/// Share of the dropped fill that MIC0 keeps on the diagonal; below 1, pivots stay positive.
constexpr Real kRelaxation = 0.97;
}  // namespace

bool JacobiPreconditioner::setUp(const SymmetricMatrix& matrix)
{
    const std::size_t n = matrix.size();
    inverse_.resize(n);
    parallelFor(n, [&](Index i) { inverse_[i] = 1 / matrix.diagonal[i]; });
    return std::all_of(matrix.diagonal.begin(), matrix.diagonal.end(),
                       [](Real d) { return d > 0; });
}

void JacobiPreconditioner::apply(Span<const Real> r, Span<Real> z)
{
    parallelFor(r.size(), [&](Index i) { z[i] = inverse_[i] * r[i]; });
}

Schema PCG::keys()
{
    return SolverControls::keys().add(
        Key::word(
            "preconditioner",
            "MIC0 and IC0: incomplete Cholesky factor, modified and plain; Jacobi: the diagonal.")
            .byDefault("MIC0")
            .oneOf({"MIC0", "IC0", "Jacobi"}));
}

PCG::PCG(const Dictionary& pressure)
    : controls_(pressure),
      jacobi_(keys().get<std::string>(pressure, "preconditioner") == "Jacobi"),
      incomplete_(keys().get<std::string>(pressure, "preconditioner") == "MIC0" ? kRelaxation : 0)
{
}

SolverReport PCG::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    r_.resize(matrix.size());
    Solve solve("PCG", controls_, matrix, b, x, r_);
    if (solve.done()) return solve.report();
    if (Preconditioner* preconditioner = prepare(solve))
        conjugateGradients_.run(solve, *preconditioner, solve.iterationsLeft());
    else
        solve.remark("the matrix is not positive definite");
    return solve.report();
}

Preconditioner* PCG::prepare(Solve& solve)
{
    if (jacobi_) return diagonal_.setUp(solve.matrix()) ? &diagonal_ : nullptr;
    const std::optional<Real> shift = incomplete_.factorise(solve.matrix());
    if (!shift) return nullptr;
    if (*shift > 0) solve.remark(fmt::format("incomplete factor with diagonal shift {}", *shift));
    return &incomplete_;
}

}  // namespace isph
