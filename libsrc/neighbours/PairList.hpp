// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of a step: for every water particle its neighbours with kernel value and slope.
#pragma once
#include "core/Records.hpp"
#include "kernels/Kernel.hpp"
#include "neighbours/CellGrid.hpp"
#include "neighbours/PairBatch.hpp"
#include "particles/Points.hpp"

#include <vector>

namespace isph {

/// Rows of water particles. Within a row the partners ascend, so water (and its images) comes first
/// and walls follow. Only partners with |x_ij| < support of h_ij = (h_i + h_j)/2 are listed, i not
/// with itself. A pair takes 12 bytes: kernel and slope are in single precision, the same from both
/// sides of a pair, so that sums over pairs cancel as they should; x_ij is cheaper to compute than
/// to load.
template <int Dim>
class PairList {
public:
    struct Pair {
        Index j;
        Real W;       ///< W_ij [1/m^D]
        Real slope;   ///< (dW/dr)/r, so that gradW_ij = slope x_ij [1/m^(D+2)]
        Vec<Dim> x_ij;///< x_i - x_j [m]
        /// F_ij = -2 x_ij.gradW_ij/|x_ij|^2, the weight of the Laplacian.            [theory (2.6)]
        Real F() const { return -2 * slope; }
        Vec<Dim> gradW() const { return slope * x_ij; }
    };

    /// Its arrays are used again from build to build.
    void build(const Points<Dim>& points, const Kernel& kernel);

    /// f(pair) over the water partners of i, its wall partners, or both.
    template <class F>
    void forWater(Index i, F&& f) const { loop(i, row_[i].start, row_[i].wallStart, f); }
    template <class F>
    void forWalls(Index i, F&& f) const { loop(i, row_[i].wallStart, row_[i].end, f); }
    template <class F>
    void forAll(Index i, F&& f) const { loop(i, row_[i].start, row_[i].end, f); }

    /// f(batch) over groups of water partners of i: the same pairs in the same order.
    template <class F>
    void forWaterBatches(Index i, F&& f) const
    {
        loopBatches(i, row_[i].start, row_[i].wallStart, f);
    }

    /// f(pairs) for eight water partners of i at a time, in order, or for wall partners.
    template <class F>
    [[gnu::always_inline]] void forWaterLanes(Index i, F&& f) const
    {
        loopLanes(i, row_[i].start, row_[i].wallStart, f);
    }
    template <class F>
    [[gnu::always_inline]] void forWallLanes(Index i, F&& f) const
    {
        loopLanes(i, row_[i].wallStart, row_[i].end, f);
    }

    /// Room for what one pass over the pairs wants to know of every partner; valid until the next
    /// call.
    template <int Size>
    Records<Size> records() const { return store_.template records<Size>(points_->fluid); }
    /// The same of walls, too.
    template <int Size>
    Records<Size> recordsOfAll() const { return store_.template records<Size>(points_->size()); }
    /// Gives their memory back until the next call of records() or build().
    void releaseRecords() const { store_.release(); }
    /// Gives the memory of the pairs back until the next build(); what they reached stays known.
    void release()
    {
        block_ = std::vector<Block>(), row_ = LargeArray<Row>();
        store_.release();
    }
    /// No partner of i is nearer than this [m].
    Real nearest(Index i) const { return row_[i].nearest; }

    PairIndex size() const;
    PairIndex waterNeighbours(Index i) const { return row_[i].wallStart - row_[i].start; }
    PairIndex wallNeighbours(Index i) const { return row_[i].end - row_[i].wallStart; }
    /// An image of water is among the partners of i.
    bool seesImages(Index i) const
    {
        const Row& row = row_[i];
        return row.wallStart > row.start &&
               block_[i / kBlockRows].j[row.wallStart - 1] >= points_->water;
    }
    /// W_ii
    Real selfW(Index i) const { return selfW0_ / power((*points_).h[i]); }
    const CellGrid<Dim>& grid() const { return grid_; }
    /// The largest distance of a pair: the support of the widest point [m].
    Real reach() const { return support_ * largestH_; }
    /// Bins points into the cells of a search within `reach`. Particles in the order of these cells
    /// have their partners in few runs of memory.
    static void binByCells(Span<const Vec<Dim>> x, Real reach, CellGrid<Dim>& grid);

private:
    struct Row {
        Index start, wallStart, end;   ///< places in the row's block
        float nearest;                 ///< [m]
    };
    /// Pairs of kBlockRows rows and kLanes idle places, kernel and slope in units made of the
    /// largest h: of the same digits in water of any size.
    struct Block {
        LargeArray<Index> j;
        LargeArray<float> W, slope;
    };
    class RowSearch;
    static constexpr Index kBlockRows = 256;

