// SPDX-License-Identifier: GPL-3.0-or-later
// The sums over pairs of a packing.
#pragma once
#include "case/SoilField.hpp"

namespace isph {

constexpr Real packingSmoothing = 1.5;  ///< h over the local spacing

/// Acts on particles: one of them, an image of one across a periodic face, or space outside.
struct PackingSource {
    static constexpr Real ofTheOther = 0;  ///< a spacing: that of the particle it acts on
    Point x;
    Real spacing;  ///< [m]
    Real volume;   ///< [m^D]
    Real excess;   ///< n of pack()
};

struct PackingPush {
    Point by;         ///< -h^2 sum_j V_j [e + K (n_i + n_j)] gradW_ij [m]
    Real excess = 0;  ///< sum_j V_j W_ij, with itself
};

/// Of the source i, from those at the places `near`, which need not all be within its support.
PackingPush pushOn(std::size_t i, const std::vector<PackingSource>& sources,
                   const std::vector<Index>& near, const PackingKernel& kernel);

}  // namespace isph
