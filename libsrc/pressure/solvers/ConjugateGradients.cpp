// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/ConjugateGradients.hpp"

#include "core/Parallel.hpp"
#include "core/Vec.hpp"

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
    Real rzOld = 0, alpha = 0;
    int used = 0;
    for (Real norm = solve.norm(); norm > solve.target() && used < iterations; ++used) {
        preconditioner.apply(r, z_);
        Real rz = 0;
        if (used == 0) {
            p_ = z_;
            rz = orderedSum(n, [&](Index i) { return r[i] * z_[i]; });
        } else {  // z.(r - r_old) = -alpha z.q: 0 beside round-off where M is fixed, so no r_old is
                  // kept
            const Vec<2> dots = orderedSum(n, [&](Index i) {
                return Vec<2>{r[i] * z_[i], q_[i] * z_[i]};
            });
            rz = dots[0];
            parallelFor(
                n, [&, beta = -alpha * dots[1] / rzOld](Index i) { p_[i] = z_[i] + beta * p_[i]; });
        }
        const Real curvature = preconditioner.multiplyAndDot(solve.matrix(), p_, q_);
        if (!(rz > 0) || !(curvature > 0) || !std::isfinite(rz / curvature)) {
            solve.remark("the matrix is not positive definite");
            break;
        }
        alpha = rz / curvature;
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
