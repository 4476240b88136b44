// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over the rows of a level of the multigrid, and what they share.
#pragma once
#include "core/Parallel.hpp"
#include "core/Vec.hpp"
#include "pressure/SymmetricMatrix.hpp"

namespace isph {

/// Below this many rows a loop takes less time than waking the threads (tens of microseconds).
constexpr std::size_t kSerialRows = 8192;

/// f(i) for i in [0, n); f may write only what belongs to i.
template <class F>
void forRows(std::size_t n, F&& f)
{
    if (n >= kSerialRows) return parallelFor(n, f);
    for (Index i = 0; i < static_cast<Index>(n); ++i) f(i);
}

/// Sum of term(i) over [0, n). The order depends on n alone, hence the bits do as well.
template <class Term>
auto sumRows(std::size_t n, Term&& term)
{
    if (n >= kSerialRows) return orderedSum(n, term);
    decltype(term(Index{0})) sum{};
    for (Index i = 0; i < static_cast<Index>(n); ++i) sum = sum + term(i);
    return sum;
}

/// A symmetric matrix whose off-diagonals may be in single precision; it refers to arrays of
/// others.
template <class Weight>
struct LevelMatrix {
    Span<const PairIndex> rowStart;
    Span<const Index> column;
    Span<const Weight> offDiagonal;
    Span<const Real> diagonal;

    std::size_t size() const { return diagonal.size(); }

    /// (A x)_i, summed in double. Four sums hide the latency of additions; gather instructions take
    /// three times as long as the loads that the compiler makes of this (Zen 4).
    Real rowTimes(Span<const Real> x, Index i) const
    {
        const PairIndex end = rowStart[i + 1];
        PairIndex k = rowStart[i];
        const auto term = [&](PairIndex at) {
            return static_cast<Real>(offDiagonal[at]) * x[column[at]];
        };
        Real s0 = diagonal[i] * x[i], s1 = 0, s2 = 0, s3 = 0;
        for (; k + 4 <= end; k += 4)
            s0 += term(k), s1 += term(k + 1), s2 += term(k + 2), s3 += term(k + 3);
        for (; k < end; ++k) s0 += term(k);
        return (s0 + s1) + (s2 + s3);
    }
};

template <class Weight>
LevelMatrix<Weight> levelMatrix(const RowMatrix<Weight>& matrix)
{
    return {matrix.rowStart, matrix.column, matrix.offDiagonal, matrix.diagonal};
}

}  // namespace isph
