// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a sparse matrix times a vector.
#pragma once
#include "pressure/SymmetricMatrix.hpp"

namespace isph {

/// (A x)_i of a matrix whose off-diagonals may be in single precision, summed in double. Four sums
/// hide the latency of additions; gather instructions take three times as long as the loads that
/// the compiler makes of this (Zen 4).
[[gnu::always_inline]] inline Real rowTimes(const SymmetricMatrix& matrix, Span<const Real> x,
                                            Index i)
{
    const PairIndex end = matrix.rowStart[i + 1];
    PairIndex k = matrix.rowStart[i];
    const auto term = [&](PairIndex at) {
        return static_cast<Real>(matrix.offDiagonal[at]) * x[matrix.column[at]];
    };
    Real s0 = matrix.diagonal[i] * x[i], s1 = 0, s2 = 0, s3 = 0;
    for (; k + 4 <= end; k += 4)
        s0 += term(k), s1 += term(k + 1), s2 += term(k + 2), s3 += term(k + 3);
    for (; k < end; ++k) s0 += term(k);
    return (s0 + s1) + (s2 + s3);
}

}  // namespace isph
