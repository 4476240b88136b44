// SPDX-License-Identifier: GPL-3.0-or-later
#include "WriteParticles.hpp"

#include "boundaries/PointCloud.hpp"
#include "output/ParticleArrays.hpp"
#include "output/TimeFolders.hpp"
#include "output/WholeFile.hpp"
#include "porous/PorousField.hpp"

#include <numeric>

namespace isph {

namespace {

std::vector<Vector3> plain(const std::vector<Point>& points)
{
    std::vector<Vector3> result;
    result.reserve(points.size());
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
    return file;
}

ParticleFile wallFile(const CaseGeometry& g, const WallParticles& walls)
{
    ParticleFile file = fileOf(g, walls.x);
    file.vectors["normal"] = plain(walls.normal);
    file.scalars["depth"] = walls.depth;
    file.scalars["volume"] = walls.volume;
    file.integers["wall"] = wide(walls.wall);
    auto& names = file.names["wallNames"];
    for (const Wall& wall : g.walls) names.push_back(wall.name());
    return file;
}

ParticleFile soilFile(const CaseGeometry& g, const SoilParticles& soil,
                      const std::vector<ZonePorosity>& zones)
{
    ParticleFile file = fileOf(g, soil.x);
    file.integers["zone"] = wide(soil.zone);
    file.scalars["solidVolume"] = soil.solidVolume;
    auto& names = file.names["zoneNames"];
    for (const ZonePorosity& zone : zones) names.push_back(zone.name);
    return file;
}

template <int Dim>
PeriodicBox<Dim> boxOf(const CaseGeometry& g)
{
    PeriodicBox<Dim> box;
    for (int d = 0; d < Dim; ++d) {
        box.min[d] = g.domain.min[d], box.max[d] = g.domain.max[d];
        box.periodic[d] = g.periodic[d];
    }
    return box;
}

/// As the solver computes it from the files.
template <int Dim>
std::vector<Real> porosity(const CaseSetup& setup, const ParticleFile& waterFile,
                           const ParticleFile& wallFile, const ParticleFile& soilFile)
{
    const Real spacing = setup.geometry.spacing;
    const PeriodicBox<Dim> box = boxOf<Dim>(setup.geometry);
    const WallCloud<Dim> walls(wallsOf<Dim>(wallFile), box, setup.supportRadius + spacing);
    const Soil<Dim> soil = soilOf<Dim>(soilFile);
    PorousField<Dim> field(readZones(setup.porousZones, soil.names), walls, spacing);
    field.place(soil, box);
    PorousState<Dim> state;
    field.evaluate(waterOf<Dim>(waterFile).x, state);
    return state.porosity;
}

namespace fs = std::filesystem;

/// Everything in `from` but the files that createParticles writes.
void copyOthers(const fs::path& from, const fs::path& to)
{
    if (!fs::is_directory(from)) return;
    for (const auto& entry : fs::directory_iterator(from)) {
        const fs::path name = entry.path().filename();
        if (name == "water.vtp" || name == "walls.vtp" || name == "soil.vtp") continue;
        fs::copy(entry.path(), to / name,
                 fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    }
}

/// The parts and what else the folder holds, in a hidden folder that then takes its place.
void writeFolder(const fs::path& folder, const ParticleParts& parts)
{
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw FatalIOError("cannot make the folder: Not a directory", folder.string(), 0);
    const fs::path whole = folder.parent_path() / ("." + folder.filename().string() + ".part");
    std::error_code ignored;
    try {
        fs::remove_all(whole);  // of a run that was killed
        fs::create_directories(whole);
        copyOthers(folder, whole);
        for (const auto& [name, particles] : parts)
            writeParticleFile(whole / (name + ".vtp"), particles);
        moveIntoPlace(whole, folder);
    } catch (const fs::filesystem_error& error) {
        fs::remove_all(whole, ignored);
        throw FatalIOError("cannot write the folder: " + error.code().message(), folder.string(),
                           0);
    } catch (...) {
        fs::remove_all(whole, ignored);
        throw;
    }
}

}  // namespace

void writeParticles(const std::filesystem::path& folder, const CaseSetup& setup,
                    const WaterParticles& water, const WallParticles& walls,
                    const SoilParticles& soil)
{
    const CaseGeometry& g = setup.geometry;
    ParticleFile waterPart = waterFile(g, water);
    const ParticleFile wallPart = wallFile(g, walls), soilPart = soilFile(g, soil, setup.zones);
    auto& eps = waterPart.scalars["porosity"];
    if (soil.x.empty())
        eps.assign(water.x.size(), 1);
    else
        eps = (g.dimension == 2 ? porosity<2> : porosity<3>)(setup, waterPart, wallPart, soilPart);

    ParticleParts parts{{"water", waterPart}};
    if (walls.size() > 0) parts.emplace("walls", wallPart);
    if (!soil.x.empty()) parts.emplace("soil", soilPart);
    writeFolder(folder, parts);
}

}  // namespace isph
