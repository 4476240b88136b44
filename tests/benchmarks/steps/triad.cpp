// SPDX-License-Identifier: GPL-3.0-or-later
// triad: the memory bandwidth of the machine [GB/s], a = b + s c on arrays far beyond its caches.
// Threads: OMP_NUM_THREADS. Counts 24 bytes a term, as STREAM does, in the best of 10 passes.
#include "core/Parallel.hpp"
#include "core/Timers.hpp"

#include <fmt/core.h>

#include <limits>
#include <memory>

int main()
{
    using namespace isph;
    constexpr std::size_t n = 40'000'000;
    const auto array = [] { return std::make_unique_for_overwrite<Real[]>(n); };
    const auto a = array(), b = array(), c = array();
    parallelFor(n, [&](Index i) { a[i] = 0, b[i] = 1, c[i] = 2; });  // first touch
    double best = std::numeric_limits<double>::max();
    for (int pass = 0; pass < 10; ++pass) {
        const double start = wallSeconds();
        parallelFor(n, [&](Index i) { a[i] = b[i] + Real(3) * c[i]; });
        best = std::min(best, wallSeconds() - start);
    }
    if (a[n / 2] != 7) return 1;
    fmt::print("{:.2f}\n", 24e-9 * static_cast<double>(n) / best);
}
