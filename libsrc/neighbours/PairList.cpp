// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/PairList.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#ifdef __AVX512VL__
#include <immintrin.h>
#endif

namespace isph {

namespace {
/// Cells as wide as the support hold the points near a particle in 3^(D-1) runs; short ones end
/// them close to the support, so that a third (2-D: half) of the points looked at are partners.
constexpr int kSlices = 4;
/// Steps of the cell edge in an octave. A widest h that changes a little leaves the cells, and with
/// them the order of sorted particles, as they are.
constexpr Real kEdgeSteps = 4;
/// More room than a block of rows takes, so that it rarely moves.
constexpr Real kRoom = 1.02;
/// Rows with more places out of order than one in this many are sorted as a whole, not place by
/// place.
constexpr Index kNearlySorted = 8;
constexpr Real kRounding = 1e-6;   // keeps a distance in single precision below the true one

/// Writes k + l for the lanes l of `a` below zero, as far as that is less than `last`, and the same
/// lanes of `value`; returns how many. It may touch kLanes places of both.
Index takeBelowZero(const Lanes& a, Index k, Index last, const Lanes& value, Index* to,
                    Real* valueTo)
{
#ifdef __AVX512VL__   // compilers do not make this of the loop below
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i place = _mm256_add_epi32(_mm256_set1_epi32(k), lane);
    const __mmask8 inside = _mm256_cmplt_epi32_mask(place, _mm256_set1_epi32(last));
    const __mmask8 found = _mm512_mask_cmp_pd_mask(inside, a, Lanes{}, _CMP_LT_OQ);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_maskz_compress_epi32(found, place));
    _mm512_storeu_pd(valueTo, _mm512_maskz_compress_pd(found, value));
    return std::popcount(static_cast<unsigned>(found));
#else
    Index n = 0;
    for (Index l = 0; l < kLanes; ++l) {
        to[n] = k + l, valueTo[n] = value[l];
        n += (a[l] < 0) & (k + l < last);
    }
    return n;
#endif
}
}  // namespace

/// Finds the partners of one particle after the other; its arrays hold the row at hand.
template <int Dim>
class PairList<Dim>::RowSearch {
public:
    RowSearch(const PairList& list, const Kernel& kernel) : list_(list), kernel_(kernel) {}

    /// The partners of i.
    void find(Index i);
    Index size() const { return size_; }
    Index water() const { return water_; }
    const Index* j() const { return j_.data(); }

    /// Their kernel values and slopes; returns a distance [m] that none is within.
    float evaluate(Index i, float* W, float* slope);

private:
    template <bool OneH>
    void near(Index i);
    void inOrder(Index i);
    void ascend(Index first, Index last);
    void sort(Index first, Index last);
    template <bool OneH>
    float evaluateRow(Real hi, float* W, float* slope);
    void reserve(std::size_t n)
    {
        if (hit_.size() >= n) return;
        n += n / 2;
        hit_.resize(n), found2_.resize(n), j_.resize(n), place_.resize(n);
        r2_.resize(n), q_.resize(n), h_.resize(n), w_.resize(n), s_.resize(n);
    }

    const PairList& list_;
    const Kernel& kernel_;
    Index size_ = 0, water_ = 0;
    std::vector<Index> hit_;           ///< places in the order of cells, as found,
    std::vector<Real> found2_;         ///< and |x_ij|^2
    std::vector<Index> place_, j_;     ///< as listed; numbers
    std::vector<Real> r2_;
    std::vector<std::uint64_t> key_;
    std::vector<Real> q_, h_, w_, s_;
};

template <int Dim>
void PairList<Dim>::RowSearch::find(Index i)
{
    list_.oneH_ ? near<true>(i) : near<false>(i);
    inOrder(i);
}

/// hit_ and found2_: all points within the support, i itself among them. OneH: all have the same h.
template <int Dim>
template <bool OneH>
void PairList<Dim>::RowSearch::near(Index i)
{
    const Vec<Dim> xi = list_.points_->x[i];
    const Real half = Real(0.5) * list_.support_, hi = list_.points_->h[i];
    const std::array<Real*, Dim> cellX = list_.cellX_;
    const Real* cellH = list_.cellH_;
    size_ = 0;
    list_.grid_.forEachRun(xi, half * (hi + list_.largestH_), [&](Index first, Index last) {
        reserve(size_ + last - first + kLanes);
        // Copies that writing the places found cannot change: they stay in registers.
        const std::array<Real*, Dim> x = cellX;
        const Vec<Dim> own = xi;
        Lanes reach = allLanes(half * (hi + hi));
        Index* hit = hit_.data();
        Real* found2 = found2_.data();
        Index n = size_;
        for (Index k = first; k < last; k += kLanes) {
            Lanes r2{};
            for (int d = 0; d < Dim; ++d) {
                const Lanes x_ij = own[d] - loadLanes(x[d] + k);
                r2 += x_ij * x_ij;
            }
            if constexpr (!OneH) reach = half * (hi + loadLanes(cellH + k));
            n += takeBelowZero(r2 - reach * reach, k, last, r2, hit + n, found2 + n);
        }
        size_ = n;
    });
}

