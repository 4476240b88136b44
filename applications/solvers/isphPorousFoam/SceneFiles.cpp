// SPDX-License-Identifier: GPL-3.0-or-later
#include "SceneFiles.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {

/// An array of a particle file by name.
template <class Map>
const auto& need(const Map& arrays, const std::string& name, const std::filesystem::path& file)
{
    const auto it = arrays.find(name);
    if (it == arrays.end())
        throw FatalIOError("The array " + name + " is missing.\nWas the file written by createParticles "
                           "or isphPorousFoam?", file.string(), 0);
    return it->second;
}

template <class Map>
auto orElse(const Map& arrays, const std::string& name, typename Map::mapped_type otherwise)
{
    const auto it = arrays.find(name);
    return it == arrays.end() ? std::move(otherwise) : it->second;
}

template <int Dim>
std::vector<Vec<Dim>> fromVectors3(const std::vector<Vector3>& field)
{
    std::vector<Vec<Dim>> r(field.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        for (int d = 0; d < Dim; ++d) r[i][d] = field[i][static_cast<std::size_t>(d)];
    return r;
}

template <int Dim>
void takeWater(const ParticleFile& file, const std::filesystem::path& path, Water<Dim>& water)
{
    const std::size_t n = file.points.size();
    water.x = fromVectors3<Dim>(file.points);
    const auto& U = need(file.vectors, "U", path);
    water.u = fromVectors3<Dim>(U);
    water.uOld = fromVectors3<Dim>(orElse(file.vectors, "UOld", U));
    water.p = orElse(file.scalars, "pEquation", std::vector<Real>(n, 0));
    water.forceGradient = fromVectors3<Dim>(orElse(file.vectors, "forceGradient", std::vector<Vector3>(n)));
    water.id = need(file.integers, "id", path);
}

template <int Dim>
ParticleFile emptyFile(const Scene<Dim>& scene)
{
    ParticleFile file;
    file.numbers["spacing"] = {scene.scheme.spacing};
    file.numbers["dimension"] = {Real(Dim)};
    return file;
}

}  // namespace

template <int Dim>
void takeParticles(const std::map<std::string, ParticleFile>& files,
                   const std::filesystem::path& folder, Scene<Dim>& scene)
{
    takeWater(need(files, "water", folder), folder / "water.vtp", scene.water);
    if (const auto it = files.find("walls"); it != files.end()) {
        const ParticleFile& file = it->second;
        const auto path = folder / "walls.vtp";
        scene.walls.x = fromVectors3<Dim>(file.points);
        scene.walls.normal = fromVectors3<Dim>(need(file.vectors, "normal", path));
        scene.walls.depth = need(file.scalars, "depth", path);
        scene.walls.volume = need(file.scalars, "volume", path);
        scene.walls.wall = need(file.integers, "wall", path);
        scene.walls.id = need(file.integers, "id", path);
        scene.walls.names = need(file.names, "wallNames", path);
    }
    if (const auto it = files.find("soil"); it != files.end()) {
        const ParticleFile& file = it->second;
        const auto path = folder / "soil.vtp";
        const std::size_t n = file.points.size();
        scene.soil.x = fromVectors3<Dim>(file.points);
        scene.soil.u = fromVectors3<Dim>(orElse(file.vectors, "U", std::vector<Vector3>(n)));
        scene.soil.solidVolume = need(file.scalars, "solidVolume", path);
        scene.soil.zone = need(file.integers, "zone", path);
        scene.soil.released = orElse(file.integers, "released", std::vector<std::int64_t>(n, 0));
        scene.soil.id = need(file.integers, "id", path);
        scene.soil.names = need(file.names, "zoneNames", path);
    }
}

template <int Dim>
ParticleFile waterFile(const Scene<Dim>& scene, const StepFields<Dim>& fields)
{
    const Water<Dim>& water = scene.water;
    ParticleFile file = emptyFile(scene);
    file.points = toVectors3(water.x);
    file.vectors["U"] = toVectors3(water.u);
    file.vectors["UOld"] = toVectors3(water.uOld);
    file.vectors["forceGradient"] = toVectors3(water.forceGradient);
    file.scalars["pEquation"] = water.p;
    file.scalars["p"] = pressure(scene);
    file.integers["id"] = water.id;
    const auto& eps = fields.soil.porosity;
    file.scalars["porosity"].assign(eps.begin(), eps.begin() + static_cast<std::ptrdiff_t>(water.size()));
    if (scene.porous) {
        std::vector<Vec<Dim>> darcy(water.u);
        for (std::size_t i = 0; i < darcy.size(); ++i) darcy[i] *= eps[i];
        file.vectors["UDarcy"] = toVectors3(darcy);
    }
    return file;
}

template <int Dim>
ParticleFile wallFile(const Scene<Dim>& scene)
{
    ParticleFile file = emptyFile(scene);
    file.points = toVectors3(scene.walls.x);
    file.vectors["normal"] = toVectors3(scene.walls.normal);
    file.scalars["depth"] = scene.walls.depth;
    file.scalars["volume"] = scene.walls.volume;
    file.integers["wall"] = scene.walls.wall;
    file.integers["id"] = scene.walls.id;
    file.names["wallNames"] = scene.walls.names;
    return file;
}

template <int Dim>
ParticleFile soilFile(const Scene<Dim>& scene)
{
    ParticleFile file = emptyFile(scene);
    file.points = toVectors3(scene.soil.x);
    file.vectors["U"] = toVectors3(scene.soil.u);
    file.scalars["solidVolume"] = scene.soil.solidVolume;
    file.integers["zone"] = scene.soil.zone;
    file.integers["released"] = scene.soil.released;
    file.integers["id"] = scene.soil.id;
    file.names["zoneNames"] = scene.soil.names;
    return file;
}

template <int Dim>
std::vector<Real> pressure(const Scene<Dim>& scene)
{
    const Scheme<Dim>& scheme = scene.scheme;
    const Real g = norm(scheme.force), surface = Real(0.5) * scheme.density * g * scheme.spacing;
    std::vector<Real> p(scene.water.p);
    if (g == 0) return p;
    parallelFor(p.size(), [&](Index i) {
        const Real carried = norm(scene.water.forceGradient[i] + scheme.force) / g;   // |grad p|/(rho |f|)
        p[i] += surface * std::min(Real(1), carried);
    });
    return p;
}

#define ISPH_INSTANTIATE(Dim)                                                                            \
    template void takeParticles(const std::map<std::string, ParticleFile>&, const std::filesystem::path&, \
                                Scene<Dim>&);                                                            \
    template ParticleFile waterFile(const Scene<Dim>&, const StepFields<Dim>&);                          \
    template ParticleFile wallFile(const Scene<Dim>&);                                                   \
    template ParticleFile soilFile(const Scene<Dim>&);                                                   \
    template std::vector<Real> pressure(const Scene<Dim>&);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
