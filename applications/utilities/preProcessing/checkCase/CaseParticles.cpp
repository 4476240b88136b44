// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseParticles.hpp"

#include "output/ParticleArrays.hpp"

namespace isph {

namespace {

CaseParticles readParticles(const CaseSetup& setup, const std::filesystem::path& folder)
{
    CaseParticles p;
    p.fromFiles = true;
    const CaseGeometry& g = setup.geometry;
    const auto read = [&](const std::string& part) {
        ParticleFile file = readParticleFile(folder / (part + ".vtp"));
        requireSameCase(file, g.spacing, g.dimension);
        return file;
    };
    Water<3> water = waterOf<3>(read("water"));
    p.water.x = std::move(water.x);
    p.water.velocity = std::move(water.u);
    if (std::filesystem::exists(folder / "walls.vtp")) {
        Walls<3> walls = wallsOf<3>(read("walls"));
        p.walls.x = std::move(walls.x);
        p.walls.normal = std::move(walls.normal);
        p.walls.depth = std::move(walls.depth);
        p.walls.volume = std::move(walls.volume);
        p.walls.wall.assign(walls.wall.begin(), walls.wall.end());
    }
    if (std::filesystem::exists(folder / "soil.vtp")) {
        Soil<3> soil = soilOf<3>(read("soil"));
        p.soil.x = std::move(soil.x);
        p.soil.solidVolume = std::move(soil.solidVolume);
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
