// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseParticles.hpp"

#include "output/VtpFile.hpp"

#include <fmt/core.h>

namespace isph {

namespace {

std::vector<Point> points(const std::vector<Vector3>& plain)
{
    std::vector<Point> result;
    for (const Vector3& x : plain) result.push_back({x});
    return result;
}

void requireSame(const ParticleFile& file, const std::string& name, Real now)
{
    const Real then = file.number(name);
    if (std::fabs(then - now) <= 1e-9 * now) return;
    throw FatalIOError(
        fmt::format(
            "made with {} {}, but system/particlesDict now has {}: run createParticles again", name,
            then, now),
        file.source, 0);
}

CaseParticles readParticles(const CaseSetup& setup, const std::filesystem::path& folder)
{
    CaseParticles p;
    p.fromFiles = true;
    const ParticleFile water = readParticleFile(folder / "water.vtp");
    requireSame(water, "spacing", setup.geometry.spacing);
    requireSame(water, "dimension", setup.geometry.dimension);
    p.water.x = points(water.points);
    p.water.velocity = points(water.vector("U"));
    if (std::filesystem::exists(folder / "walls.vtp")) {
        const ParticleFile walls = readParticleFile(folder / "walls.vtp");
        p.walls.x = points(walls.points);
        p.walls.normal = points(walls.vector("normal"));
        p.walls.depth = walls.scalar("depth");
        p.walls.volume = walls.scalar("volume");
        for (std::int64_t w : walls.integer("wall")) p.walls.wall.push_back(static_cast<Index>(w));
    }
    if (std::filesystem::exists(folder / "soil.vtp")) {
        const ParticleFile soil = readParticleFile(folder / "soil.vtp");
        p.soil.x = points(soil.points);
        p.soil.solidVolume = soil.scalar("solidVolume");
    }
    return p;
}

}  // namespace

CaseParticles particlesOf(const CaseSetup& setup, const std::filesystem::path& caseDir)
{
    if (std::filesystem::exists(caseDir / "0" / "water.vtp"))
        return readParticles(setup, caseDir / "0");
    CaseParticles p;
    p.walls = layWalls(setup.geometry, setup.wallThickness());
    p.soil = fillSoil(setup.geometry, setup.zones);
    p.water = fillWater(setup.geometry, setup.zones, p.walls, p.soil);
    return p;
}

}  // namespace isph
