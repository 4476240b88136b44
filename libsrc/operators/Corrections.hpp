// SPDX-License-Identifier: GPL-3.0-or-later
// What every operator of a step needs to know about a particle's support.     [theory (2.7)-(2.10)]
#pragma once
#include "core/SymMat.hpp"
#include "neighbours/PairList.hpp"

#include <vector>

namespace isph {

/// Moments of the support and the corrected gradients made from them. One entry per water particle;
/// lambda also of images.
template <int Dim>
struct Corrections {
    /// lambda_i = -sum_j V_j x_ij.gradW_ij over water and walls: Dim in the bulk, less at a
    /// surface.
    std::vector<Real> lambda;
    std::vector<Real> lambdaWater;        ///< the same over water partners alone
    /// sum_j V_j W_ij, i itself included, over water and walls: 1 where space is filled.
    std::vector<Real> filling;
    /// Corrections L of grad f = sum_j V_j (f_j - f_i) L gradW_ij, exact for linear f: with water
    /// and walls (for the divergence), with water only (for the pressure gradient).
    ///                                                                       [Bonet & Lok 1999]
    std::vector<SymMat<Dim>> L;
    SymMat<Dim> Lwater(Index i) const { return place_[i] < 0 ? L[i] : special_[place_[i]].Lwater; }
    /// L A with the A that L inverts: the identity where L is the full inverse; what is missing
    /// from it is the share of a linear field that the blended gradient does not see.
    SymMat<Dim> seen(Index i) const
    {
        return place_[i] < 0 ? SymMat<Dim>(Mat<Dim>::identity()) : special_[place_[i]].seen;
    }
    /// sum_j V_j F_ij x_ij over water and walls [1/m]: zero where the support is complete.
    std::vector<Vec<Dim>> lopsided;

    void compute(const Points<Dim>& points, const PairList<Dim>& pairs);

private:
    /// Of particles with walls in their support or with too few neighbours for a full inverse: of
    /// all others Lwater is L and all is seen, and most are others.
    struct Special {
        SymMat<Dim> Lwater, seen;
    };
    bool computeRow(const Points<Dim>& points, const PairList<Dim>& pairs,
                    const Records<4>& partners, Index i, Special& special);

    std::vector<Index> place_;        ///< of every particle in special_, -1: none
    std::vector<Special> special_;
};

/// The inverse of A, blended into the identity where its smallest eigenvalue is below 0.25 and
/// equal to it below 0.1: sprays have too few neighbours for a gradient.             [theory (2.9)]
template <int Dim>
Mat<Dim> blendedInverse(const Mat<Dim>& A);

extern template struct Corrections<2>;
extern template struct Corrections<3>;

}  // namespace isph
