// SPDX-License-Identifier: GPL-3.0-or-later
// Gradient of a vector field from water partners, without its correction.
#pragma once
#include "neighbours/PairList.hpp"

namespace isph {

/// The sum of the lanes of every component.
template <std::size_t Dim>
Vec<static_cast<int>(Dim)> sumOf(const std::array<Lanes, Dim>& a)
{
    Vec<static_cast<int>(Dim)> sum;
    for (std::size_t d = 0; d < Dim; ++d) sum[static_cast<int>(d)] = sumOf(a[d]);
    return sum;
}

/// Lane l of every component.
template <std::size_t Dim>
Vec<static_cast<int>(Dim)> lane(const std::array<Lanes, Dim>& a, int l)
{
    Vec<static_cast<int>(Dim)> v;
    for (std::size_t d = 0; d < Dim; ++d) v[static_cast<int>(d)] = a[d][l];
    return v;
}

/// Sum over the pairs of a row of a (x) b, those of every lane apart.
template <int Dim>
struct OuterSum {
    std::array<std::array<Lanes, Dim>, Dim> sum{};

    void add(const std::array<Lanes, Dim>& a, const std::array<Lanes, Dim>& b)
    {
        for (int r = 0; r < Dim; ++r)
            for (int c = 0; c < Dim; ++c) sum[r][c] += a[r] * b[c];
    }
    Mat<Dim> total() const
    {
        Mat<Dim> m;
        for (int r = 0; r < Dim; ++r)
            for (int c = 0; c < Dim; ++c) m[r][c] = sumOf(sum[r][c]);
        return m;
    }
};

/// sum_j V_j (u_j - u_i) (x) gradW_ij over water partners; row d is that of component d. Multiplied
/// by Lwater_i it is the gradient, exact for linear u.                              [theory (2.10)]
template <int Dim>
Mat<Dim> pairGradient(const Points<Dim>& points, const PairList<Dim>& pairs, Span<const Vec<Dim>> u,
                      Index i)
{
    OuterSum<Dim> sum;
    const Vec<Dim> u_i = u[i];
    pairs.forWaterBatches(i, [&](const PairBatch<Dim>& batch) {
        BatchValues volume;
        std::array<BatchValues, Dim> difference;
        for (Index k = 0; k < batch.size; ++k) {
            const Vec<Dim> change = u[batch.j[k]] - u_i;
            for (int d = 0; d < Dim; ++d) difference[d].value[k] = change[d];
            volume.value[k] = points.volume[batch.j[k]];
        }
        for (Index k = 0; k < batch.size; k += kLanes) {
            const Lanes weight = volume.lanes(k) * loadLanes(&batch.slope[k]);
            std::array<Lanes, Dim> change, x;
            for (int d = 0; d < Dim; ++d) {
                change[d] = weight * difference[d].lanes(k);
                x[d] = loadLanes(&batch.x[d][k]);
            }
            sum.add(change, x);
        }
    });
    return sum.total();
}

}  // namespace isph