/// place_, j_ and r2_: the partners without i itself, water first, each part ascending.
template <int Dim>
void PairList<Dim>::RowSearch::inOrder(Index i)
{
    const Index* order = list_.grid_.order().data();
    const Index fluid = list_.points_->fluid, found = size_;
    const auto take = [&](auto&& wanted, Index n) {
        for (Index k = 0; k < found; ++k) {
            const Index j = order[hit_[k]];
            place_[n] = hit_[k], j_[n] = j, r2_[n] = found2_[k];
            n += wanted(j);
        }
        return n;
    };
    water_ = take([&](Index j) { return (j < fluid) & (j != i); }, 0);
    size_ = water_ + 1 < found ? take([&](Index j) { return j >= fluid; }, water_) : water_;
    ascend(0, water_);
    ascend(water_, size_);
}

/// Sorted particles are found in their order but for the few that have changed cells since.
template <int Dim>
void PairList<Dim>::RowSearch::ascend(Index first, Index last)
{
    Index descents = 0;
    for (Index k = first + 1; k < last; ++k) descents += j_[k] < j_[k - 1];
    if (kNearlySorted * descents > last - first) return sort(first, last);
    for (Index k = first + 1; descents > 0 && k < last; ++k) {
        const Index j = j_[k], place = place_[k];
        const Real r2 = r2_[k];
        Index m = k;
        for (; m > first && j_[m - 1] > j; --m)
            j_[m] = j_[m - 1], place_[m] = place_[m - 1], r2_[m] = r2_[m - 1];
        j_[m] = j, place_[m] = place, r2_[m] = r2;
    }
}

template <int Dim>
void PairList<Dim>::RowSearch::sort(Index first, Index last)
{
    key_.resize(last - first);
    for (Index k = first; k < last; ++k) {
        key_[k - first] = static_cast<std::uint64_t>(j_[k]) << 32 | static_cast<std::uint32_t>(k);
        hit_[k] = place_[k], found2_[k] = r2_[k];
    }
    std::sort(key_.begin(), key_.end());
    for (Index k = first; k < last; ++k) {
        const auto from = static_cast<Index>(key_[k - first] & 0xFFFFFFFFU);
        j_[k] = static_cast<Index>(key_[k - first] >> 32);
        place_[k] = hit_[from], r2_[k] = found2_[from];
    }
}

template <int Dim>
float PairList<Dim>::RowSearch::evaluate(Index i, float* W, float* slope)
{
    const Real hi = list_.points_->h[i];
    return list_.oneH_ ? evaluateRow<true>(hi, W, slope) : evaluateRow<false>(hi, W, slope);
}

template <int Dim>
template <bool OneH>
float PairList<Dim>::RowSearch::evaluateRow(Real hi, float* W, float* slope)
{
    const Real sigma = list_.sigma_, largestH = list_.largestH_;
    const auto inverse = [](Real h, Real other) { return 1 / (Real(0.5) * (h + other)); };
    const Real inverseH = inverse(hi, hi);
    const Real *r2 = r2_.data(), *w = w_.data(), *s = s_.data();
    Real *q = q_.data(), *h = h_.data();   // h: 1/h_ij
    if constexpr (!OneH)
        for (Index k = 0; k < size_; ++k) h[k] = list_.cellH_[place_[k]];
    Real nearest2 = sqr(list_.support_ * largestH);
#pragma omp simd reduction(min : nearest2)
    for (Index k = 0; k < size_; ++k) {
        nearest2 = std::min(nearest2, r2[k]);
        if constexpr (!OneH) h[k] = inverse(hi, h[k]);
        q[k] = std::sqrt(r2[k]) * (OneH ? inverseH : h[k]);
    }
    const std::size_t n = size_;
    kernel_.evaluate({q, n}, {w_.data(), n}, {s_.data(), n});
#pragma omp simd
    for (Index k = 0; k < size_; ++k) {
        const Real ratio = largestH * (OneH ? inverseH : h[k]), scale = sigma * power(ratio);
        W[k] = static_cast<float>(w[k] * scale);
        slope[k] = static_cast<float>(s[k] * scale * (ratio * ratio));
    }
    return static_cast<float>(std::sqrt(nearest2) * (1 - kRounding));
}

