// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of the pressure equation: symmetric, positive definite, off-diagonals <= 0.
#pragma once
#include "core/LargeArray.hpp"
#include "core/Types.hpp"

#include <vector>

namespace isph {

/// Where the rows stand, for solvers that group rows by place, and whose they are, for solvers that
/// keep something from step to step.
struct RowPlaces {
    int dimension = 0;             ///< 0: not known
    LargeArray<Index> particle;   ///< number of the row's particle; ascending
    LargeArray<Real> coordinate;  ///< `dimension` values a row
    LargeArray<Real> spacing;     ///< distance between neighbours, one value a row; larger in soil

    bool known() const { return dimension > 0; }
};

/// The matrix of the pressure equation: an entry takes 8 bytes. Rows hold both halves of the
/// off-diagonal entries; the diagonal stands apart. Whoever assembles it sums the diagonal from the
/// rounded off-diagonals, so that row sums are what they should be: a constant pressure drives
/// nothing. Rounding changes coefficients by 6e-8, no more.
struct SymmetricMatrix {
    LargeArray<PairIndex> rowStart{0};  ///< size()+1
    LargeArray<Index> column;
    LargeArray<float> offDiagonal;
    LargeArray<Real> diagonal;
    RowPlaces places{};  ///< optional; whoever assembles the matrix fills it or leaves it unknown

    bool ascending = true;  ///< the columns of every row; coarse levels of a solver do without

    std::size_t size() const { return diagonal.size(); }
};

/// y = A x
void multiply(const SymmetricMatrix& matrix, Span<const Real> x, Span<Real> y);

/// y = A x; returns x . A x, summed in order.
Real multiplyAndDot(const SymmetricMatrix& matrix, Span<const Real> x, Span<Real> y);

/// r = b - A x; returns |r|_2, summed in order.
Real residual(const SymmetricMatrix& matrix, Span<const Real> x, Span<const Real> b, Span<Real> r);

/// |b - A x|_2, summed in order (the same bits for any number of threads).
Real residualNorm(const SymmetricMatrix& matrix, Span<const Real> x, Span<const Real> b);

}  // namespace isph
