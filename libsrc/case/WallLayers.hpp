// SPDX-License-Identifier: GPL-3.0-or-later
// Wall particles in layers beneath the surfaces that water touches.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

struct WallParticles {
    std::vector<Point> x;
    std::vector<Point> normal;  ///< unit, from the nearest point of the wall surface into the water
    std::vector<Real> depth;    ///< beneath the wall surface [m]
    std::vector<Real> volume;   ///< [m^D]
    std::vector<Index> wall;    ///< index into CaseGeometry::walls

    std::size_t size() const { return x.size(); }
};

/// Layers k = 0, 1, ... at depth (k + 1/2) d0 until `thickness` is filled, laid along the surfaces:
/// the first layer mirrors water that fills the lattice up to the wall. Surfaces between two bodies
/// (a caisson on its floor) count as none. Nothing stands outside the domain in periodic
/// directions.
WallParticles layWalls(const CaseGeometry& geometry, Real thickness);

/// Number of layers for a thickness.
int layerCount(Real spacing, Real thickness);

/// The parts of the walls' surfaces that water can touch (2-D), each with its wall as tag, body on
/// the left, within the domain in periodic directions and within `margin` of it in others.
std::vector<Edge> wetEdges(const CaseGeometry& geometry, Real margin);

/// Points of the surfaces that water can touch, about `step` apart (2-D) or d0/4 (3-D).
std::vector<Point> wetPoints(const CaseGeometry& geometry, Real step);

namespace detail {
WallParticles layWalls2(const CaseGeometry& geometry, Real thickness);
WallParticles layWalls3(const CaseGeometry& geometry, Real thickness);
}  // namespace detail

}  // namespace isph
