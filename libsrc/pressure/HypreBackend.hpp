// SPDX-License-Identifier: GPL-3.0-or-later
// What the solver hypre asks of the library that links to hypre and MPI.
#pragma once
#include "pressure/SymmetricMatrix.hpp"
#include "selection/ModelTable.hpp"

#include <memory>

namespace isph {

/// A family of its own, so that hypre and MPI are mapped by runs that choose the solver hypre only.
class HypreBackend {
public:
    static constexpr const char* family = "hypreBackend";
    using Table = ModelTable<HypreBackend>;
    static Table& table();

    /// coarsening, aggressiveLevels, strongThreshold: the settings of BoomerAMG.
    static Schema keys();

    virtual ~HypreBackend() = default;
    /// Copies the matrix; makes the multigrid hierarchy anew if asked to or if none is held.
    virtual void setUp(const SymmetricMatrix& matrix, bool newHierarchy) = 0;
    /// Iterates from x to |b - A x| <= target, or at most maxIter times. Returns the iterations.
    virtual int iterate(Span<const Real> b, Span<Real> x, Real target, int maxIter) = 0;
};

}  // namespace isph
