// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a sparse matrix times a vector.
#pragma once
#include "pressure/SymmetricMatrix.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#ifdef __AVX__
#include <immintrin.h>
#endif

// As in core/Lanes.hpp: no function that a library exports takes or returns vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace isph {

namespace detail {
using Quad = Real __attribute__((vector_size(4 * sizeof(Real))));

inline Quad loadQuad(const float* from)
{
#ifdef __AVX__
    return _mm256_cvtps_pd(_mm_loadu_ps(from));  // compilers make two halves of the other
#else
    using Floats = float __attribute__((vector_size(4 * sizeof(float))));
    Floats a;
    std::memcpy(&a, from, sizeof a);
    return __builtin_convertvector(a, Quad);
#endif
}

/// Values at four columns. Two columns are one load: loads are what a product takes its time for.
inline Quad gatherQuad(const Real* value, const Index* column)
{
    if constexpr (std::endian::native != std::endian::little)
        return Quad{value[column[0]], value[column[1]], value[column[2]], value[column[3]]};
    std::uint64_t low, high;
    std::memcpy(&low, column, sizeof low);
    std::memcpy(&high, column + 2, sizeof high);
    constexpr std::uint64_t one = 0xffffffff;
    return Quad{value[low & one], value[low >> 32], value[high & one], value[high >> 32]};
}
}  // namespace detail

/// (A x)_i, summed in double, four entries at a time in two sums that hide the latency of
/// additions. Gather instructions take twice as long as single loads (Zen 4).
[[gnu::always_inline]] inline Real rowTimes(const SymmetricMatrix& matrix, Span<const Real> x,
                                            Index i)
{
    const float* const weight = matrix.offDiagonal.data();
    const Index* const column = matrix.column.data();
    const Real* const value = x.data();
    const PairIndex end = matrix.rowStart[i + 1];
    PairIndex k = matrix.rowStart[i];
    const auto four = [&](PairIndex at) {
        return detail::loadQuad(weight + at) * detail::gatherQuad(value, column + at);
    };
    Real rest = matrix.diagonal[i] * value[i];
    detail::Quad even{}, odd{};
    for (; k + 8 <= end; k += 8) even += four(k), odd += four(k + 4);
    if (k + 4 <= end) even += four(k), k += 4;
    for (; k < end; ++k) rest += static_cast<Real>(weight[k]) * value[column[k]];
    even += odd;
    return rest + ((even[0] + even[2]) + (even[1] + even[3]));
}

}  // namespace isph
