// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of a step: for every water particle its neighbours with kernel value and slope.
#pragma once
#include "kernels/Kernel.hpp"
#include "neighbours/CellGrid.hpp"
#include "particles/Points.hpp"

#include <vector>

namespace isph {

/// Rows of water particles. Within a row the partners ascend, so water (and its images) comes first and
/// walls follow. Only partners with |x_ij| < support of h_ij = (h_i + h_j)/2 are listed, i not with itself.
template <int Dim>
class PairList {
public:
    struct Pair {
        Index j;
        Real W;       ///< W_ij [1/m^D]
        Real slope;   ///< (dW/dr)/r, so that gradW_ij = slope x_ij [1/m^(D+2)]
        Vec<Dim> x_ij;///< x_i - x_j [m]
        /// F_ij = -2 x_ij.gradW_ij/|x_ij|^2, the weight of the Laplacian.              [theory (2.6)]
        Real F() const { return -2 * slope; }
        Vec<Dim> gradW() const { return slope * x_ij; }
    };

    void build(const Points<Dim>& points, const Kernel& kernel);

    /// f(pair) over the water partners of i, its wall partners, or both.
    template <class F>
    void forWater(Index i, F&& f) const { loop(i, start_[i], wallStart_[i], f); }
    template <class F>
    void forWalls(Index i, F&& f) const { loop(i, wallStart_[i], start_[i + 1], f); }
    template <class F>
    void forAll(Index i, F&& f) const { loop(i, start_[i], start_[i + 1], f); }

    PairIndex size() const { return start_.empty() ? 0 : start_.back(); }
    PairIndex waterNeighbours(Index i) const { return wallStart_[i] - start_[i]; }
    /// W_ii
    Real selfW(Index i) const { return selfW0_ / power((*points_).h[i]); }
    const CellGrid<Dim>& grid() const { return grid_; }

private:
    static Real power(Real h)
    {
        Real p = h;
        for (int d = 1; d < Dim; ++d) p *= h;
        return p;
    }
    template <class F>
    void loop(Index i, PairIndex from, PairIndex to, F&& f) const
    {
        const auto* x = points_->x.data();
        const Vec<Dim> xi = x[i];
        for (PairIndex k = from; k < to; ++k)
            f(Pair{j_[k], W_[k], slope_[k], xi - x[j_[k]]});
    }
    void fillRow(Index i, const Kernel& kernel, std::vector<Index>& j, std::vector<Real>& q,
                 std::vector<Real>& W, std::vector<Real>& slope) const;

    const Points<Dim>* points_ = nullptr;
    CellGrid<Dim> grid_;
    Real support_ = 0, sigma_ = 0, selfW0_ = 0, largestH_ = 0;
    std::vector<PairIndex> start_, wallStart_;
    std::vector<Index> j_;
    std::vector<Real> W_, slope_;
};

extern template class PairList<2>;
extern template class PairList<3>;

}  // namespace isph
