// SPDX-License-Identifier: GPL-3.0-or-later
// Preconditioned conjugate gradients.
#pragma once
#include "pressure/solvers/Solve.hpp"

#include <vector>

namespace isph {

/// z = M^-1 r with M symmetric and positive definite, at least nearly so.
class Preconditioner {
public:
    virtual ~Preconditioner() = default;
    virtual void apply(Span<const Real> r, Span<Real> z) = 0;
    /// y = A x; returns x.y, summed in order. A preconditioner may have A in a form that is faster
    /// to read and differs by rounding; the residual that ends the solve is that of A itself.
    virtual Real multiplyAndDot(const SymmetricMatrix& matrix, Span<const Real> x, Span<Real> y)
    {
        return isph::multiplyAndDot(matrix, x, y);
    }
};

/// The iteration of Hestenes and Stiefel (1952), with M as in Saad, Iterative Methods for Sparse
/// Linear Systems (2003), algorithm 9.1, with the direction of Polak and Ribiere: flexible, that is
/// for preconditioners that are no fixed matrix (Notay 2000, SIAM J. Sci. Comput. 22, 1444-1460).
/// It keeps its work arrays from solve to solve.
class ConjugateGradients {
public:
    /// Goes on from solve.x() and the r that belongs to it until solve.done(), judged by the true
    /// residual, or for at most `iterations`. Where the recursive residual has met the target and
    /// the true one has not, it starts anew from the true one, until that gains nothing more.
    void run(Solve& solve, Preconditioner& preconditioner, int iterations);

private:
    /// As run() without new starts: the iterations used, r measured at the end.
    int descend(Solve& solve, Preconditioner& preconditioner, int iterations);

    LargeArray<Real> z_, p_, q_;
};

}  // namespace isph
