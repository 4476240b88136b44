// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that go through the same code together, loop by loop.
#pragma once
#include "core/Parallel.hpp"
#include "pressure/SymmetricMatrix.hpp"

#include <array>
#include <atomic>
#include <cstring>
#include <exception>

namespace isph {

/// What a solve needs instead of a parallel region for every loop: waking threads takes tens of
/// microseconds, as long as a loop over some thousand rows. All threads of a team call the same
/// functions with the same numbers; forRows() and sumRows() share the work out, wait() has everyone
/// arrive before anyone goes on.
class Team {
public:
    /// f(team) on all threads; on this one alone where there are fewer than kTeamRows rows.
    template <class F>
    static void run(std::size_t rows, F&& f);

    /// A thread alone whose loops are parallel regions of their own.
    static Team ofRegions()
    {
        Team team;
        team.opens_ = true;
        return team;
    }

    /// Below this many rows a loop is left to one thread.
    static constexpr std::size_t kTeamRows = 2048;

    bool leads() const { return rank_ == 0; }

    /// f(i) for this thread's share of [0, n). Others may not have done theirs yet.
    template <class F>
    void forRows(std::size_t n, F&& f) const
    {
        if (opens_) return parallelFor(n, f);
        const Index last = end(n, rank_);
        for (Index i = end(n, rank_ - 1); i < last; ++i) f(i);
    }

    /// Sum of term(i) over [0, n), known to all threads. The order depends on n alone, hence the
    /// bits do as well. All have called term for all rows when it returns.
    template <class Term>
    auto sumRows(std::size_t n, Term&& term);

    /// Returns when all threads have called it.
    void wait() const
    {
        if (size_ > 1) meet();
    }

    /// f(a team of one) on one thread, after all have arrived; all wait for it.
    template <class F>
    void single(F&& f) const;

private:
    static constexpr std::size_t kBlock = 256;  ///< rows whose terms are added before the sums are
    static constexpr std::size_t kNumbers = 3;  ///< that a sum may consist of

    struct alignas(64) Shared {
        alignas(64) std::atomic<int> arrived{0};
        alignas(64) std::atomic<unsigned> round{0};
        std::exception_ptr error;
        /// Sums of blocks. Two in turn: a thread may still read the last ones when another begins
        /// anew.
        std::array<LargeArray<Real>, 2> sums;
    };

    Team() = default;
    Team(Shared& shared, int rank, int size) : shared_(&shared), rank_(rank), size_(size) {}
    void meet() const;
    static int threadNumber();
    static int threadsHere();

    /// One past the last row of a thread: whole blocks.
    Index end(std::size_t n, int rank) const
    {
        const std::size_t blocks = (n + kBlock - 1) / kBlock;
        return static_cast<Index>(
            std::min(n, blocks * static_cast<std::size_t>(rank + 1) / size_ * kBlock));
    }

    Shared* shared_ = nullptr;
    int rank_ = 0, size_ = 1;
    bool opens_ = false;
    bool second_ = false;  ///< of the two arrays of sums
};

template <class F>
void Team::run(std::size_t rows, F&& f)
{
    if (rows < kTeamRows || threadCount() == 1) {
        Team alone;
        return f(alone);
    }
    Shared shared;
    for (LargeArray<Real>& sums : shared.sums) sums.resize(kNumbers * (rows / kBlock + 1));
#pragma omp parallel
    {
        Team team(shared, threadNumber(), threadsHere());
        f(team);
    }
    if (shared.error) std::rethrow_exception(shared.error);
}

template <class F>
void Team::single(F&& f) const
{
    wait();
    if (leads()) try {
            Team alone;
            f(alone);
        } catch (...) {
            if (size_ == 1) throw;
            shared_->error = std::current_exception();
        }
    wait();
}

template <class Term>
auto Team::sumRows(std::size_t n, Term&& term)
{
    using T = decltype(term(Index{0}));
    if (opens_) return orderedSum(n, term);
    const auto block = [&](std::size_t first) {
        T sum{};
        const auto last = static_cast<Index>(std::min(n, first + kBlock));
        for (auto i = static_cast<Index>(first); i < last; ++i) sum = sum + term(i);
        return sum;
    };
    T total{};
    if (size_ == 1) {
        for (std::size_t first = 0; first < n; first += kBlock) total = total + block(first);
        return total;
    }
    static_assert(sizeof(T) <= kNumbers * sizeof(Real));
    Real* const sums = shared_->sums[second_].data();
    second_ = !second_;
    const auto place = [&](std::size_t first) { return sums + kNumbers * (first / kBlock); };
    for (std::size_t first = end(n, rank_ - 1); first < static_cast<std::size_t>(end(n, rank_));
         first += kBlock) {
        const T sum = block(first);
        std::memcpy(place(first), static_cast<const void*>(&sum), sizeof sum);
    }
    wait();
    for (std::size_t first = 0; first < n; first += kBlock) {
        T sum;
        std::memcpy(static_cast<void*>(&sum), place(first), sizeof sum);
        total = total + sum;
    }
    return total;
}

}  // namespace isph
