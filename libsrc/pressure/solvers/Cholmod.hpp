// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/CholmodFactor.hpp"

namespace isph {

/// Direct solver: a Cholesky factor of every matrix. For verification and for small 2-D cases; in
/// 3-D the factor outgrows time and memory. The residual that rounding leaves is solved for again
/// until the target is met, which large jumps of the coefficients may need.
class Cholmod : public PressureSolver {
public:
    static Schema keys() { return SolverControls::keys(); }
    explicit Cholmod(const Dictionary& pressure) : controls_(pressure) {}

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { factor_.forget(); }

private:
    SolverControls controls_;
    CholmodFactor factor_;
    std::vector<Real> r_, correction_;
};

}  // namespace isph
