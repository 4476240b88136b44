// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars, array views and field types shared by every folder.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace isph {

using Real = double;
using Index = std::int32_t;       // particle numbers
using PairIndex = std::int64_t;   // positions in pair lists, which outgrow 32 bits first

template <class T>
using Span = std::span<T>;

constexpr Real sqr(Real a) { return a * a; }
constexpr Real cube(Real a) { return a * a * a; }

}  // namespace isph
