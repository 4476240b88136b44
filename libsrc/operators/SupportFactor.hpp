// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/Types.hpp"

#include <algorithm>

namespace isph {

/// Lower bound of (lambda_i + lambda_j)/(2 Dim) in Laplacians: sprays have little of a support.
///                                                                                   [theory (2.8)]
inline constexpr Real kLeastPairSupport = 0.7;

/// 2 Dim/(lambda_i + lambda_j), what a pair counts for in a Laplacian.               [theory (2.8)]
template <int Dim>
Real supportFactor(Real lambda_i, Real lambda_j)
{
    return 1 / std::max(kLeastPairSupport, (lambda_i + lambda_j) / (2 * Dim));
}

}  // namespace isph
