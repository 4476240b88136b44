// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/SymmetricMatrix.hpp"

#include "core/Parallel.hpp"
#include "pressure/RowTimes.hpp"

#include <cmath>

namespace isph {

void multiply(const SymmetricMatrix& matrix, Span<const Real> x, Span<Real> y)
{
    parallelFor(matrix.size(), [&](Index i) { y[i] = rowTimes(matrix, x, i); });
}

Real multiplyAndDot(const SymmetricMatrix& matrix, Span<const Real> x, Span<Real> y)
{
    return orderedSum(matrix.size(), [&](Index i) {
        y[i] = rowTimes(matrix, x, i);
        return x[i] * y[i];
    });
}

Real residual(const SymmetricMatrix& matrix, Span<const Real> x, Span<const Real> b, Span<Real> r)
{
    return std::sqrt(orderedSum(matrix.size(), [&](Index i) {
        r[i] = b[i] - rowTimes(matrix, x, i);
        return sqr(r[i]);
    }));
}

Real residualNorm(const SymmetricMatrix& matrix, Span<const Real> x, Span<const Real> b)
{
    return std::sqrt(
        orderedSum(matrix.size(), [&](Index i) { return sqr(b[i] - rowTimes(matrix, x, i)); }));
}

}  // namespace isph
