// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of one row as arrays, so that loops over them are vector code.
#pragma once
#include "core/Lanes.hpp"
#include "core/Vec.hpp"

#include <array>

namespace isph {

constexpr Index kBatchPairs = 64;

/// Up to kMost pairs of particle i. Places from the last pair up to the next multiple of kLanes
/// hold i itself with W = slope = 0, so that loops run over whole vectors and sums get nothing from
/// them.
template <int Dim>
struct PairBatch {
    static constexpr Index kMost = kBatchPairs;

    Index count;                                          ///< of pairs
    Index size;                                           ///< the next multiple of kLanes
    std::array<Index, kMost> j;
    alignas(64) std::array<Real, kMost> W, slope;         ///< as in PairList::Pair
    alignas(64) std::array<std::array<Real, kMost>, Dim> x;   ///< components of x_ij
};

/// Eight pairs of one row. Idle places of the last eight hold i itself with W = slope = 0.
struct PairLanes {
    const Index* j;
    Lanes W, slope;
};

/// A number of every pair of a batch.
struct alignas(64) BatchValues {
    std::array<Real, kBatchPairs> value;

    /// Takes field(j) of every pair.
    template <int Dim, class Field>
    void gather(const PairBatch<Dim>& batch, Field&& field)
    {
        for (Index k = 0; k < batch.size; ++k) value[k] = field(batch.j[k]);
    }
    Lanes lanes(Index first) const { return loadLanes(value.data() + first); }
};

}  // namespace isph
