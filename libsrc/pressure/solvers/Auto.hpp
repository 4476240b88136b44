// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "pressure/solvers/LagCholmod.hpp"
#include "pressure/solvers/MultigridPCG.hpp"

#include <array>

namespace isph {

/// Picks the solver that is fastest at the size and dimension of each equation, and writes a line
/// to the log when it takes one for the first time:
///   lagCholmod    2-D, up to 1000 rows: several times faster where particles move little, equal
///                 where they splash
///   multigridPCG  all else
/// The choice depends on the equation alone, so that a restarted run makes the same.
class Auto : public PressureSolver {
public:
    static Schema keys() { return SolverControls::keys(); }
    explicit Auto(const Dictionary& pressure) : lagCholmod_(pressure), multigridPCG_(pressure) {}

    SolverReport solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x) override;
    void forget() override { lagCholmod_.forget(), multigridPCG_.forget(); }
    void release() override { multigridPCG_.release(); }
    void rest() override { multigridPCG_.rest(); }

private:
    LagCholmod lagCholmod_;
    MultigridPCG multigridPCG_;
    std::array<bool, 2> told_{};
};

}  // namespace isph
