// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/Multigrid.hpp"

namespace isph {

/// Flexible conjugate gradients with the aggregation multigrid, made anew from every matrix. Its
/// iterations hardly grow with the number of rows and with jumps of the coefficient.
class MultigridPCG : public PressureSolver {
public:
    static Schema keys() { return SolverControls::keys(); }
    explicit MultigridPCG(const Dictionary& pressure) : controls_(pressure) {}

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;

    void release() override
    {
        multigrid_ = std::make_unique<Multigrid>();
        conjugateGradients_ = {};
        r_ = LargeArray<Real>();
    }

    void rest() override { release(); }

private:
    SolverControls controls_;
    std::unique_ptr<Multigrid> multigrid_ = std::make_unique<Multigrid>();
    ConjugateGradients conjugateGradients_;
    LargeArray<Real> r_;
};

}  // namespace isph
