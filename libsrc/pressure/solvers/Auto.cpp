// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Auto.hpp"

#include "core/Log.hpp"

namespace isph {

namespace {
const PressureSolver::Table::Entry<Auto> entry{"auto"};
/// Measured by benchSolvers and on the tutorial porousDamBreak; in 3-D a factor never pays.
constexpr std::size_t kMostFactorRows = 1000;
}  // namespace

SolverReport Auto::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    const int dimension = matrix.places.dimension;
    const bool small = dimension == 2 && matrix.size() <= kMostFactorRows;
    if (!std::exchange(told_[small], true))
        info("Selecting pressure solver {} (auto: {} unknowns{})",
             small ? "lagCholmod" : "multigridPCG", matrix.size(),
             dimension > 0 ? fmt::format(" in {}-D", dimension) : "");
    PressureSolver& solver = small ? static_cast<PressureSolver&>(lagCholmod_) : multigridPCG_;
    return solver.solve(matrix, b, x);
}

}  // namespace isph
