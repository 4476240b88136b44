// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParticleChecks.hpp"

#include "case/Flood.hpp"
#include "case/SoilField.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {

std::string text(const Point& x)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", x[0], x[1], x[2]);
}

/// No two particles on each other, none in a wall: the pressure equation would push them apart with
/// a bang.
std::string checkWater(const CaseSetup& setup, const CaseParticles& particles)
{
    const CaseGeometry& g = setup.geometry;
    const Real least = 0.5 * g.spacing;
    const PeriodicPoints all(g, particles.water.x, 2 * g.spacing);
    const PointGrid grid(g.spacing, all.x);
    for (std::size_t i = 0; i < particles.water.x.size(); ++i) {
        const Point& x = particles.water.x[i];
        grid.forEachWithin(x, least, [&](Index k, const Point& r) {
            if (k != static_cast<Index>(i))
                throw FatalError(
                    fmt::format("the water particles at {} are {:.3g} m apart, less than half a "
                                "spacing",
                                text(x), norm(r)));
        });
        if (!g.domain.contains(x, 1e-6 * g.spacing))
            throw FatalError(
                fmt::format("the water particle at {} is outside the domain", text(x)));
        if (!g.walls.empty() && g.bodyDistance(x) < 0)
            throw FatalError(fmt::format("the water particle at {} is in a wall", text(x)));
    }
    return fmt::format("{} particles", particles.water.x.size());
}

/// A period of less than two supports would make a particle and its image neighbours of a third.
std::string checkPeriods(const CaseSetup& setup)
{
    const CaseGeometry& g = setup.geometry;
    for (int d = 0; d < g.dimension; ++d) {
        const Real length = g.domain.max[d] - g.domain.min[d];
        if (g.periodic[d] && length < 2 * setup.supportRadius)
            throw FatalError(fmt::format(
                "the period along {} is {} m, less than two supports of the kernel, {} m", "xyz"[d],
                length, 2 * setup.supportRadius));
    }
    return "";
}

/// Particles stand behind all of the surface that water can touch.
std::string checkCover(const CaseSetup& setup, const CaseParticles& particles)
{
    const CaseGeometry& g = setup.geometry;
    const PeriodicPoints all(g, particles.walls.x, 2 * g.spacing);
    const PointGrid grid(g.spacing, all.x);
    std::size_t bare = 0, number = 0;
    Point where;
    for (const Point& x : wetPoints(g, 0.5 * g.spacing)) {
        ++number;
        // a lattice keeps within 0.71 d0 in two dimensions, 0.87 d0 in three; a hole of d0 takes
        // one particle out
        if (grid.nearest(x, 1.1 * g.spacing) >= 0) continue;
        if (bare++ == 0) where = x;
    }
    if (bare > 0)
        throw FatalError(fmt::format(
            "{} of {} places on the walls have no wall particle behind them, for instance {}: "
            "the wall is thinner than the spacing there, or 0/walls.vtp is of another "
            "geometry (run createParticles again)",
            bare, number, text(where)));
    return "";
}

