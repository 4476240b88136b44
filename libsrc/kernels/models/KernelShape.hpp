// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernels share: a loop that the compiler turns into vector code.
#pragma once
#include "kernels/Kernel.hpp"

#include <algorithm>
#include <cassert>

namespace isph {

/// A kernel from its Shape, a type with
///     static constexpr Real support, sigma2, sigma3;      sigma_D in 2-D and 3-D
///     static Real w(Real q), slope(Real q);               w and w'/q, both 0 beyond the support
/// Shapes have no branches, only min, max and selections.
template <class Shape>
class ShapedKernel : public Kernel {
public:
    static Schema keys() { return {}; }
    explicit ShapedKernel(const Dictionary&) {}

    Real supportRadius() const override { return Shape::support; }

    Real normalisation(int dimension) const override
    {
        assert(dimension == 2 || dimension == 3);
        return dimension == 2 ? Shape::sigma2 : Shape::sigma3;
    }

    void evaluate(Span<const Real> q, Span<Real> w, Span<Real> slope) const override
    {
        assert(w.size() == q.size() && slope.size() == q.size());
        const Real* qs = q.data();
        Real* ws = w.data();
        Real* slopes = slope.data();
        const std::size_t n = q.size();
#pragma omp simd
        for (std::size_t k = 0; k < n; ++k) {
            ws[k] = Shape::w(qs[k]);
            slopes[k] = Shape::slope(qs[k]);
        }
    }
};

/// max(a, 0)
inline Real positive(Real a)
{
    return a > 0 ? a : 0;
}

}  // namespace isph
