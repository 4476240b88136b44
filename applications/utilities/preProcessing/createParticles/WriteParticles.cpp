// SPDX-License-Identifier: GPL-3.0-or-later
#include "WriteParticles.hpp"

#include "output/VtpFile.hpp"

#include <numeric>

namespace isph {

namespace {

std::vector<Vector3> plain(const std::vector<Point>& points)
{
    std::vector<Vector3> result;
    for (const Point& x : points) result.push_back(x.c);
    return result;
}

std::vector<std::int64_t> wide(const std::vector<Index>& values)
{
    return {values.begin(), values.end()};
}

ParticleFile fileOf(const CaseGeometry& g, const std::vector<Point>& points)
{
    ParticleFile file;
    file.points = plain(points);
    file.numbers["dimension"] = {static_cast<Real>(g.dimension)};
    file.numbers["spacing"] = {g.spacing};
    auto& id = file.integers["id"];
    id.resize(points.size());
    std::iota(id.begin(), id.end(), 0);
    return file;
}

ParticleFile waterFile(const CaseGeometry& g, const WaterParticles& water)
{
    ParticleFile file = fileOf(g, water.x);
    file.vectors["U"] = plain(water.velocity);
    file.scalars["p"] = std::vector<Real>(water.x.size(), 0);
    file.scalars["porosity"] = std::vector<Real>(water.x.size(), 1);
    return file;
}

ParticleFile wallFile(const CaseGeometry& g, const WallParticles& walls)
{
    ParticleFile file = fileOf(g, walls.x);
    file.vectors["normal"] = plain(walls.normal);
    file.scalars["depth"] = walls.depth;
    file.scalars["volume"] = walls.volume;
    file.integers["wall"] = wide(walls.wall);
    for (const Wall& wall : g.walls) file.names["wallNames"].push_back(wall.name());
    return file;
}

ParticleFile soilFile(const CaseGeometry& g, const SoilParticles& soil,
                      const std::vector<ZonePorosity>& zones)
{
    ParticleFile file = fileOf(g, soil.x);
    file.integers["zone"] = wide(soil.zone);
    file.scalars["solidVolume"] = soil.solidVolume;
    for (const ZonePorosity& zone : zones) file.names["zoneNames"].push_back(zone.name);
    return file;
}

}  // namespace

void writeParticles(const std::filesystem::path& folder, const CaseGeometry& g,
                    const std::vector<ZonePorosity>& zones, const WaterParticles& water,
                    const WallParticles& walls, const SoilParticles& soil)
{
    std::filesystem::create_directories(folder);
    writeParticleFile(folder / "water.vtp", waterFile(g, water));
    if (walls.size() > 0)
        writeParticleFile(folder / "walls.vtp", wallFile(g, walls));
    else
        std::filesystem::remove(folder / "walls.vtp");
    if (!soil.x.empty())
        writeParticleFile(folder / "soil.vtp", soilFile(g, soil, zones));
    else
        std::filesystem::remove(folder / "soil.vtp");
}

}  // namespace isph
