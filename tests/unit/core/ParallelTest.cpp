// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Parallel.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace isph;

TEST(OrderedSum, OneAndThreeThreadsAgreeBitForBit)
{
    const auto term = [](Index i) { return std::sin(1e3 * i) * std::exp(1e-3 * (i % 9000)); };
    const int before = threadCount();
    setThreadCount(1);
    const Real one = orderedSum(100003, term);
    setThreadCount(3);
    const Real three = orderedSum(100003, term);
    setThreadCount(before);
    EXPECT_EQ(one, three);
}
