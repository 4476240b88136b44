// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/ConjugateGradients.hpp"

#include "core/Vec.hpp"
#include "pressure/RowTimes.hpp"

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
    int used = 0;
    if (preconditioner.inTeam()) {
        Team::run(solve.matrix().size(), [&](Team& team) {
            const int now = descend(team, solve, preconditioner, iterations);
            if (team.leads()) used = now;
        });
    } else {
        Team team = Team::ofRegions();
        used = descend(team, solve, preconditioner, iterations);
    }
    solve.countIterations(used);
    solve.measure();
    return used;
}

int ConjugateGradients::descend(Team& team, Solve& solve, Preconditioner& preconditioner,
                                int iterations)
{
    const SymmetricMatrix& matrix = solve.matrix();
    const std::size_t n = matrix.size();
    const Span<Real> x = solve.x(), r = solve.r(), z = z_, p = p_, q = q_;
    Real norm = solve.norm(), rzOld = 0, alpha = 0;
    int used = 0;
    for (; norm > solve.target() && used < iterations; ++used) {
        preconditioner.apply(team, r, z);
        Real rz = 0;
        if (used == 0) {
            rz = team.sumRows(n, [&](Index i) {
                p[i] = z[i];
                return r[i] * z[i];
            });
        } else {  // z.(r - r_old) = -alpha z.q: 0 beside round-off where M is fixed, so no r_old is
                  // kept
            const Vec<2> dots = team.sumRows(n, [&](Index i) {
                return Vec<2>{r[i] * z[i], q[i] * z[i]};
            });
            rz = dots[0];
            team.forRows(
                n, [&, beta = -alpha * dots[1] / rzOld](Index i) { p[i] = z[i] + beta * p[i]; });
            team.wait();
        }
        const Real curvature = team.sumRows(n, [&](Index i) {
            q[i] = rowTimes(matrix, p, i);
            return p[i] * q[i];
        });
        if (!(rz > 0) || !(curvature > 0) || !std::isfinite(rz / curvature)) {
            if (team.leads()) solve.remark("the matrix is not positive definite");
            break;
        }
        alpha = rz / curvature;
        norm = std::sqrt(team.sumRows(n, [&](Index i) {
            x[i] += alpha * p[i];
            r[i] -= alpha * q[i];
            return sqr(r[i]);
        }));
        rzOld = rz;
    }
    return used;
}

}  // namespace isph
