// SPDX-License-Identifier: GPL-3.0-or-later
// Eight numbers that one instruction handles: arithmetic, comparisons and a ? b : c work on each
// lane.
#pragma once
#include "core/Types.hpp"

#include <array>
#include <cstring>

// Processors without registers of this width pass Lanes in memory. No function that a library
// exports takes or returns them, so that libraries of unequal options go together.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace isph {

constexpr Index kLanes = 8;
/// The width of the widest vector registers; compilers split it for processors that have narrower
/// ones, with the same bits.
using Lanes = Real __attribute__((vector_size(kLanes * sizeof(Real))));

inline Lanes loadLanes(const Real* from)
{
    Lanes a;
    std::memcpy(&a, from, sizeof a);
    return a;
}

/// Four numbers from each of two places.
inline Lanes loadLanes(const Real* low, const Real* high)
{
    using Half = Real __attribute__((vector_size(kLanes / 2 * sizeof(Real))));
    Half a, b;
    std::memcpy(&a, low, sizeof a);
    std::memcpy(&b, high, sizeof b);
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

inline Lanes loadLanes(const float* from)
{
    using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));
    Floats a;
    std::memcpy(&a, from, sizeof a);
    return __builtin_convertvector(a, Lanes);
}

inline void storeLanes(const Lanes& a, Real* to)
{
    std::memcpy(to, &a, sizeof a);
}

/// Rounded to single precision.
inline void storeLanes(const Lanes& a, float* to)
{
    using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));
    const Floats rounded = __builtin_convertvector(a, Floats);
    std::memcpy(to, &rounded, sizeof rounded);
}

/// Whole numbers.
inline void storeLanes(const Lanes& a, Index* to)
{
    using Whole = Index __attribute__((vector_size(kLanes * sizeof(Index))));
    const Whole whole = __builtin_convertvector(a, Whole);
    std::memcpy(to, &whole, sizeof whole);
}

/// The nearest numbers of single precision.
inline Lanes roundLanes(const Lanes& a)
{
    using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));
    return __builtin_convertvector(__builtin_convertvector(a, Floats), Lanes);
}

inline Lanes allLanes(Real a)
{
    return Lanes{} + a;
}

/// The first n lanes, zero in the others.
inline Lanes firstOrZero(const Lanes& a, Index n)
{
    const Lanes lane{0, 1, 2, 3, 4, 5, 6, 7};
    return lane < static_cast<Real>(n) ? a : Lanes{};
}

/// The first n of eight whole numbers, `other` in place of those behind them; they lie in `room`.
inline const Index* firstOr(const Index* from, Index n, Index other,
                            std::array<Index, kLanes>& room)
{
    using Whole = Index __attribute__((vector_size(kLanes * sizeof(Index))));
    const Whole lane{0, 1, 2, 3, 4, 5, 6, 7};
    Whole a;
    std::memcpy(&a, from, sizeof a);
    a = lane < n ? a : Whole{} + other;
    std::memcpy(room.data(), &a, sizeof a);
    return room.data();
}

/// The sum of the lanes, always in the same order.
inline Real sumOf(const Lanes& a)
{
    return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

/// Eight records of eight numbers become eight numbers of eight records each.
[[gnu::always_inline]] inline void transpose(std::array<Lanes, kLanes>& a)
{
    std::array<Lanes, kLanes> b;
    for (int r = 0; r < kLanes; r += 2) {   // pairs
        b[r] = __builtin_shufflevector(a[r], a[r + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        b[r + 1] = __builtin_shufflevector(a[r], a[r + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int r = 0; r < 2; ++r)             // quarters
        for (int h = 0; h < kLanes; h += 4) {
            a[h + r] = __builtin_shufflevector(b[h + r], b[h + r + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            a[h + r + 2] =
                __builtin_shufflevector(b[h + r], b[h + r + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (int r = 0; r < 4; ++r) {           // halves
        b[r] = __builtin_shufflevector(a[r], a[r + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        b[r + 4] = __builtin_shufflevector(a[r], a[r + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
    a = b;
}

/// Four numbers each of particle l and l + 4 become four numbers of eight particles.
[[gnu::always_inline]] inline void transpose(std::array<Lanes, kLanes / 2>& a)
{
    std::array<Lanes, kLanes / 2> b;
    for (int r = 0; r < 4; r += 2) {   // pairs
        b[r] = __builtin_shufflevector(a[r], a[r + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        b[r + 1] = __builtin_shufflevector(a[r], a[r + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int r = 0; r < 2; ++r) {      // quarters
        a[r] = __builtin_shufflevector(b[r], b[r + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        a[r + 2] = __builtin_shufflevector(b[r], b[r + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
}

}  // namespace isph
