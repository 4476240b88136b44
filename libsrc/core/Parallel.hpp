// SPDX-License-Identifier: GPL-3.0-or-later
// Threaded loops over particles whose results do not depend on the number of threads.
#pragma once
#include "core/Types.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isph {

/// Sums are taken in blocks of this many terms and the block sums added in order.
constexpr std::size_t kSumBlock = 1024;

int threadCount();
void setThreadCount(int threads);

/// f(i) for i in [0, n). f may write only what belongs to i.
template <class F>
void parallelFor(std::size_t n, F&& f)
{
    const auto last = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(static) if (last > 256)
    for (std::ptrdiff_t i = 0; i < last; ++i) f(static_cast<Index>(i));
}

/// As parallelFor, for bodies of unequal cost (rows of very different length).
template <class F>
void parallelForDynamic(std::size_t n, F&& f)
{
    const auto last = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(dynamic, 64) if (last > 256)
    for (std::ptrdiff_t i = 0; i < last; ++i) f(static_cast<Index>(i));
}

namespace detail {
template <class T, class Term, class Combine>
T orderedReduce(std::size_t n, T start, Term&& term, Combine&& combine)
{
    const std::size_t blocks = (n + kSumBlock - 1) / kSumBlock;
    std::vector<T> part(blocks, start);
    const auto last = static_cast<std::ptrdiff_t>(blocks);
#pragma omp parallel for schedule(static) if (last > 1)
    for (std::ptrdiff_t b = 0; b < last; ++b) {
        T sum = start;
        const std::size_t end = std::min(n, (b + 1) * kSumBlock);
        for (std::size_t i = b * kSumBlock; i < end; ++i)
            sum = combine(sum, term(static_cast<Index>(i)));
        part[b] = sum;
    }
    T total = start;
    for (const T& p : part) total = combine(total, p);
    return total;
}
}  // namespace detail

/// Sum of term(i) over [0, n): the same bits for any number of threads. T{} must be zero.
template <class Term>
auto orderedSum(std::size_t n, Term&& term)
{
    using T = decltype(term(Index{0}));
    return detail::orderedReduce(n, T{}, term, [](T a, const T& b) { a = a + b; return a; });
}

/// Largest term(i) over [0, n), and `least` where n = 0.
template <class Term>
Real orderedMax(std::size_t n, Real least, Term&& term)
{
    return detail::orderedReduce(n, least, term, [](Real a, Real b) { return std::max(a, b); });
}

}  // namespace isph
