// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/models/KernelShape.hpp"

#include <numbers>

namespace isph {
namespace {

inline Real fourthPower(Real a)
{
    return sqr(sqr(a));
}

/// Quintic B-spline.                                                                [theory (2.3)]
///   w = (3-q)+^5 - 6 (2-q)+^5 + 15 (1-q)+^5    sigma = 7/(478 pi) in 2-D, 1/(120 pi) in 3-D
/// Smooth, but its support of 3 h holds (3/2)^D times the neighbours of the others.
/// source  Morris, Fox & Zhu (1997), J. Comput. Phys. 136, 214-226
struct QuinticSpline {
    static constexpr Real support = 3;
    static constexpr Real sigma2 = 7 / (478 * std::numbers::pi);
    static constexpr Real sigma3 = 1 / (120 * std::numbers::pi);

    static Real w(Real q)
    {
        const Real a = positive(3 - q), b = positive(2 - q), c = positive(1 - q);
        return a * fourthPower(a) - 6 * b * fourthPower(b) + 15 * c * fourthPower(c);
    }

    /// The inner part is multiplied out, so that it has its limit -120 at q = 0.
    static Real slope(Real q)
    {
        const Real a = positive(3 - q), b = positive(2 - q);
        const Real inner = -120 + sqr(q) * (120 - 50 * q);
        const Real outer = (30 * fourthPower(b) - 5 * fourthPower(a)) / std::max(q, 1.0);
        return q < 1 ? inner : outer;
    }
};

const Kernel::Table::Entry<ShapedKernel<QuinticSpline>> entry{"quinticSpline"};

}  // namespace
}  // namespace isph
