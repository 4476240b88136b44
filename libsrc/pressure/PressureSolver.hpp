// SPDX-License-Identifier: GPL-3.0-or-later
// Linear solvers of the pressure equation, chosen by name in system/isphSolution.
#pragma once
#include "pressure/SymmetricMatrix.hpp"
#include "selection/ModelTable.hpp"

#include <algorithm>
#include <string>

namespace isph {

/// |r|_2/|b|_2 before and after; both 0 for b = 0.
struct SolverReport {
    std::string solver;  ///< as printed in the log: "PCG", "cholmod", ...
    Real initialResidual = 0;
    Real finalResidual = 0;  ///< of the true residual b - A x, computed anew
    int iterations = 0;
    bool converged = false;
    std::string remark{};  ///< what was out of the ordinary; empty: nothing
};

/// When a solver stops: the keys that every pressure { ... } dictionary has.
struct SolverControls {
    Real tolerance = 1e-6;
    Real relTol = 0;
    int maxIter = 500;

    /// solver, tolerance, relTol, maxIter; a model adds its own keys to these.
    static Schema keys();
    SolverControls() = default;
    explicit SolverControls(const Dictionary& pressure);

    /// The norm of the residual that is small enough.
    Real target(Real bNorm, Real initialNorm) const
    {
        return std::max(tolerance * bNorm, relTol * initialNorm);
    }
};

class PressureSolver {
public:
    static constexpr const char* family = "pressureSolver";
    using Table = ModelTable<PressureSolver>;
    static Table& table();
    /// The solver that the dictionary names, auto where it names none:
    ///     pressure { solver multigridPCG; tolerance 1e-6; relTol 0; maxIter 200; }
    static std::unique_ptr<PressureSolver> select(const Dictionary& pressure);

    virtual ~PressureSolver() = default;

    /// Solves A x = b from the guess in x, to |r| <= max(tolerance |b|, relTol |r0|).
    /// b = 0 gives x = 0. Throws FatalError where A, b or x hold a number that is not finite.
    virtual SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) = 0;
    /// Drops whatever is kept from earlier steps: a restarted run then goes on with the same bits.
    virtual void forget() {}
    /// Gives everything back that takes memory, until the next solve.
    virtual void release() {}
    /// The same between the solves of steps: only what the next one fills anew.
    virtual void rest() {}
};

}  // namespace isph
