// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature over implicit shapes; included by case/Shape.hpp.
#pragma once
#include <algorithm>
#include <cmath>

namespace isph {

/// Calls f(x, cell volume) at the midpoints of cells of about `step` that tile the bounds.
template <class F>
void forEachCell(const BoundingBox& bounds, int dimension, Real step, F&& f)
{
    if (bounds.empty()) return;
    int n[3] = {1, 1, 1};
    Real size[3] = {0, 0, 0}, volume = 1;
    for (int d = 0; d < dimension; ++d) {
        n[d] = std::max(1, static_cast<int>(std::ceil(bounds.size()[d] / step - 1e-9)));
        size[d] = bounds.size()[d] / n[d];
        volume *= size[d];
    }
    Point x;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i) {
                const int at[3] = {i, j, k};
                for (int d = 0; d < dimension; ++d) x[d] = bounds.min[d] + (at[d] + 0.5) * size[d];
                f(x, volume);
            }
}

template <class Distance>
Real measure(const BoundingBox& bounds, int dimension, Real step, Distance&& f)
{
    Real sum = 0;
    forEachCell(bounds, dimension, step, [&](const Point& x, Real volume) {
        sum += volume * std::clamp(0.5 - f(x) / step, 0.0, 1.0);
    });
    return sum;
}

}  // namespace isph