template <int Dim>
void PairList<Dim>::binByCells(Span<const Vec<Dim>> x, Real reach, CellGrid<Dim>& grid)
{
    grid.build(x, std::exp2(std::round(kEdgeSteps * std::log2(reach)) / kEdgeSteps), kSlices);
}

/// cellX_ and cellH_, with places behind their end that a last group of kLanes may read.
template <int Dim>
void PairList<Dim>::sortByCells()
{
    const std::size_t n = points_->x.size(), room = n + kLanes;
    cellH_ = store_.numbers((Dim + 1) * room);
    std::fill(cellH_ + n, cellH_ + room, 0);
    for (int d = 0; d < Dim; ++d) {
        cellX_[d] = cellH_ + (d + 1) * room;
        std::fill(cellX_[d] + n, cellX_[d] + room, 0);
    }
    parallelFor(n, [&](Index k) {
        const Index j = grid_.order()[k];
        for (int d = 0; d < Dim; ++d) cellX_[d][k] = points_->x[j][d];
        cellH_[k] = points_->h[j];
    });
}

template <int Dim>
void PairList<Dim>::fillBlock(Index b, RowSearch& search)
{
    Block& block = block_[b];
    block.j.clear(), block.W.clear(), block.slope.clear();
    const Index first = b * kBlockRows, last = std::min(points_->water, first + kBlockRows);
    for (Index i = first; i < last; ++i) {
        search.find(i);
        const std::size_t begin = block.j.size(), end = begin + search.size();
        if (end > block.j.capacity()) {
            const Real rows = static_cast<Real>(last - first) / static_cast<Real>(i + 1 - first);
            const auto room = static_cast<std::size_t>(kRoom * rows * static_cast<Real>(end)) +
                              search.size() + kLanes;
            block.j.reserve(room), block.W.reserve(room), block.slope.reserve(room);
        }
        block.j.resize(end), block.W.resize(end), block.slope.resize(end);
        std::copy_n(search.j(), search.size(), block.j.begin() + begin);
        row_[i].nearest = search.evaluate(i, block.W.data() + begin, block.slope.data() + begin);
        row_[i].start = static_cast<Index>(begin);
        row_[i].wallStart = static_cast<Index>(begin) + search.water();
        row_[i].end = static_cast<Index>(end);
    }
    const std::size_t all = block.j.size() + kLanes;   // loops read eight places at a time
    block.j.resize(all), block.W.resize(all), block.slope.resize(all);
}

template <int Dim>
void PairList<Dim>::build(const Points<Dim>& points, const Kernel& kernel)
{
    points_ = &points;
    support_ = kernel.supportRadius();
    sigma_ = kernel.normalisation(Dim);
    largestH_ = orderedMax(points.h.size(), 0, [&](Index i) { return points.h[i]; });
    oneH_ = orderedMax(points.h.size(), 0, [&](Index i) { return largestH_ - points.h[i]; }) == 0;
    const Real zero = 0;
    Real w0 = 0, s0 = 0;
    kernel.evaluate(Span<const Real>(&zero, 1), Span<Real>(&w0, 1), Span<Real>(&s0, 1));
    selfW0_ = sigma_ * w0;
    unitW_ = 1 / power(largestH_);
    unitSlope_ = unitW_ / sqr(largestH_);
    binByCells(points.x, reach(), grid_);
    sortByCells();
    const Index blocks = (points.water + kBlockRows - 1) / kBlockRows;
    row_.resize(points.water);
    block_.resize(blocks);
#pragma omp parallel
    {
        RowSearch search(*this, kernel);
#pragma omp for schedule(dynamic, 1)
        for (Index b = 0; b < blocks; ++b) fillBlock(b, search);
    }
}

template <int Dim>
PairIndex PairList<Dim>::size() const
{
    PairIndex pairs = 0;
    for (const Row& row : row_) pairs += row.end - row.start;
    return pairs;
}

template class PairList<2>;
template class PairList<3>;

}  // namespace isph
