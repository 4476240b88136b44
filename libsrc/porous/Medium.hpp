// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of the projection ask of the medium that water moves in. Two answers are compiled:
// clear water, where every coefficient is a constant and no array exists, and water with soil.
#pragma once
#include "porous/PorousField.hpp"

namespace isph {

/// k = 1, no drag.
template <int Dim>
struct ClearWater {
    static constexpr bool hasSoil = false;
    Real dt = 0;   ///< the step as the time integration weighs it, dt' of (3.2)

    Real porosity(Index) const { return 1; }
    Real share(Index) const { return 0; }
    Real mobility(Index) const { return 1; }
    Real damping(Index) const { return 1; }
    Real damping(Index, Index) const { return 1; }
    Real beta(Index) const { return dt; }
    Real beta(Index, Index) const { return dt; }
};

/// Coefficients of (3.4)-(3.6) from the porous state; all arrays cover water and images.
template <int Dim>
struct WaterInSoil {
    static constexpr bool hasSoil = true;
    Real dt = 0;
    const PorousState<Dim>& state;
    Span<const Real> resistance;   ///< r_i = a_i + b_i |v_i|  [1/s]

    Real porosity(Index i) const { return state.porosity[i]; }
    Real share(Index i) const { return state.share[i]; }
    Real mobility(Index i) const { return state.mobility[i]; }
    /// s_i = 1/(1 + k_i dt' r_i), the share of its momentum that drag leaves a particle.
    Real damping(Index i) const { return 1 / (1 + state.mobility[i] * dt * resistance[i]); }
    /// s_ij with k_ij the harmonic and r_ij the arithmetic mean along the line from i to j.
    Real damping(Index i, Index j) const { return 1 / (1 + pairMobility(i, j) * dt * pairResistance(i, j)); }
    /// beta = k dt' s, what a pressure gradient does to v_D.
    Real beta(Index i) const { return state.mobility[i] * dt * damping(i); }
    Real beta(Index i, Index j) const { return pairMobility(i, j) * dt * damping(i, j); }
    /// Unit normal of the soil surface between i and j, zero where there is none.
    Vec<Dim> normal(Index i, Index j) const { return unit(state.normal[i] + state.normal[j]); }

private:
    /// Share of the line from i to j that has the soil (or water) of i: a soil surface between them cuts
    /// it in proportion to their depths; elsewhere one half.                         [theory (4.15)]
    Real weight(Index i, Index j) const
    {
        const Real a = state.depth[i], b = state.depth[j];
        return a * b < 0 ? a / (a - b) : Real(0.5);
    }
    Real pairMobility(Index i, Index j) const
    {
        const Real t = weight(i, j);
        return 1 / (t / state.mobility[i] + (1 - t) / state.mobility[j]);
    }
    Real pairResistance(Index i, Index j) const
    {
        const Real t = weight(i, j);
        return t * resistance[i] + (1 - t) * resistance[j];
    }
};

}  // namespace isph
