// SPDX-License-Identifier: GPL-3.0-or-later
// Preconditioned conjugate gradients.
#pragma once
#include "pressure/solvers/Solve.hpp"
#include "pressure/solvers/Team.hpp"

#include <vector>

namespace isph {

/// z = M^-1 r with M symmetric and positive definite, at least nearly so.
class Preconditioner {
public:
    virtual ~Preconditioner() = default;
    virtual void apply(Span<const Real> r, Span<Real> z) = 0;
    /// A whole solve is done by one team of threads.
    virtual bool inTeam() const { return false; }
    /// As apply() above, called by all threads of a team. Every thread needs its own rows of r
    /// alone to have been made by then, and has its rows of z when it returns.
    virtual void apply(Team& team, Span<const Real> r, Span<Real> z)
    {
        team.single([&](Team&) { apply(r, z); });
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
    /// What every thread does of it.
    int descend(Team& team, Solve& solve, Preconditioner& preconditioner, int iterations);

    LargeArray<Real> z_, p_, q_;
};

}  // namespace isph
