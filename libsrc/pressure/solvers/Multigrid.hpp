// SPDX-License-Identifier: GPL-3.0-or-later
// Aggregation multigrid, the preconditioner of multigridPCG.                       [theory
// (5.8)-(5.11)]
#pragma once
#include "pressure/solvers/CholmodFactor.hpp"
#include "pressure/solvers/CoarseMatrix.hpp"

#include <memory>
#include <vector>

namespace isph {

/// z = B r: damped Jacobi, coarse correction e = P (P^T A P)^-1 P^T (r - A z), damped Jacobi. The
/// coarse equation is solved by two steps of flexible conjugate gradients with the same cycle of
/// its own level (K-cycle: Notay & Vassilevski 2008, Numer. Linear Algebra Appl. 15, 473-487),
/// which makes up for what piecewise constant corrections lack; the coarsest by a Cholesky factor.
/// The inner steps make B depend on r a little: it needs flexible conjugate gradients outside.
///
/// Off-diagonals are in single precision, all else in double. A whole solve is done by one team of
/// threads; levels of few rows are left to one of them. Groups of rows come from the places of the
/// rows (Aggregation::byCells), from the coefficients alone where places are not known. No state is
/// kept from matrix to matrix.
class Multigrid : public Preconditioner {
public:
    /// False where a diagonal is not positive, or the coarsest matrix has no Cholesky factor.
    bool setUp(const SymmetricMatrix& matrix);
    void apply(Span<const Real> r, Span<Real> z) override;
    bool inTeam() const override { return true; }
    void apply(Team& team, Span<const Real> r, Span<Real> z) override;

    std::size_t levels() const { return used_ + 1; }
    /// Entries of all levels over those of level 0.
    Real operatorComplexity() const;

private:
    /// What every level has to smooth and to go down.
    struct Level {
        RowSums sums;              ///< while the hierarchy is made
        LargeArray<CellKey> keys;  ///< empty: places are not known
        Aggregation groups;        ///< unused on the coarsest level
        LargeArray<Real> inverse;  ///< of the smoother, damping included; in the memory of sums
        LargeArray<Real> t;        ///< the same

        void begin() { sums.excess.swap(inverse), sums.largest.swap(t); }
        void finish(Span<const Real> diagonal);
    };
    /// Right-hand side r, solution x, corrections c, d of the two steps, v = A c.
    struct CoarseLevel : Level {
        SymmetricMatrix matrix;
        LargeArray<Real> r, x, c, d, v;
    };

    bool sumFine(const SymmetricMatrix& matrix);
    bool coarsen(const SymmetricMatrix& matrix);
    void finish(const SymmetricMatrix& matrix);
    bool group(const SymmetricMatrix& matrix, Level& level);
    void addLevel(const SymmetricMatrix& matrix, const Level& level);
    bool factorise(SymmetricMatrix& coarsest);

    void cycle(Team& team, const SymmetricMatrix& matrix, Level& level, std::size_t coarser,
               Span<const Real> r, Span<Real> z);
    void correct(Team& team, Level& level, std::size_t coarser, Span<const Real> residual);
    void solveCoarse(Team& team, std::size_t l);

    const SymmetricMatrix* matrix_ = nullptr;  ///< of the last setUp()
    Level fine_;
    std::vector<std::unique_ptr<CoarseLevel>> coarse_;  ///< kept from solve to solve
    std::size_t used_ = 0;                              ///< of them, by the matrix at hand
    CoarseMatrixBuilder builder_;
    CholmodFactor factor_;
    bool direct_ = false;  ///< the coarsest level is solved by the factor
};

}  // namespace isph
