// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/Components.hpp"

#include "core/Parallel.hpp"

#include <atomic>

namespace isph {

namespace {
constexpr Index kSerialRows = 8192;   // a single thread sweeps as many before another wakes
}

const FloatingComponents& ComponentFinder::find(const SymmetricMatrix& matrix,
                                                Span<const char> anchored)
{
    const auto n = static_cast<Index>(matrix.size());
    floating_.start.assign(1, 0);
    floating_.row.clear();
    reached_.resize(n);
    parallelFor(n, [&](Index i) { reached_[i] = anchored[i] != 0; });
    // Two sweeps reach nearly all rows, most of them by the first or second neighbour. Threads
    // sweep runs of rows of their own first; which rows that reaches depends on them, what all
    // sweeps and floods find in the end does not.
    const Index runs = n < kSerialRows ? 0 : threadCount();
#pragma omp parallel for schedule(static, 1)
    for (Index run = 0; run < runs; ++run)
        sweepTwice(matrix, n * PairIndex{run} / runs, n * (PairIndex{run} + 1) / runs);
    sweepTwice(matrix, 0, n);
    for (Index i = 0; i < n; ++i)
        if (!reached_[i]) flood(matrix, i);
    return floating_;
}

void ComponentFinder::sweepTwice(const SymmetricMatrix& matrix, PairIndex first, PairIndex last)
{
    for (PairIndex i = last; i-- > first;) sweep(matrix, static_cast<Index>(i));
    for (PairIndex i = first; i < last; ++i) sweep(matrix, static_cast<Index>(i));
}

/// Row i is reached if one of its neighbours is.
void ComponentFinder::sweep(const SymmetricMatrix& matrix, Index i)
{
    const auto reached = [&](Index row) { return std::atomic_ref(reached_[row]); };
    if (reached(i).load(std::memory_order_relaxed)) return;
    for (PairIndex k = matrix.rowStart[i]; k < matrix.rowStart[i + 1]; ++k)
        if (matrix.offDiagonal[k] != 0 &&
            reached(matrix.column[k]).load(std::memory_order_relaxed) == 1)
            return reached(i).store(1, std::memory_order_relaxed);
}

/// Gathers the rows connected to the seed that no sweep has reached; they float if none of them
/// touches a row that was.
void ComponentFinder::flood(const SymmetricMatrix& matrix, Index seed)
{
    constexpr char gathered = 2;
    bool touches = false;
    std::vector<Index>& row = floating_.row;
    std::size_t next = row.size();
    row.push_back(seed);
    reached_[seed] = gathered;
    for (; next < row.size(); ++next)
        for (PairIndex k = matrix.rowStart[row[next]]; k < matrix.rowStart[row[next] + 1]; ++k) {
            if (matrix.offDiagonal[k] == 0) continue;
            char& state = reached_[matrix.column[k]];
            touches |= state == 1;
            if (state) continue;
            state = gathered;
            row.push_back(matrix.column[k]);
        }
    if (touches)
        row.resize(floating_.start.back());
    else
        floating_.start.push_back(static_cast<PairIndex>(row.size()));
}

namespace {
void subtractMean(Span<Real> values, Span<const Index> rows)
{
    Real sum = 0;
    for (const Index i : rows) sum += values[i];
    const Real mean = sum / static_cast<Real>(rows.size());
    for (const Index i : rows) values[i] -= mean;
}
}  // namespace

void makeSolvable(SymmetricMatrix& matrix, Span<Real> b, const FloatingComponents& floating)
{
    for (std::size_t c = 0; c < floating.size(); ++c) {
        subtractMean(b, floating[c]);
        Real& diagonal = matrix.diagonal[floating[c].front()];
        diagonal = diagonal > 0 ? 2 * diagonal : 1;
    }
}

void startAtZero(Span<Real> x, const FloatingComponents& floating)
{
    for (std::size_t c = 0; c < floating.size(); ++c) {
        const Real first = x[floating[c].front()];
        for (const Index i : floating[c]) x[i] -= first;
    }
}

void removeMean(Span<Real> x, const FloatingComponents& floating)
{
    for (std::size_t c = 0; c < floating.size(); ++c) subtractMean(x, floating[c]);
}

}  // namespace isph
