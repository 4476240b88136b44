// SPDX-License-Identifier: GPL-3.0-or-later
// What is the same in every solve: norms, target, report.
#pragma once
#include "pressure/PressureSolver.hpp"

namespace isph {

/// One solve of A x = b from its start to its report. It refers to the caller's arrays.
class Solve {
public:
    /// Fills r = b - A x. For b = 0 it sets x = 0, and done() is true at once.
    /// Throws FatalError that names the row where A, b or x is not finite.
    Solve(const char* solver, const SolverControls& controls, const SymmetricMatrix& matrix,
          Span<const Real> b, Span<Real> x, Span<Real> r);

    const SymmetricMatrix& matrix() const { return matrix_; }
    Span<Real> x() { return x_; }
    Span<Real> r() { return r_; }

    Real target() const { return target_; }
    Real norm() const { return norm_; }  ///< |r| as measured last
    bool done() const { return norm_ <= target_; }
    int iterationsLeft() const { return controls_.maxIter - report_.iterations; }
    void countIterations(int used) { report_.iterations += used; }
    void remark(const std::string& text);

    /// Recomputes r = b - A x and its norm.
    void measure();
    /// r must have been measured after the last change of x.
    SolverReport report() const;

private:
    [[noreturn]] void failNotFinite() const;

    const SolverControls& controls_;
    const SymmetricMatrix& matrix_;
    Span<const Real> b_;
    Span<Real> x_, r_;
    Real bNorm_ = 0, norm_ = 0, target_ = 0;
    SolverReport report_;
};

}  // namespace isph
