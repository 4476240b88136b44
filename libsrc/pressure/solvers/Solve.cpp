// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Solve.hpp"

#include "core/Error.hpp"
#include "core/Parallel.hpp"

#include <fmt/core.h>

#include <cmath>

namespace isph {

Solve::Solve(const char* solver, const SolverControls& controls, const SymmetricMatrix& matrix,
             Span<const Real> b, Span<Real> x, Span<Real> r)
    : controls_(controls), matrix_(matrix), b_(b), x_(x), r_(r)
{
    const std::size_t n = matrix.size();
    if (b.size() != n || x.size() != n)
        throw FatalError(
            fmt::format("The pressure equation has {} rows, but b has {} and p has {} values.", n,
                        b.size(), x.size()));
    report_.solver = solver;
    bNorm_ = std::sqrt(orderedSum(n, [&](Index i) { return sqr(b[i]); }));
    if (bNorm_ == 0) {
        parallelFor(n, [&](Index i) { x[i] = r[i] = 0; });
        return;
    }
    measure();
    if (!std::isfinite(norm_) || !std::isfinite(bNorm_)) failNotFinite();
    target_ = controls.target(bNorm_, norm_);
    report_.initialResidual = norm_ / bNorm_;
}

void Solve::remark(const std::string& text)
{
    if (report_.remark.find(text) != std::string::npos) return;
    if (!report_.remark.empty()) report_.remark += ", ";
    report_.remark += text;
}

void Solve::measure()
{
    norm_ = residual(matrix_, x_, b_, r_);
}

SolverReport Solve::report() const
{
    SolverReport report = report_;
    report.finalResidual = bNorm_ > 0 ? norm_ / bNorm_ : 0;
    report.converged = done();
    return report;
}

void Solve::failNotFinite() const
{
    const auto fail = [](const char* what, std::size_t row, Real value) {
        throw FatalError(fmt::format("The pressure equation cannot be solved: {} of row {} is {}.",
                                     what, row, value));
    };
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
        if (!std::isfinite(b_[i])) fail("the right-hand side", i, b_[i]);
        if (!std::isfinite(matrix_.diagonal[i])) fail("the diagonal", i, matrix_.diagonal[i]);
        for (PairIndex k = matrix_.rowStart[i]; k < matrix_.rowStart[i + 1]; ++k)
            if (!std::isfinite(matrix_.offDiagonal[k]))
                fail("an off-diagonal coefficient", i, matrix_.offDiagonal[k]);
        if (!std::isfinite(x_[i])) fail("the first guess of the pressure", i, x_[i]);
    }
    throw FatalError(
        "The pressure equation cannot be solved: its numbers are too large to be squared.");
}

}  // namespace isph
