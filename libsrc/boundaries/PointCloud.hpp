// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the points of a step from water and walls: images of periodic directions, wetted walls.
#pragma once
#include "boundaries/Periodic.hpp"

namespace isph {

/// Wall particles with their periodic images, made once: walls do not move.
template <int Dim>
struct WallCloud {
    std::vector<Vec<Dim>> x, normal;
    std::vector<Real> depth, volume;
    std::vector<std::int64_t> wall;
    std::vector<Index> owner;   ///< the wall particle that each entry is or copies
    std::vector<char> noSlip;   ///< 1 where water sticks to the wall; empty where all walls slip
    /// 1 where a thin boundary layer brakes the water; empty where none does
    std::vector<char> wallLaw;
    /// Of the wall's surface, along itself [m/s]; empty without friction
    std::vector<Vec<Dim>> velocity;

    WallCloud() = default;
    WallCloud(const Walls<Dim>& walls, const PeriodicBox<Dim>& box, Real reach);
    std::size_t size() const { return x.size(); }

    /// v_i - v_k for water i at x_k + x_ik with Darcy velocity v_i and a sticking wall particle k:
    /// v_k lies on the straight line from v_i through the velocity of the wall at its surface.
    ///                                                                               [theory (6.8)]
    Vec<Dim> slip(Index k, const Vec<Dim>& x_ik, const Vec<Dim>& v_i, Real porosity,
                  Real spacing) const
    {
        const Real height = std::max(Real(0.5) * spacing, dot(x_ik, normal[k]) - depth[k]);
        return (1 + depth[k] / height) * (v_i - porosity * velocity[k]);
    }
};

/// Lays the points of a step: [water | images | walls]. `porosity` is that of the water particles;
/// h = h0/eps^(1/D), volume = d0^D/eps.                                            [theory (2.11)]
template <int Dim>
void layPoints(const Water<Dim>& water, Span<const Real> porosity, const WallCloud<Dim>& walls,
               const PeriodicBox<Dim>& box, Real spacing, Real h0, Real support,
               Points<Dim>& points);

/// A wall particle counts only where water touches the wall: wholly if its marker, half a spacing
/// above the wall surface, has water within 0.65 local spacings, not from 0.95 on.   [theory (6.5)]
/// Dry walls above a water line would otherwise hide the free surface from the particles at that
/// line.
template <int Dim>
void dryWalls(const WallCloud<Dim>& walls, Real spacing, Real h0, Points<Dim>& points);

}  // namespace isph
