// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/LargeArray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace isph;

namespace {
constexpr std::size_t kMillion = 1 << 20;

/// Numbers of its own in the first and last place of every 4 kB.
struct Marked {
    LargeArray<int> array;
    int mark;

    Marked(std::size_t n, int m) : array(n), mark(m)
    {
        for (std::size_t k = 0; k < n; k += 1024) array[k] = mark;
        array.back() = mark;
    }
    bool whole() const
    {
        for (std::size_t k = 0; k < array.size(); k += 1024)
            if (array[k] != mark) return false;
        return array.back() == mark;
    }
};
}  // namespace

TEST(LargeArray, TakesTheMemoryThatAnotherHasGivenBack)
{
    const void* first = nullptr;
    {
        const LargeArray<int> array(12 * kMillion);
        first = array.data();
    }
    const LargeArray<int> next(10 * kMillion);
    EXPECT_EQ(next.data(), first);
}

TEST(LargeArray, SharesNoNumberWithAnother)
{
    std::mt19937 random(3);
    std::vector<Marked> arrays;
    for (int mark = 1; mark <= 60; ++mark) {
        if (arrays.size() > 4) arrays.erase(arrays.begin() + random() % arrays.size());
        arrays.emplace_back((8 + random() % 9) * kMillion + random() % 3000, mark);
        for (const Marked& a : arrays) ASSERT_TRUE(a.whole()) << a.mark << " after " << mark;
    }
}

TEST(LargeArray, KeepsItsNumbersWhenFreeMemoryIsReturned)
{
    const Marked low(9 * kMillion, 1);
    LargeArray<int> between(9 * kMillion);
    std::fill(between.begin(), between.end(), 7);
    const Marked high(9 * kMillion, 2);
    between = LargeArray<int>();
    returnFreeMemory();
    EXPECT_TRUE(low.whole() && high.whole());
    const LargeArray<int> fresh(9 * kMillion);
    EXPECT_EQ(std::count(fresh.begin(), fresh.end(), 0), static_cast<long>(fresh.size()))
        << "pages that the system has taken back come as zeros";
}
