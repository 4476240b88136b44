// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/Kernel.hpp"

#include <cmath>

namespace isph {

Kernel::Table& Kernel::table()
{
    static Table one;
    return one;
}

std::unique_ptr<Kernel> Kernel::select(const Dictionary& dict, std::string_view key)
{
    return table().select(dict, key);
}

namespace {
/// sum over a full lattice of f(q, w, w'/q), as that of V W
Real overLattice(const Kernel& kernel, int dimension, Real hOverSpacing, auto&& f)
{
    const int m = static_cast<int>(std::ceil(kernel.supportRadius() * hOverSpacing));
    const int mz = dimension == 3 ? m : 0;
    Real sum = 0;
    for (int a = -m; a <= m; ++a)
        for (int b = -m; b <= m; ++b)
            for (int c = -mz; c <= mz; ++c) {
                const Real q = std::sqrt(Real(a * a + b * b + c * c)) / hOverSpacing;
                if (q >= kernel.supportRadius()) continue;
                Real w = 0, slope = 0;
                kernel.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
                sum += f(q, w, slope);
            }
    return sum * kernel.normalisation(dimension) / std::pow(hOverSpacing, dimension);
}
}  // namespace

Real latticeSum(const Kernel& kernel, int dimension, Real hOverSpacing)
{
    return overLattice(kernel, dimension, hOverSpacing, [](Real, Real w, Real) { return w; });
}

Real latticeSupport(const Kernel& kernel, int dimension, Real hOverSpacing)
{
    return overLattice(kernel, dimension, hOverSpacing,
                       [](Real q, Real, Real slope) { return -q * q * slope; });
}

}  // namespace isph
