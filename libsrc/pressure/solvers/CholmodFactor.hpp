// SPDX-License-Identifier: GPL-3.0-or-later
// Complete Cholesky factor by CHOLMOD (SuiteSparse).
#pragma once
#include "pressure/solvers/ConjugateGradients.hpp"

#include <memory>

namespace isph {

/// P A P^T = L L^T (Chen, Davis, Hager & Rajamanickam 2008, ACM TOMS 35(3), 22). The symbolic
/// factor is kept while the pattern of A stays the same, and the fill-reducing ordering P while the
/// number of rows stays the same and P serves well: to find P takes up to twice the time of the
/// factor itself. CHOLMOD and its BLAS run on one thread, so the bits do not depend on the number
/// of threads.
class CholmodFactor : public Preconditioner {
public:
    CholmodFactor();
    ~CholmodFactor() override;

    /// False where A is not positive definite; no factor is then held.
    /// Throws FatalError where the factor does not fit into memory.
    bool factorise(const SymmetricMatrix& matrix);
    /// z = A^-1 r
    void apply(Span<const Real> r, Span<Real> z) override;

    /// A factor of n rows is held.
    bool holds(std::size_t n) const;
    void forget();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace isph
