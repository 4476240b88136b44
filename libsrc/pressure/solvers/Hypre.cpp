// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Hypre.hpp"

#include "core/Parallel.hpp"

#include <cmath>

namespace isph {

namespace {
const PressureSolver::Table::Entry<Hypre> entry{"hypre"};
/// A new start that does not halve the true residual shows that rounding limits it.
constexpr Real kLeastGain = 0.5;

/// The settings alone: the back end knows no other key.
std::unique_ptr<HypreBackend> backendOf(const Dictionary& pressure)
{
    Dictionary settings = Dictionary::parse("", pressure.name());
    const Schema keys = HypreBackend::keys();
    for (const Key& key : keys.keys())
        if (pressure.found(key.name)) settings.set(key.name, pressure.get<std::string>(key.name));
    return HypreBackend::table().make("BoomerAMG", settings, pressure, "solver");
}
}  // namespace

Schema Hypre::keys()
{
    Schema all = SolverControls::keys();
    const Schema settings = HypreBackend::keys();
    for (const Key& key : settings.keys()) all.add(key);
    return all.add(Key::integer("setupInterval",
                                "Solves that one multigrid hierarchy serves, while the number of "
                                "rows stays the same.")
                       .byDefault("1")
                       .atLeast(1));
}

Hypre::Hypre(const Dictionary& pressure)
    : controls_(pressure),
      backend_(backendOf(pressure)),
      setupInterval_(keys().get<int>(pressure, "setupInterval"))
{
}

SolverReport Hypre::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    const std::size_t n = matrix.size();
    r_.resize(n), correction_.resize(n), product_.resize(n);
    Solve solve("hypre", controls_, matrix, b, x, r_);
    if (solve.done()) return solve.report();
    const bool renew = rows_ != n || age_ >= setupInterval_;
    backend_->setUp(matrix, renew);
    rows_ = n;
    age_ = renew ? 1 : age_ + 1;
    while (!solve.done() && solve.iterationsLeft() > 0) {
        const Real before = solve.norm();
        std::fill(correction_.begin(), correction_.end(), 0);
        const int used = backend_->iterate(r_, correction_, solve.target(), solve.iterationsLeft());
        const Real size = orderedSum(n, [&](Index i) { return sqr(correction_[i]); });
        if (!std::isfinite(size)) {
            solve.remark("the matrix is not positive definite");
            break;
        }
        parallelFor(n, [&](Index i) { x[i] += correction_[i]; });
        solve.countIterations(used);
        solve.measure();
        if (!solve.done() && solve.iterationsLeft() > 0 && !(solve.norm() < kLeastGain * before)) {
            const bool definite = multiplyAndDot(matrix, correction_, product_) > 0;
            solve.remark(definite ? "the residual does not fall any further"
                                  : "the matrix is not positive definite");
            break;
        }
    }
    return solve.report();
}

}  // namespace isph
