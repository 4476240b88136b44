// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/IncompleteCholesky.hpp"

namespace isph {

/// z_i = r_i / a_ii
class JacobiPreconditioner : public Preconditioner {
public:
    /// False where a diagonal is not positive.
    bool setUp(const SymmetricMatrix& matrix);
    void apply(Span<const Real> r, Span<Real> z) override;

private:
    std::vector<Real> inverse_;
};

/// Conjugate gradients with a preconditioner made anew from every matrix:
///   MIC0    modified incomplete Cholesky factor, 0.97 of the dropped fill on the diagonal:
///   iterations
///           grow with N^(1/4) in 2-D, the others' with N^(1/2)
///   IC0     incomplete Cholesky factor
///   Jacobi  the diagonal
class PCG : public PressureSolver {
public:
    static Schema keys();
    explicit PCG(const Dictionary& pressure);

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;

private:
    /// The preconditioner of this matrix; none where the matrix is not positive definite.
    Preconditioner* prepare(Solve& solve);

    SolverControls controls_;
    bool jacobi_;
    JacobiPreconditioner diagonal_;
    IncompleteCholesky incomplete_;
    ConjugateGradients conjugateGradients_;
    std::vector<Real> r_;
};

}  // namespace isph
