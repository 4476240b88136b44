// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/ConjugateGradients.hpp"

#include "core/Parallel.hpp"

#include <cmath>

namespace isph {

namespace {
/// A new start that does not halve the true residual shows that rounding limits it.
constexpr Real kLeastGain = 0.5;
}  // namespace

void ConjugateGradients::run(Solve& solve, Preconditioner& preconditioner, int iterations)
{
    const std::size_t n = solve.matrix().size();
    z_.resize(n), p_.resize(n), q_.resize(n);
    while (!solve.done() && iterations > 0) {
        const Real before = solve.norm();
        iterations -= descend(solve, preconditioner, iterations);
        if (!solve.done() && iterations > 0 && !(solve.norm() < kLeastGain * before)) {
            solve.remark("the residual does not fall any further");
            return;
        }
    }
}

int ConjugateGradients::descend(Solve& solve, Preconditioner& preconditioner, int iterations)
{
    const std::size_t n = solve.matrix().size();
    const Span<Real> x = solve.x(), r = solve.r();
    Real rzOld = 0;
    int used = 0;
    for (Real norm = solve.norm(); norm > solve.target() && used < iterations; ++used) {
        preconditioner.apply(r, z_);
        const Real rz = orderedSum(n, [&](Index i) { return r[i] * z_[i]; });
        if (used == 0)
            p_ = z_;
        else
            parallelFor(n, [&, beta = rz / rzOld](Index i) { p_[i] = z_[i] + beta * p_[i]; });
        const Real curvature = multiplyAndDot(solve.matrix(), p_, q_);
        if (!(rz > 0) || !(curvature > 0) || !std::isfinite(rz / curvature)) {
            solve.remark("the matrix is not positive definite");
            break;
        }
        const Real alpha = rz / curvature;
        norm = std::sqrt(orderedSum(n, [&](Index i) {
            x[i] += alpha * p_[i];
            r[i] -= alpha * q_[i];
            return sqr(r[i]);
        }));
        rzOld = rz;
        solve.countIteration();
    }
    solve.measure();
    return used;
}

}  // namespace isph
