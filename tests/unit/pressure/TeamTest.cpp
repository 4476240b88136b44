// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Team.hpp"

#include "core/Error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>

using namespace isph;

namespace {

/// f() with so many threads.
template <class F>
void withThreads(int threads, F&& f)
{
    const int before = threadCount();
    setThreadCount(threads);
    f();
    setThreadCount(before);
}

}  // namespace

TEST(Team, SharesRowsOutAndAddsThemInOneOrder)
{
    for (const std::size_t n : {1, 255, 2048, 5000, 70001}) {
        std::vector<Real> sums;  // as every thread has them
        std::mutex mutex;
        for (const int threads : {1, 2, 3, 5})
            withThreads(threads, [&] {
                std::vector<int> visits(n, 0);
                std::vector<Real> term(n);
                std::atomic<int> members = 0;
                Team::run(n, [&](Team& team) {
                    ++members;
                    team.forRows(n, [&](Index i) { term[i] = std::sin(i), ++visits[i]; });
                    team.wait();
                    Real sum = 0;  // of terms that other threads have made
                    for (int round = 0; round < 20; ++round)
                        sum =
                            team.sumRows(n, [&](Index i) { return term[n - 1 - i] * (round + 1); });
                    const std::scoped_lock lock(mutex);
                    sums.push_back(sum);
                });
                EXPECT_EQ(members, n < Team::kTeamRows ? 1 : threads);
                EXPECT_EQ(visits, std::vector<int>(n, 1));
            });
        for (const Real sum : sums) EXPECT_EQ(sum, sums.front()) << n;
    }
}

TEST(Team, WaitsForWhatOneThreadDoes)
{
    withThreads(3, [] {
        const std::size_t n = 10000;
        std::vector<int> seen(n, 0);
        int calls = 0;
        Team::run(n, [&](Team& team) {
            for (int round = 1; round <= 50; ++round) {
                team.single([&](Team&) { ++calls; });
                team.forRows(n, [&](Index i) { seen[i] += calls == round; });
            }
        });
        EXPECT_EQ(calls, 50);
        EXPECT_EQ(seen, std::vector<int>(n, 50));
    });
}

TEST(Team, HandsOnTheErrorOfOneThread)
{
    withThreads(2, [] {
        const auto fail = [](Team&) { throw FatalError("no memory"); };
        for (const std::size_t n : {10, 10000})
            EXPECT_THROW(Team::run(n, [&](Team& team) { team.single(fail); }), FatalError) << n;
    });
}
