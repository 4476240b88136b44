// SPDX-License-Identifier: GPL-3.0-or-later
// The weight of a soil or wall particle at a place is a product of these B-splines, one along each
// axis.
#pragma once
#include "core/Types.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

/// Quintic B-spline M of unit spacing (Schoenberg). Over a lattice along the axes sum_k M(x - x_k)
/// = 1 wherever x stands, which no radial kernel does: one of the same width is off by 0.8 %
/// between the points. Beneath the flat face of a half-space of soil sums are a function of the
/// depth alone.                                                                     [theory (4.10)]
namespace latticeSpline {

inline constexpr Real kReach = 3;     ///< M(x) = 0 for |x| >= kReach, in units of d0
/// In units of d0: deeper beneath a face only 3e-4 of the sums is missing.
inline constexpr Real kDeep = 2;

/// M(x) = [(3-|x|)^5 - 6 (2-|x|)^5 + 15 (1-|x|)^5]/120 where the brackets are positive, x in units
/// of d0.
inline Real value(Real x)
{
    const auto fifth = [a = std::abs(x)](Real knot) {
        const Real t = knot > a ? knot - a : 0;
        return sqr(sqr(t)) * t;
    };
    return (fifth(3) - 6 * fifth(2) + 15 * fifth(1)) * (Real(1) / 120);
}

/// M'(x).
inline Real slope(Real x)
{
    const auto fourth = [a = std::abs(x)](Real knot) {
        const Real t = knot > a ? knot - a : 0;
        return sqr(sqr(t));
    };
    return (x < 0 ? 1 : -1) * (fourth(3) - 6 * fourth(2) + 15 * fourth(1)) * (Real(1) / 24);
}

/// Depth xi [d0] beneath the flat face of a half-space that has the share phi(xi) = sum_k M(xi - k
/// - 1/2), k >= 0, of the sums: 0 for a half and less, no more than kDeep.          [theory (4.15)]
inline Real depthOf(Real share)
{
    if (share >= 1 - value(kDeep + Real(0.5)))
        return kDeep;  // most particles: 1 - phi is the one term beyond
    Real xi = 0;
    for (int n = 0; n < 12;
         ++n) {  // Newton's: phi is concave for xi > 0, so that none goes too far
        Real phi = 0, rise = 0;
        for (Real x = xi - Real(0.5); x > -kReach; --x) phi += value(x), rise += slope(x);
        const Real further = std::max(Real(0), share - phi) / rise;
        xi += further;
        if (further < 1e-12) return xi;
    }
    return xi;
}

}  // namespace latticeSpline
}  // namespace isph
