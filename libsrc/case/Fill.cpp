// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Fill.hpp"

#include "case/BoxCells.hpp"
#include "case/LatticeFit.hpp"
#include "case/Packing.hpp"
#include "case/RegionChecks.hpp"
#include "case/SoilField.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {

const ZonePorosity* zoneOf(const std::vector<ZonePorosity>& zones, const std::string& name)
{
    for (const ZonePorosity& zone : zones)
        if (zone.name == name) return &zone;
    return nullptr;
}

[[noreturn]] void failNoRoom(const std::string& kind, const std::string& name, Real volume,
                             Real spacing, int dimension, const Location& at)
{
    throw FatalIOError(
        fmt::format(
            "the {} region {} has no room for a particle: {:.6g} {} of it at a spacing of "
            "{:.6g} m\n(is it covered by a region listed before, or the spacing too large?)",
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

/// The number of particles for a volume; in one box a lattice's number where that is off by one at
/// most.
std::int64_t clearCount(const RegionPart& part, const CaseGeometry& g)
{
    const std::int64_t count = std::llround(part.volume / g.cellVolume());
    if (part.boxes.size() != 1) return count;
    std::int64_t lattice = 1;
    for (int d = 0; d < g.dimension; ++d)
        lattice *= std::llround(part.boxes[0].length[d] / g.spacing);
    return std::abs(lattice - count) <= 1 && lattice > 0 ? lattice : count;
}

/// Distance to all regions together, positive outside.
template <class Region>
std::function<Real(const Point&)> outsideOf(const CaseGeometry& g,
                                            const std::vector<Region>& regions)
{
    return [&g, &regions](const Point& x) {
        Real f = std::numeric_limits<Real>::max();
        for (const Region& region : regions) f = std::min(f, region.shape->signedDistance(x));
        return std::max(f, Box(g.domain.min, g.domain.max, g.dimension).signedDistance(x));
    };
}

void packLaid(LaidPoints& laid, const CaseGeometry& g,
              const std::function<Real(const Point&)>& outside,
              const std::function<Real(const Point&)>& porosity)
{
    LatticeFit fit = latticeFit(laid, g, outside);
    const PackingTask task{
        g,
        porosity,
        outside,
        [&laid](std::size_t i, const Point& x) { return laid.parts[laid.part[i]].distance(x); },
        std::move(fit.mobility),
        std::move(fit.slides)};
    pack(task, laid.x);
}

const ZonePorosity& zoneOf(const SoilRegion& region, const std::vector<ZonePorosity>& zones)
{
    if (const ZonePorosity* zone = zoneOf(zones, region.zone)) return *zone;
    std::vector<std::string> names;
    for (const ZonePorosity& z : zones) names.push_back(z.name);
    const std::string near = nearestName(region.zone, names);
    throw FatalIOError(
        fmt::format("the soil region {} is of zone {}, which constant/porousZones does not "
                    "have{}\n\nIts zones are:\n\n{}",
                    region.name, region.zone,
                    near.empty() ? "" : fmt::format("; did you mean {}?", near), listOf(names)),
        region.at.file, region.at.line);
}

/// The points of region k.
std::vector<Point> pointsOfRegion(const LaidPoints& laid, std::size_t k)
{
    std::vector<Point> points;
    for (std::size_t i = 0; i < laid.x.size(); ++i)
        if (laid.region[laid.part[i]] == k) points.push_back(laid.x[i]);
    return points;
}

LaidPoints laySoil(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    LaidPoints laid;
    for (std::size_t k = 0; k < g.soil.size(); ++k) {
        const SoilRegion& region = g.soil[k];
        const Real eps = zoneOf(region, zones).porosity;
        Real volume = 0;
        const std::size_t before = laid.x.size();
        for (RegionPart& part : partsOf(g, *region.shape, shapesBefore(g.soil, k), {})) {
            volume += part.volume;
            const PartPoints points = pointsIn(part, g, clearCount(part, g), g.spacing);
            laid.add(std::move(part), k, eps, g.spacing, points);
        }
        if (laid.x.size() == before)
            failNoRoom("soil", region.name, volume, g.spacing, g.dimension, region.at);
    }
    return laid;
}

LaidPoints layWater(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    LaidPoints laid;
    const std::vector<const Shape*> soils = shapesBefore(g.soil, g.soil.size());
    for (std::size_t k = 0; k < g.water.size(); ++k) {
        const WaterRegion& region = g.water[k];
        Real bulk = 0;
        const std::size_t before = laid.x.size();
        for (RegionPart& part : partsOf(g, *region.shape, shapesBefore(g.water, k), soils)) {
            bulk += part.volume;
            const Real eps = part.partner < 0 ? 1 : zoneOf(g.soil[part.partner], zones).porosity;
            const std::int64_t count = part.partner < 0
                                           ? clearCount(part, g)
                                           : std::llround(eps * part.volume / g.cellVolume());
            const Real spacing = g.spacing / std::pow(eps, 1.0 / g.dimension);
            const PartPoints points =
                pointsIn(part, g, count, spacing, eps == 1 ? outsideOf(g, g.water) : nullptr);
            laid.add(std::move(part), k, eps, spacing, points);
        }
        if (laid.x.size() == before)
            failNoRoom("water", region.name, bulk, g.spacing, g.dimension, region.at);
    }
    return laid;
}

}  // namespace

SoilParticles fillSoil(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    SoilParticles soil;
    if (g.soil.empty()) return soil;
    LaidPoints laid = laySoil(g, zones);
    packLaid(laid, g, outsideOf(g, g.soil), [](const Point&) { return Real(1); });
    std::vector<std::int64_t> count(laid.parts.size(), 0);
    for (std::size_t part : laid.part) ++count[part];
    for (std::size_t p = 0; p < laid.parts.size(); ++p) {
        const SoilRegion& region = g.soil[laid.region[p]];
        soil.parts.push_back({region.name, region.zone, laid.parts[p].volume, count[p]});
    }
    for (std::size_t k = 0; k < g.soil.size(); ++k)
        checkInside(g, pointsOfRegion(laid, k), "soil", g.soil[k].name, *g.soil[k].shape,
                    g.soil[k].at);
    soil.x = laid.x;
    for (std::size_t part : laid.part) {
        const ZonePorosity& zone = zoneOf(g.soil[laid.region[part]], zones);
        soil.zone.push_back(static_cast<Index>(&zone - zones.data()));
        soil.solidVolume.push_back((1 - zone.porosity) * laid.parts[part].volume /
                                   static_cast<Real>(count[part]));
    }
    return soil;
}

WaterParticles fillWater(const CaseGeometry& g, const std::vector<ZonePorosity>& zones,
                         const WallParticles& walls, const SoilParticles& soil)
{
    LaidPoints laid = layWater(g, zones);
    const SoilField field(g, soil, walls);
    packLaid(laid, g, outsideOf(g, g.water),
             [&field](const Point& x) { return field.porosity(x); });

    WaterParticles water;
    for (std::size_t p = 0; p < laid.parts.size(); ++p) {
        const RegionPart& part = laid.parts[p];
        const std::string zone = part.partner < 0 ? "" : g.soil[part.partner].zone;
        water.parts.push_back({g.water[laid.region[p]].name, zone, laid.porosity[p] * part.volume,
                               std::count(laid.part.begin(), laid.part.end(), p)});
    }
    water.x = laid.x;
    for (std::size_t i = 0; i < laid.x.size(); ++i) {
        const std::size_t k = laid.region[laid.part[i]];
        water.region.push_back(static_cast<Index>(k));
        water.velocity.push_back(g.water[k].velocity ? g.water[k].velocity(laid.x[i]) : Point{});
    }
    for (std::size_t k = 0; k < g.water.size(); ++k)
        checkInside(g, pointsOfRegion(laid, k), "water", g.water[k].name, *g.water[k].shape,
                    g.water[k].at);
    return water;
}

}  // namespace isph
