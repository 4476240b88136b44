// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/models/KernelShape.hpp"

#include <numbers>

namespace isph {
namespace {

/// Wendland's kernel with two continuous derivatives.                               [theory (2.4)]
///   w = (1 - q/2)+^4 (1 + 2q)        sigma = 7/(4 pi) in 2-D, 21/(16 pi) in 3-D
///   w'/q = -5 (1 - q/2)+^3
/// Its Fourier transform is positive, so that particles do not pair.
/// source  Wendland (1995), Adv. Comput. Math. 4, 389-396; Dehnen & Aly (2012), MNRAS 425,
///         1068-1082
struct WendlandC2 {
    static constexpr Real support = 2;
    static constexpr Real sigma2 = 7 / (4 * std::numbers::pi);
    static constexpr Real sigma3 = 21 / (16 * std::numbers::pi);

    static Real w(Real q) { return sqr(sqr(positive(1 - 0.5 * q))) * (1 + 2 * q); }
    static Real slope(Real q) { return -5 * cube(positive(1 - 0.5 * q)); }
};

const Kernel::Table::Entry<ShapedKernel<WendlandC2>> entry{"wendlandC2"};

}  // namespace
}  // namespace isph
