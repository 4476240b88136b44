// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/LagCholmod.hpp"

#include "core/Parallel.hpp"

namespace isph {

namespace {
const PressureSolver::Table::Entry<LagCholmod> entry{"lagCholmod"};
}

bool KeptFactor::factorise(const SymmetricMatrix& matrix)
{
    if (!factor_.factorise(matrix)) return false;
    rows_ = matrix.size();
    r_.resize(rows_), z_.resize(rows_);
    place_.reserve(rows_), inverseDiagonal_.reserve(rows_);
    place_.clear();
    const LargeArray<Index>& particle = matrix.places.particle;
    rowOfParticle_.assign(particle.empty() ? 0 : particle.back() + 1, -1);
    for (std::size_t row = 0; row < particle.size(); ++row)
        rowOfParticle_[particle[row]] = static_cast<Index>(row);
    return true;
}

bool KeptFactor::serves(const SymmetricMatrix& matrix)
{
    if (!factor_.holds(rows_)) return false;
    const LargeArray<Index>& particle = matrix.places.particle;
    place_.clear();
    if (particle.empty() || rowOfParticle_.empty()) return rows_ == matrix.size();
    const std::size_t n = matrix.size();
    place_.resize(n), inverseDiagonal_.resize(n);
    std::fill(r_.begin(), r_.end(), 0);
    const auto known = static_cast<Index>(rowOfParticle_.size());
    parallelFor(n, [&](Index i) {
        place_[i] = particle[i] < known ? rowOfParticle_[particle[i]] : -1;
        inverseDiagonal_[i] = 1 / matrix.diagonal[i];
    });
    return true;
}

void KeptFactor::apply(Span<const Real> r, Span<Real> z)
{
    if (place_.empty()) return factor_.apply(r, z);
    parallelFor(r.size(), [&](Index i) {
        if (place_[i] >= 0) r_[place_[i]] = r[i];
    });
    factor_.apply(r_, z_);
    parallelFor(r.size(), [&](Index i) {
        z[i] = place_[i] >= 0 ? z_[place_[i]] : r[i] * inverseDiagonal_[i];
    });
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
    if (!solve.done() && factor_.serves(matrix))
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
