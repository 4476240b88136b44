// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/HypreBackend.hpp"
#include "pressure/solvers/Solve.hpp"

namespace isph {

/// Conjugate gradients with BoomerAMG, both of hypre (Henson & Yang 2002, Appl. Numer. Math. 41,
/// 155-177): classical algebraic multigrid, robust as multigridPCG is and some times slower. For
/// comparison, and the way to several machines. Its hierarchy may serve for several steps.
class Hypre : public PressureSolver {
public:
    static Schema keys();
    explicit Hypre(const Dictionary& pressure);

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { rows_ = 0; }

private:
    SolverControls controls_;
    std::unique_ptr<HypreBackend> backend_;
    int setupInterval_;
    int age_ = 0;           ///< solves that the hierarchy has served
    std::size_t rows_ = 0;  ///< of the hierarchy; 0: there is none
    std::vector<Real> r_, correction_, product_;
};

}  // namespace isph
