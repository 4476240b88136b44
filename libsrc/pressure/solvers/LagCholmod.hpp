// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/CholmodFactor.hpp"

namespace isph {

/// The factor of an earlier step's matrix as a preconditioner of the present one, whose rows may be
/// others: particles have become surface since then, or have ceased to be. A row whose particle had
/// one takes its place, others stay empty: a principal part of A_old^-1, so M stays positive
/// definite. New rows are divided by their diagonals.
class KeptFactor : public Preconditioner {
public:
    /// False where A is not positive definite.
    bool factorise(const SymmetricMatrix& matrix);
    /// Finds the places of the rows. False where no factor is held, or one of other rows and the
    /// particles of the rows are not known.
    bool serves(const SymmetricMatrix& matrix);
    void apply(Span<const Real> r, Span<Real> z) override;
    void forget() { factor_.forget(); }

private:
    CholmodFactor factor_;
    std::size_t rows_ = 0;              ///< of the factor
    std::vector<Index> rowOfParticle_;  ///< in the factor; -1: none
    std::vector<Index> place_;          ///< of each present row in the factor; empty: the same
    std::vector<Real> inverseDiagonal_;
    std::vector<Real> r_, z_;
};

/// Conjugate gradients with the Cholesky factor of an earlier step's matrix. While particles keep
/// their numbers the factor serves for many steps, also where the pattern of the matrix changes and
/// where particles come to the surface or leave it. A new factor is made where a solve with the old
/// one has not converged within refactorIterations (it then goes on with the new one).
class LagCholmod : public PressureSolver {
public:
    static Schema keys();
    explicit LagCholmod(const Dictionary& pressure);

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { factor_.forget(); }

private:
    SolverControls controls_;
    int refactorIterations_;
    KeptFactor factor_;
    ConjugateGradients conjugateGradients_;
    std::vector<Real> r_;
};

}  // namespace isph
