// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of the projection ask of the medium that water moves in. Two answers are compiled:
// clear water, where every coefficient is a constant and no array exists, and water with soil.
#pragma once
#include "core/LatticeSpline.hpp"
#include "porous/PorousField.hpp"

#include <utility>

namespace isph {

/// k = 1, no drag.
template <int Dim>
struct ClearWater {
    static constexpr bool hasSoil = false;
    Real dt = 0;   ///< the step as the time integration weighs it, dt' of (3.2)

    Real porosity(Index) const { return 1; }
    Real sharpPorosity(Index) const { return 1; }
    Index zone(Index) const { return kClearWater; }
    bool inSoil(Index) const { return false; }
    bool isHeld(Index, Real) const { return false; }
    Real mobility(Index) const { return 1; }
    Real damping(Index) const { return 1; }
    Real damping(Index, Index, const Vec<Dim>&) const { return 1; }
    Real beta(Index) const { return dt; }
    Real beta(Index, Index, const Vec<Dim>&) const { return dt; }
};

/// Coefficients of (3.4)-(3.6) from the porous state; all arrays cover water and images.
template <int Dim>
struct WaterInSoil {
    static constexpr bool hasSoil = true;
    Real dt = 0;
    const PorousState<Dim>& state;
    Span<const Real> resistance;   ///< r_i = a_i + b_i |v_i|  [1/s]
    Real spacing = 0;              ///< d0 [m]
    /// Extrapolated to the new time [m/s]; empty: nothing carries v through faces
    Span<const Vec<Dim>> v{};
    /// Whether a particle does                        [theory (3.12)]
    Span<const char> carriesDarcy{};

    Real porosity(Index i) const { return state.porosity[i]; }
    Real sharpPorosity(Index i) const { return state.sharpPorosity[i]; }
    Index zone(Index i) const { return state.zone[i]; }
    bool inSoil(Index i) const { return state.zone[i] != kClearWater; }
    /// Whether water in soil is another flow than that beside it: it has pores to squeeze through,
    /// or drag would stop it at this pore velocity [m/s] within ten spacings.        [theory (7.5)]
    bool isHeld(Index i, Real speed) const
    {
        return inSoil(i) && (porosity(i) < Real(0.9) ||
                             mobility(i) * resistance[i] * spacing >= Real(0.1) * speed);
    }
    Real mobility(Index i) const { return state.mobility[i]; }
    /// s_i = 1/(1 + k_i dt' r_i), the share of its momentum that drag leaves a particle.
    Real damping(Index i) const { return 1 / (1 + state.mobility[i] * dt * resistance[i]); }
    /// s_ij with k_ij the harmonic and r_ij the arithmetic mean along the line from i to j, x_ij.
    Real damping(Index i, Index j, const Vec<Dim>& x) const
    {
        return 1 / (1 + pairMobility(i, j) * dt * pairResistance(i, j, x));
    }
    /// beta = k dt' s, what a pressure gradient does to v_D.
    Real beta(Index i) const { return state.mobility[i] * dt * damping(i); }
    /// The same bits from both sides of a pair, as the matrix is rounded.
    Real beta(Index i, Index j, const Vec<Dim>& x) const
    {
        if (j < i) std::swap(i, j);
        return pairMobility(i, j) * dt * damping(i, j, x);
    }
    /// Whether the face of another zone is so near that the soil sums tell its place.
    bool atFace(Index i) const { return state.depth[i] < latticeSpline::kDeep; }
    /// Unit normal of the face between i and j, zero where there is none.
    Vec<Dim> normal(Index i, Index j) const { return unit(state.normal[i] + state.normal[j]); }
    /// Share of the line from i to j that lies in the soil (or water) of i: a face between two
    /// zones cuts it in proportion to their depths beneath it. Where one is deeper than the soil
    /// sums tell, the line does.                                                    [theory (4.15)]
    Real weight(Index i, Index j, const Vec<Dim>& x) const
    {
        if (state.zone[i] == state.zone[j]) return Real(0.5);
        const Real a = state.depth[i], b = state.depth[j], both = a + b;
        if (atFace(i) == atFace(j)) return both > 0 ? a / both : Real(0.5);
        const Real across = std::max(both, std::abs(dot(normal(i, j), x)) / spacing);
        return atFace(i) ? a / across : 1 - b / across;
    }
    /// w.x_ij of a pair as far as its damping acts on it: across a face only the part through it,
    /// so that soil is no no-slip wall to the water along it.
    Real damped(Index i, Index j, const Vec<Dim>& w, const Vec<Dim>& x) const
    {
        if (state.zone[i] == state.zone[j]) return dot(w, x);
        const Vec<Dim> n = normal(i, j);
        return dot(w, n) * dot(n, x);
    }

    bool carries(Index i) const { return !v.empty() && carriesDarcy[i]; }
    /// B_ij, by which p/rho0 of water that flows from i to j falls for its speed in the pores to
    /// rise.                                                                        [theory (3.13)]
    Real swiftness(Index i, Index j) const
    {
        const Real chi_i = state.inertia[i], chi_j = state.inertia[j];
        if (std::abs(chi_j - chi_i) <= kSame * (chi_i + chi_j)) return 0;
        const Real through = Real(0.5) * dot(v[i] + v[j], normal(i, j));
        return Real(0.5) * sqr(through) * (chi_j - chi_i);
    }

private:
    // Between two places deep in one soil: rounding of the soil sums
    static constexpr Real kSame = 1e-9;

    Real pairMobility(Index i, Index j) const
    {
        return 2 * state.mobility[i] * state.mobility[j] / (state.mobility[i] + state.mobility[j]);
    }
    Real pairResistance(Index i, Index j, const Vec<Dim>& x) const
    {
        const Real t = weight(i, j, x);
        return t * resistance[i] + (1 - t) * resistance[j];
    }
};

}  // namespace isph
