// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/CholmodFactor.hpp"

namespace isph {

/// Conjugate gradients with the Cholesky factor of an earlier step's matrix. While particles keep
/// their numbers the factor serves for many steps, also where the pattern of the matrix changes.
/// A new factor is made where the number of rows has changed, and where a solve with the old one
/// has not converged within refactorIterations (it then goes on with the new one).
class LagCholmod : public PressureSolver {
public:
    static Schema keys();
    explicit LagCholmod(const Dictionary& pressure);

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { factor_.forget(); }

private:
    SolverControls controls_;
    int refactorIterations_;
    CholmodFactor factor_;
    ConjugateGradients conjugateGradients_;
    std::vector<Real> r_;
};

}  // namespace isph