/// Behind each particle of the first layer follow others as deep as the kernel sees, or the body
/// ends.
std::string checkThickness(const CaseSetup& setup, const CaseParticles& particles,
                           const Flood& flood)
{
    const CaseGeometry& g = setup.geometry;
    const Real d0 = g.spacing,
               needed = setup.supportRadius - 0.5 * d0;  // water keeps d0/2 from the surface
    const PeriodicPoints all(g, particles.walls.x, 2 * d0);
    const PointGrid grid(d0, all.x);
    for (std::size_t i = 0; i < particles.walls.size(); ++i) {
        if (particles.walls.depth[i] > 0.75 * d0) continue;
        const Point surface =
            particles.walls.x[i] + particles.walls.depth[i] * particles.walls.normal[i];
        for (Real depth = 0.5 * d0; depth < needed; depth += 0.25 * d0) {
            const Point x = surface - depth * particles.walls.normal[i];
            const std::string wall = g.walls[particles.walls.wall[i]].name();
            if (g.bodyDistance(g.wrapped(x)) > 1e-6 * d0) {  // out on the other side
                if (depth + d0 < setup.supportRadius &&
                    flood.reached(surface - (depth + d0) * particles.walls.normal[i]))
                    throw FatalError(fmt::format(
                        "the wall {} is {:.3g} m thick at {}: the water on its two sides is "
                        "within the reach of the kernel, {:.3g} m; make it thicker than "
                        "{:.3g} m or the spacing smaller",
                        wall, depth, text(surface), setup.supportRadius, setup.supportRadius - d0));
                break;
            }
            if (grid.nearest(x, 1.1 * d0) < 0)
                throw FatalError(fmt::format(
                    "the particles of the wall {} end {:.3g} m beneath its surface at {}; the "
                    "kernel sees {:.3g} m of it (run createParticles again after changes of "
                    "kernel, smoothingRatio or porosity)",
                    wall, depth, text(surface), needed));
        }
    }
    return fmt::format("{:.4g} m, the kernel reaches {:.4g} m",
                       layerCount(d0, setup.wallThickness()) * d0, setup.supportRadius);
}

/// No way out between the walls that is narrower than an opening that somebody meant.
std::string checkHoles(const CaseGeometry& g, const CaseParticles& particles, const Point& up,
                       const Flood& flood)
{
    if (!flood.leak()) return "";
    const Real meant = 5 * g.spacing;
    if (Flood(g, particles.water.x, up, meant).leak())
        return fmt::format("water may leave the domain, for instance at {}", text(*flood.leak()));
    throw FatalError(fmt::format(
        "there is a hole wider than the spacing in the walls: water can reach the end of the "
        "domain at {} through an opening of less than {:.3g} m",
        text(*flood.leak()), meant));
}

std::string checkSoil(const CaseSetup& setup)
{
    const CaseGeometry& g = setup.geometry;
    for (const SoilRegion& region : g.soil) {
        const auto box = region.shape->box();
        if (!box) continue;
        for (int d = 0; d < g.dimension; ++d)
            if (box->length[d] < 2 * g.spacing)
                throw FatalIOError(
                    fmt::format("the soil region {} is {:.3g} m thick, less than two spacings: the "
                                "smoothed porosity does not reach the zone's",
                                region.name, box->length[d]),
                    region.at.file, region.at.line);
    }
    return "";
}

}  // namespace

void noteGrains(const CaseSetup& setup, const std::filesystem::path& caseDir, Checklist& list)
{
    const Dictionary zones = Dictionary::read(caseDir / "constant" / "porousZones");
    for (const ZonePorosity& zone : setup.zones) {
        const Dictionary& dict = zones.subDict(zone.name);
        const std::string coefficients = dict.get<std::string>("porousModel") + "Coeffs";
        if (!dict.found(coefficients) || !dict.subDict(coefficients).found("D50")) continue;
        const Real grain = dict.subDict(coefficients).get<Real>("D50", dims::length);
        if (setup.geometry.spacing < grain)
            list.note(
                fmt::format("grains of {} are {:.3g} m, more than the spacing {:.3g} m: the flow "
                            "between single "
                            "grains is not resolved, what is computed is the mean over many",
                            zone.name, grain, setup.geometry.spacing));
    }
}

void checkParticles(const CaseSetup& setup, const CaseParticles& particles, const Point& gravity,
                    Checklist& list)
{
    const CaseGeometry& g = setup.geometry;
    list.check("water", [&] { return checkWater(setup, particles); });
    list.check("periods", [&] { return checkPeriods(setup); });
    if (!g.soil.empty()) list.check("soil", [&] { return checkSoil(setup); });
    if (g.walls.empty()) return list.note("there are no walls");
    const Point up = norm(gravity) > 0 ? -unit(gravity) : Point{};
    const Flood flood(g, particles.water.x, up, g.spacing);
    list.check("wall surfaces", [&] { return checkCover(setup, particles); });
    list.check("wall thickness", [&] { return checkThickness(setup, particles, flood); });
    list.check("holes in walls", [&] { return checkHoles(g, particles, up, flood); });
}

}  // namespace isph
