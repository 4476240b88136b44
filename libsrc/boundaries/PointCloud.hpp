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

    WallCloud() = default;
    WallCloud(const Walls<Dim>& walls, const PeriodicBox<Dim>& box, Real reach);
    std::size_t size() const { return x.size(); }
};

/// Lays the points of a step: [water | images | walls]. `porosity` is that of the water particles;
/// h = h0/eps^(1/D), volume = d0^D/eps.                                            [theory (2.11)]
template <int Dim>
void layPoints(const Water<Dim>& water, Span<const Real> porosity, const WallCloud<Dim>& walls,
               const PeriodicBox<Dim>& box, Real spacing, Real h0, Real support, Points<Dim>& points);

/// A wall particle counts only where water touches the wall: wholly if its marker, half a spacing above
/// the wall surface, has water within 0.65 local spacings, not from 0.95 on.             [theory (6.5)]
/// Dry walls above a water line would otherwise hide the free surface from the particles at that line.
template <int Dim>
void dryWalls(const WallCloud<Dim>& walls, Real spacing, Real h0, Points<Dim>& points);

}  // namespace isph
