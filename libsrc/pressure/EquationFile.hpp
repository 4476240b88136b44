// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure equations of real steps, kept for tests and measurements of solvers.
#pragma once
#include "pressure/PressureSolver.hpp"

#include <filesystem>

namespace isph {

/// A x = b as a step handed it over: x is the first guess.
struct Equation {
    SymmetricMatrix matrix;
    std::vector<Real> b, x;
};

/// Binary, in this machine's byte order: "isphEquation2\n", the numbers of rows, entries and
/// dimensions (64-bit), then the arrays; the numbers of the particles may be left out. Throws
/// FatalError where the file cannot be written.
void writeEquation(const std::filesystem::path& file, const SymmetricMatrix& matrix,
                   Span<const Real> b, Span<const Real> x);
/// Throws FatalError where the file is missing, cut off or something else.
Equation readEquation(const std::filesystem::path& file);

/// Hands each solve on, and writes every interval-th equation to
/// <case>/postProcessing/pressureEquation/<number of the solve>.equation before it is solved.
class RecordingSolver : public PressureSolver {
public:
    RecordingSolver(std::unique_ptr<PressureSolver> solver, int interval)
        : solver_(std::move(solver)), interval_(interval)
    {
    }

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { solver_->forget(); }
    void release() override { solver_->release(); }
    void rest() override { solver_->rest(); }

private:
    std::unique_ptr<PressureSolver> solver_;
    int interval_, solves_ = 0;
};

}  // namespace isph
