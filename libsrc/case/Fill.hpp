// SPDX-License-Identifier: GPL-3.0-or-later
// Water and soil particles that fill their regions with the right number.
#pragma once
#include "case/WallLayers.hpp"

#include <cstdint>

namespace isph {

/// A soil zone as far as filling goes.
struct ZonePorosity {
    std::string name;
    Real porosity = 1;
};

/// What was laid in one part of a region, for the report.
struct FilledPart {
    std::string region;
    std::string zone;  ///< empty: clear of soil
    Real volume = 0;   ///< of water, soil: of the bulk [m^D]
    std::int64_t count = 0;
};

struct SoilParticles {
    std::vector<Point> x;
    std::vector<Index> zone;        ///< index into the zones
    std::vector<Real> solidVolume;  ///< [m^D]; sums to (1 - porosity) times the zone's volume
    std::vector<FilledPart> parts;
};

/// Soil at spacing d0, half a spacing from the faces of its regions. Boxes hold a lattice fitted to
/// them or rows of nearly equal numbers; other shapes are filled evenly by packing. errors
/// FatalIOError at the region: unknown zone, no room for a particle, soil in a wall or outside
///         the domain
SoilParticles fillSoil(const CaseGeometry& geometry, const std::vector<ZonePorosity>& zones);

struct WaterParticles {
    std::vector<Point> x;
    std::vector<Point> velocity;  ///< pore velocity [m/s]
    std::vector<Index> region;    ///< index into CaseGeometry::water
    std::vector<FilledPart> parts;
};

/// Every particle stands for d0^D of water: d0 apart in clear water, d0/porosity^(1/D) in soil,
/// with the porosity that the soil particles make around soil surfaces. The number in soil is
/// round(pore volume/d0^D) per region and zone, in clear water within one of volume/d0^D.
/// errors  FatalIOError at the region: no room for a particle, water in a wall or outside the
/// domain
WaterParticles fillWater(const CaseGeometry& geometry, const std::vector<ZonePorosity>& zones,
                         const WallParticles& walls, const SoilParticles& soil);

}  // namespace isph
