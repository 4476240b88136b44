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

}  // namespace isph
