// SPDX-License-Identifier: GPL-3.0-or-later
// Eight numbers that one instruction handles: arithmetic, comparisons and a ? b : c work on each lane.
#pragma once
#include "core/Types.hpp"

#include <cstring>

namespace isph {

constexpr Index kLanes = 8;
/// The width of the widest vector registers; compilers split it for processors that have narrower ones,
/// with the same bits.
using Lanes = Real __attribute__((vector_size(kLanes * sizeof(Real))));

inline Lanes loadLanes(const Real* from)
{
    Lanes a;
    std::memcpy(&a, from, sizeof a);
    return a;
}

inline Lanes allLanes(Real a)
{
    return Lanes{} + a;
}

/// The sum of the lanes, always in the same order.
inline Real sumOf(const Lanes& a)
{
    return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

}  // namespace isph
