// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/models/KernelShape.hpp"

#include <numbers>

namespace isph {
namespace {

/// Cubic B-spline.                                                                  [theory (2.2)]
///   w = (2-q)+^3/4 - (1-q)+^3        sigma = 10/(7 pi) in 2-D, 1/pi in 3-D
/// Its second derivative is only piecewise linear; particles may pair under pressure.
/// source  Monaghan & Lattanzio (1985), Astron. Astrophys. 149, 135-143
struct CubicSpline {
    static constexpr Real support = 2;
    static constexpr Real sigma2 = 10 / (7 * std::numbers::pi);
    static constexpr Real sigma3 = 1 / std::numbers::pi;

    static Real w(Real q) { return 0.25 * cube(positive(2 - q)) - cube(positive(1 - q)); }

    /// The inner part is multiplied out, so that it has its limit -3 at q = 0.
    static Real slope(Real q)
    {
        const Real inner = -3 + 2.25 * q;
        const Real outer = -0.75 * sqr(positive(2 - q)) / std::max(q, 1.0);
        return q < 1 ? inner : outer;
    }
};

const Kernel::Table::Entry<ShapedKernel<CubicSpline>> entry{"cubicSpline"};

}  // namespace
}  // namespace isph
