// SPDX-License-Identifier: GPL-3.0-or-later
// Which laid points stand right already and which have to be packed.
#pragma once
#include "case/RegionParts.hpp"

namespace isph {

/// Parts of regions with their points.
struct LaidPoints {
    std::vector<RegionPart> parts;
    std::vector<std::size_t> region;  ///< of each part
    std::vector<Real> porosity;       ///< of each part
    std::vector<Real> spacing;        ///< of each part's points [m]
    std::vector<Point> x;
    std::vector<std::size_t> part;  ///< of each point
    std::vector<char> snapped;      ///< left its place in the lattice for a layer beneath a face

    void add(RegionPart p, std::size_t ofRegion, Real eps, Real apart, const PartPoints& points);
};

struct LatticeFit {
    std::vector<Real> mobility;  ///< 0: stays, 1: moves freely
    std::vector<char> slides;    ///< stands half a spacing from the outside: keeps that distance
};

/// Points move within ten spacings of misfits, points nearer to or farther from a face of their
/// part than the half spacing that a lattice has, and within five of parts of another porosity.
/// Where the lattice fits the outside, as at a level surface of water, they move along it only.
/// outside: distance to all parts together, positive outside.
LatticeFit latticeFit(const LaidPoints& laid, const CaseGeometry& geometry,
                      const std::function<Real(const Point&)>& outside);

}  // namespace isph
