// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/models/KernelShape.hpp"

#include <numbers>

namespace isph {
namespace {

/// Wendland's kernel with four continuous derivatives.                              [theory (2.5)]
///   w = (1 - q/2)+^6 (1 + 3q + 35/12 q^2)     sigma = 9/(4 pi) in 2-D, 495/(256 pi) in 3-D
///   w'/q = -14/3 (1 + 5/2 q) (1 - q/2)+^5
/// Narrower than wendlandC2 at the same h: use a smoothingRatio about 1.2 times as large.
/// source  Wendland (1995), Adv. Comput. Math. 4, 389-396; Dehnen & Aly (2012), MNRAS 425,
///         1068-1082
struct WendlandC4 {
    static constexpr Real support = 2;
    static constexpr Real sigma2 = 9 / (4 * std::numbers::pi);
    static constexpr Real sigma3 = 495 / (256 * std::numbers::pi);

    static Real w(Real q)
    {
        return sqr(cube(positive(1 - 0.5 * q))) * (1 + 3 * q + 35.0 / 12 * sqr(q));
    }
    static Real slope(Real q)
    {
        const Real s = positive(1 - 0.5 * q);
        return -14.0 / 3 * (1 + 2.5 * q) * s * sqr(sqr(s));
    }
};

const Kernel::Table::Entry<ShapedKernel<WendlandC4>> entry{"wendlandC4"};

}  // namespace
}  // namespace isph
