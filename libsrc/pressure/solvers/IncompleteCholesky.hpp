// SPDX-License-Identifier: GPL-3.0-or-later
// Incomplete Cholesky factor without fill, plain and modified.
#pragma once
#include "pressure/solvers/ConjugateGradients.hpp"

#include <array>
#include <optional>
#include <vector>

namespace isph {

/// M = L L^T with the pattern of A (Meijerink & van der Vorst 1977, Math. Comp. 31, 148-162). The
/// fill that the pattern has no room for is multiplied by `relaxation` and added to the diagonal: 0
/// is IC(0), 1 the modified factor of Gustafsson (1978, BIT 18, 142-156), which keeps the row sums.
///
/// For two threads the elimination starts at both ends and meets in the middle (van der Vorst 1987,
/// Parallel Comput. 5, 45-54): the lower half of the rows in ascending order, those of the upper
/// half in descending order, last those of the upper half that touch the lower one. With rows in
/// the order of a cell grid this costs no iterations; four starts nearly double them. The split is
/// the same for any number of threads, hence so are the results.
///
/// L is kept in single precision (M stays symmetric to the last bit); sums are double.
class IncompleteCholesky : public Preconditioner {
public:
    explicit IncompleteCholesky(Real relaxation) : relaxation_(relaxation) {}

    /// Factorises A + shift diag(A), with the first shift of 0, 1e-3, 1e-2, ... 10 whose pivots are
    /// positive. Returns the shift, or nothing where there is none: A is not positive definite.
    std::optional<Real> factorise(const SymmetricMatrix& matrix);
    void apply(Span<const Real> r, Span<Real> z) override;

private:
    /// Rows in the new order: [0], [1] the halves, which do not touch each other, [2] the middle.
    struct Section {
        Index first = 0, last = 0;
    };
    void number(const SymmetricMatrix& matrix);
    void countColumns(const SymmetricMatrix& matrix);
    bool eliminate(const SymmetricMatrix& matrix, Real shift);

    /// What the elimination of a row needs.
    struct Workspace {
        std::vector<Index> slot;  ///< of a column in the row at hand; 0: no place
        std::vector<Real> value;  ///< by slot; slot 0 gathers the dropped fill, slot 1 the diagonal
    };
    bool eliminate(const SymmetricMatrix& matrix, Section section, Real shift, Workspace& work);
    bool eliminateRow(const SymmetricMatrix& matrix, Index k, Real shift, Workspace& work);
    void forward(Section section, Span<const Real> r);
    void backward(Section section, Span<Real> z);

    Real relaxation_;
    std::array<Section, 3> sections_;
    std::vector<Index> oldRow_, newRow_;
    std::vector<PairIndex> lowerStart_, upperStart_;
    std::vector<Index> lowerColumn_, upperColumn_;
    std::vector<float> lower_;  ///< L, rows
    std::vector<Real> upper_;   ///< U = D L^T of A = L D L^T, rows; used while factorising
    std::vector<Real> pivot_, inverseRoot_;
    std::vector<Real> y_;
    std::array<Workspace, 2> work_;
};

}  // namespace isph
