// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/PairList.hpp"

#include <algorithm>

namespace isph {

namespace {
/// What one block of rows found, kept until the lengths of all blocks are known.
struct Block {
    std::vector<Index> j;
    std::vector<Real> W, slope;
};
constexpr Index kBlockRows = 256;
}  // namespace

/// Appends the partners of i, ascending, with q = |x_ij|/h_ij, W and slope.
template <int Dim>
void PairList<Dim>::fillRow(Index i, const Kernel& kernel, std::vector<Index>& j, std::vector<Real>& q,
                            std::vector<Real>& W, std::vector<Real>& slope) const
{
    const Points<Dim>& points = *points_;
    const Vec<Dim> xi = points.x[i];
    const Real hi = points.h[i];
    const std::size_t first = j.size();
    const Real reach = support_ * Real(0.5) * (hi + largestH_);
    grid_.forEachNear(xi, reach, [&](Index k) {
        const Real r2 = normSqr(xi - points.x[k]);
        const Real limit = support_ * Real(0.5) * (hi + points.h[k]);
        if (r2 < limit * limit && k != i) j.push_back(k);
    });
    std::sort(j.begin() + first, j.end());
    const std::size_t n = j.size() - first;
    q.resize(n);
    W.resize(first + n);
    slope.resize(first + n);
    for (std::size_t k = 0; k < n; ++k)
        q[k] = norm(xi - points.x[j[first + k]]) / (Real(0.5) * (hi + points.h[j[first + k]]));
    const Span<Real> rowW(W.data() + first, n), rowSlope(slope.data() + first, n);
    kernel.evaluate(q, rowW, rowSlope);
    for (std::size_t k = 0; k < n; ++k) {
        const Real h = Real(0.5) * (hi + points.h[j[first + k]]);
        const Real scale = sigma_ / power(h);
        rowW[k] *= scale;
        rowSlope[k] *= scale / (h * h);
    }
}

template <int Dim>
void PairList<Dim>::build(const Points<Dim>& points, const Kernel& kernel)
{
    points_ = &points;
    support_ = kernel.supportRadius();
    sigma_ = kernel.normalisation(Dim);
    largestH_ = orderedMax(points.h.size(), 0, [&](Index i) { return points.h[i]; });
    const Real zero = 0;
    Real w0 = 0, s0 = 0;
    kernel.evaluate(Span<const Real>(&zero, 1), Span<Real>(&w0, 1), Span<Real>(&s0, 1));
    selfW0_ = sigma_ * w0;
    grid_.build(points.x, support_ * largestH_);

    const Index rows = points.water;
    start_.assign(rows + 1, 0);
    wallStart_.assign(rows, 0);
    const Index blocks = (rows + kBlockRows - 1) / kBlockRows;
    std::vector<Block> found(blocks);
#pragma omp parallel
    {
        std::vector<Real> q;
#pragma omp for schedule(dynamic, 4)
        for (Index b = 0; b < blocks; ++b) {
            Block& block = found[b];
            for (Index i = b * kBlockRows; i < std::min(rows, (b + 1) * kBlockRows); ++i) {
                const std::size_t before = block.j.size();
                fillRow(i, kernel, block.j, q, block.W, block.slope);
                start_[i + 1] = static_cast<PairIndex>(block.j.size() - before);
                wallStart_[i] = std::lower_bound(block.j.begin() + before, block.j.end(), points.fluid)
                              - block.j.begin() - static_cast<std::ptrdiff_t>(before);
            }
        }
    }
    for (Index i = 0; i < rows; ++i) {
        wallStart_[i] += start_[i];
        start_[i + 1] += start_[i];
    }
    j_.resize(start_[rows]);
    W_.resize(j_.size());
    slope_.resize(j_.size());
    parallelFor(blocks, [&](Index b) {
        const PairIndex at = start_[b * kBlockRows];
        std::copy(found[b].j.begin(), found[b].j.end(), j_.begin() + at);
        std::copy(found[b].W.begin(), found[b].W.end(), W_.begin() + at);
        std::copy(found[b].slope.begin(), found[b].slope.end(), slope_.begin() + at);
    });
}

template class PairList<2>;
template class PairList<3>;

}  // namespace isph
