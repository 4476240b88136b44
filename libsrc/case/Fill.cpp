// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Fill.hpp"

#include "case/BoxCells.hpp"
#include "case/RegionChecks.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {

/// One part of a region: its points once the number is known.
struct Part {
    int partner = -1;      ///< soil region, -1: none
    Real volume = 0;       ///< bulk [m^D]
    std::vector<OrientedBox> boxes;
};

std::vector<Part> partsOf(const std::vector<BoxCell>& cells, int partners, int dimension)
{
    std::vector<Part> parts;
    for (int p = -1; p < partners; ++p) {
        Part part;
        part.partner = p;
        for (const BoxCell& cell : cells)
            if (cell.partner == p) {
                part.boxes.push_back(cell.box);
                part.volume += volumeOf(cell.box, dimension);
            }
        if (!part.boxes.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

/// The number of a lattice with spacing s fitted to the box.
std::int64_t latticeCount(const OrientedBox& box, int dimension, Real s)
{
    std::int64_t n = 1;
    for (int d = 0; d < dimension; ++d) n *= std::max<std::int64_t>(1, std::llround(box.length[d] / s));
    return n;
}

/// `particles` = volume of the part in particles. Rounded sums, so that all boxes together have the
/// rounded number. With `lattices`, boxes take a lattice's number where that is off by one at most.
std::vector<Point> fillPart(const Part& part, int dimension, Real particles, Real spacing, bool lattices)
{
    std::vector<Point> points;
    Real filled = 0;
    std::int64_t placed = 0;
    for (const OrientedBox& box : part.boxes) {
        filled += volumeOf(box, dimension) / part.volume * particles;
        std::int64_t count = std::llround(filled) - placed;
        const std::int64_t lattice = latticeCount(box, dimension, spacing);
        if (lattices && std::abs(lattice - count) <= 1) count = lattice;
        for (const Point& x : fillBox(box, dimension, count)) points.push_back(x);
        placed += count;
    }
    return points;
}

const ZonePorosity* zoneOf(const std::vector<ZonePorosity>& zones, const std::string& name)
{
    for (const ZonePorosity& zone : zones)
        if (zone.name == name) return &zone;
    return nullptr;
}

[[noreturn]] void failNoRoom(const std::string& kind, const std::string& name, Real volume, Real spacing,
                             int dimension, const Location& at)
{
    throw FatalIOError(fmt::format("the {} region {} has no room for a particle: {} {} of it at a spacing of "
                                   "{} m\n(is it covered by a region listed before, or the spacing too large?)",
                                   kind, name, volume, dimension == 2 ? "m2" : "m3", spacing),
                       at.file, at.line);
}

template <class Region>
std::vector<const Shape*> shapesBefore(const std::vector<Region>& regions, std::size_t k)
{
    std::vector<const Shape*> shapes;
    for (std::size_t j = 0; j < k; ++j) shapes.push_back(regions[j].shape.get());
    return shapes;
}

template <class Region>
std::vector<Part> cutRegion(const CaseGeometry& g, const std::vector<Region>& regions, std::size_t k,
                            const std::vector<const Shape*>& partners)
{
    const std::optional<OrientedBox> box = regions[k].shape->box();
    const auto cells = box ? cutIntoCells(*box, g.dimension, shapesBefore(regions, k), partners) : std::nullopt;
    if (!cells) throw FatalError("createParticles cannot fill regions other than boxes yet");
    return partsOf(*cells, static_cast<int>(partners.size()), g.dimension);
}

}  // namespace

SoilParticles fillSoil(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    SoilParticles soil;
    for (std::size_t k = 0; k < g.soil.size(); ++k) {
        const SoilRegion& region = g.soil[k];
        const ZonePorosity* zone = zoneOf(zones, region.zone);
        if (!zone) {
            std::vector<std::string> names;
            for (const ZonePorosity& z : zones) names.push_back(z.name);
            throw FatalIOError(fmt::format("the soil region {} is of zone {}, which constant/porousZones does "
                                           "not have\n\nIts zones are:\n\n{}", region.name, region.zone,
                                           listOf(names)), region.at.file, region.at.line);
        }
        Real volume = 0;
        std::vector<Point> points;
        for (const Part& part : cutRegion(g, g.soil, k, {})) {
            volume += part.volume;
            for (const Point& x : fillPart(part, g.dimension, part.volume / g.cellVolume(), g.spacing, true))
                points.push_back(x);
        }
        if (points.empty()) failNoRoom("soil", region.name, volume, g.spacing, g.dimension, region.at);
        checkInside(g, points, "soil", region.name, *region.shape, region.at);
        const auto count = static_cast<std::int64_t>(points.size());
        for (const Point& x : points) {
            soil.x.push_back(x);
            soil.zone.push_back(static_cast<Index>(zone - zones.data()));
            soil.solidVolume.push_back((1 - zone->porosity) * volume / static_cast<Real>(count));
        }
        soil.parts.push_back({region.name, region.zone, volume, count});
    }
    return soil;
}

WaterParticles fillWater(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    WaterParticles water;
    const std::vector<const Shape*> soils = shapesBefore(g.soil, g.soil.size());
    for (std::size_t k = 0; k < g.water.size(); ++k) {
        const WaterRegion& region = g.water[k];
        std::vector<Point> points;
        Real bulk = 0;
        for (const Part& part : cutRegion(g, g.water, k, soils)) {
            const ZonePorosity* zone = part.partner < 0 ? nullptr : zoneOf(zones, g.soil[part.partner].zone);
            const Real eps = zone ? zone->porosity : 1;
            const Real spacing = g.spacing / std::pow(eps, 1.0 / g.dimension);
            const std::vector<Point> laid =
                fillPart(part, g.dimension, eps * part.volume / g.cellVolume(), spacing, !zone);
            points.insert(points.end(), laid.begin(), laid.end());
            water.parts.push_back({region.name, zone ? zone->name : "", eps * part.volume,
                                   static_cast<std::int64_t>(laid.size())});
            bulk += part.volume;
        }
        if (points.empty()) failNoRoom("water", region.name, bulk, g.spacing, g.dimension, region.at);
        checkInside(g, points, "water", region.name, *region.shape, region.at);
        for (const Point& x : points) {
            water.x.push_back(x);
            water.velocity.push_back(region.velocity ? region.velocity(x) : Point{});
            water.region.push_back(static_cast<Index>(k));
        }
    }
    return water;
}

}  // namespace isph
