// SPDX-License-Identifier: GPL-3.0-or-later
#include "Report.hpp"

#include "case/RunEstimate.hpp"
#include "core/Log.hpp"

#include <map>

namespace isph {

namespace {

std::string text(const Point& x)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", x[0], x[1], x[2]);
}

void reportExtent(const std::vector<Point>& points)
{
    BoundingBox box;
    for (const Point& x : points) box.include(x);
    info("    extent {} to {}", text(box.min), text(box.max));
}

void reportWater(const CaseGeometry& g, const WaterParticles& water)
{
    const char* unit = g.dimension == 2 ? "m2" : "m3";
    info("\nWater: {} particles of {:.6g} {} each", water.x.size(), g.cellVolume(), unit);
    Real exact = 0;
    for (const FilledPart& part : water.parts) {
        const Real volume = static_cast<Real>(part.count) * g.cellVolume();
        const std::string place = part.zone.empty() ? "clear" : "in the pores of " + part.zone;
        info("    {:<16} {:<28} {:>9} particles  {:.6g} of {:.6g} {} ({:+.3f} %)", part.region,
             place, part.count, volume, part.volume, unit, 100 * (volume / part.volume - 1));
        exact += part.volume;
    }
    const Real all = static_cast<Real>(water.x.size()) * g.cellVolume();
    info("    {:<16} {:<28} {:>9} particles  {:.6g} of {:.6g} {} ({:+.3f} %)", "all", "",
         water.x.size(), all, exact, unit, 100 * (all / exact - 1));
    reportExtent(water.x);
}

void reportSoil(const CaseGeometry& g, const SoilParticles& soil)
{
    if (soil.x.empty()) return;
    const char* unit = g.dimension == 2 ? "m2" : "m3";
    info("\nSoil: {} particles", soil.x.size());
    for (const FilledPart& part : soil.parts)
        info("    {:<16} {:<28} {:>9} particles  {:.6g} {}", part.region, "zone " + part.zone,
             part.count, part.volume, unit);
    reportExtent(soil.x);
}

void reportWalls(const CaseSetup& setup, const WallParticles& walls)
{
    const CaseGeometry& g = setup.geometry;
    if (g.walls.empty()) return;
    const int layers = layerCount(g.spacing, setup.wallThickness());
    info("\nWalls: {} particles in {} layers, {:.6g} m thick; the kernel needs {:.6g} m",
         walls.size(), layers, layers * g.spacing, setup.wallThickness());
    std::vector<Index> count(g.walls.size(), 0);
    for (Index wall : walls.wall) ++count[wall];
    for (std::size_t w = 0; w < g.walls.size(); ++w)
        info("    {:<16} {:<28} {:>9} particles", g.walls[w].name(),
             g.walls[w].fluidInside() ? "fluid inside" : "fluid outside", count[w]);
    for (std::size_t w = 0; w < g.walls.size(); ++w)
        if (count[w] == 0)
            warning(
                "the wall {} has no particles: it is thinner than the spacing, or no water can "
                "touch it. checkCase tells which.",
                g.walls[w].name());
    if (walls.size() > 0) reportExtent(walls.x);
}

}  // namespace

void report(const CaseSetup& setup, const WaterParticles& water, const WallParticles& walls,
            const SoilParticles& soil)
{
    const CaseGeometry& g = setup.geometry;
    info("{} dimensions, spacing {:.6g} m, domain {} to {}", g.dimension, g.spacing,
         text(g.domain.min), text(g.domain.max));
    for (int d = 0; d < g.dimension; ++d)
        if (g.periodic[d]) info("periodic in {}", "xyz"[d]);
    reportWater(g, water);
    reportWalls(setup, walls);
    reportSoil(g, soil);
    const ParticleNumbers numbers{water.x.size(), walls.size(), soil.x.size()};
    const Real neighbours = neighbourNumber(setup.clearRadius, g.spacing, g.dimension);
    info("\nExpected memory of the run: {:.0f} MB", 1e-6 * runMemory(numbers, neighbours));
}

}  // namespace isph