    static Real power(Real h)
    {
        Real p = h;
        for (int d = 1; d < Dim; ++d) p *= h;
        return p;
    }
    /// What loops over the pairs of row i read.
    struct RowView {
        const Index* j;
        const float *W, *slope;
        const Vec<Dim>* x;
        Vec<Dim> xi;
    };
    RowView rowOf(Index i) const
    {
        const Block& block = block_[i / kBlockRows];
        return {block.j.data(), block.W.data(), block.slope.data(), points_->x.data(),
                points_->x[i]};
    }
    template <class F>
    void loop(Index i, Index from, Index to, F&& f) const
    {
        const auto [j, W, slope, x, xi] = rowOf(i);
        for (Index k = from; k < to; ++k)
            f(Pair{j[k], W[k] * unitW_, slope[k] * unitSlope_, xi - x[j[k]]});
    }
    /// Inlined, or f's sums would be in memory, not in registers.
    template <class F>
    [[gnu::always_inline]] void loopLanes(Index i, Index from, Index end, F&& f) const
    {
        const Block& block = block_[i / kBlockRows];
        std::array<Index, kLanes> last;
        for (Index k = from; k < end; k += kLanes) {
            const Index* j = &block.j[k];
            Lanes W = loadLanes(&block.W[k]) * unitW_,
                  slope = loadLanes(&block.slope[k]) * unitSlope_;
            if (end - k < kLanes) {   // what follows in the block is of others
                j = firstOr(j, end - k, i, last);
                W = firstOrZero(W, end - k), slope = firstOrZero(slope, end - k);
            }
            f(PairLanes{j, W, slope});   // at one place, so that it is inlined
        }
    }
    template <class F>
    void loopBatches(Index i, Index from, Index to, F&& f) const
    {
        const auto [j, W, slope, x, xi] = rowOf(i);
        PairBatch<Dim> batch;
        for (Index first = from; first < to; first += PairBatch<Dim>::kMost) {
            const Index n = std::min(PairBatch<Dim>::kMost, to - first);
            for (Index k = 0; k < n; ++k) {
                batch.j[k] = j[first + k];
                const Vec<Dim> xj = x[j[first + k]];
                for (int d = 0; d < Dim; ++d) batch.x[d][k] = xi[d] - xj[d];
            }
            for (Index k = 0; k < n; ++k)
                batch.W[k] = W[first + k] * unitW_, batch.slope[k] = slope[first + k] * unitSlope_;
            batch.count = n;
            batch.size = (n + kLanes - 1) / kLanes * kLanes;
            for (Index k = n; k < batch.size; ++k) {
                batch.j[k] = i;
                batch.W[k] = batch.slope[k] = 0;
                for (int d = 0; d < Dim; ++d) batch.x[d][k] = 0;
            }
            f(batch);
        }
    }
    void sortByCells();
    void fillBlock(Index b, RowSearch& search);

    const Points<Dim>* points_ = nullptr;
    CellGrid<Dim> grid_;
    /// During build(): coordinates of all points in the order of the cells
    std::array<Real*, Dim> cellX_{};
    Real* cellH_ = nullptr;            ///< their h
    Real support_ = 0, sigma_ = 0, selfW0_ = 0, largestH_ = 0;
    bool oneH_ = true;   ///< all points have the same h: no soil
    Real unitW_ = 1, unitSlope_ = 1;
    LargeArray<Row> row_;
    std::vector<Block> block_;
    mutable RecordStore store_;
};

extern template class PairList<2>;
extern template class PairList<3>;

}  // namespace isph
