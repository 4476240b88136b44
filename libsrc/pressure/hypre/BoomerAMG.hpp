// SPDX-License-Identifier: GPL-3.0-or-later
// hypre's BoomerAMG-PCG on the rows that belong to one MPI rank.
#pragma once
#include "pressure/HypreBackend.hpp"

#include <mpi.h>

namespace isph {

class BoomerAMG : public HypreBackend {
public:
    static Schema keys() { return HypreBackend::keys(); }
    /// One rank. MPI is started where the program has not done so.
    explicit BoomerAMG(const Dictionary& settings);
    /// All ranks of comm must make, set up and iterate together.
    BoomerAMG(const Dictionary& settings, MPI_Comm comm);
    ~BoomerAMG() override;
    BoomerAMG(const BoomerAMG&) = delete;
    BoomerAMG& operator=(const BoomerAMG&) = delete;

    void setUp(const SymmetricMatrix& matrix, bool newHierarchy) override;
    int iterate(Span<const Real> b, Span<Real> x, Real target, int maxIter) override;

    /// As setUp(), of the rows first .. last-1 alone; b and x of iterate() are theirs.
    void setUpRows(const SymmetricMatrix& matrix, Index first, Index last, bool newHierarchy);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace isph
