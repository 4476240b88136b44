// SPDX-License-Identifier: GPL-3.0-or-later
#include "SceneFiles.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace isph {

template <int Dim>
void takeParticles(const std::map<std::string, ParticleFile>& files, Scene<Dim>& scene)
{
    scene.water = waterOf<Dim>(files.at("water"));
    if (const auto it = files.find("walls"); it != files.end())
        scene.walls = wallsOf<Dim>(it->second);
    if (const auto it = files.find("soil"); it != files.end()) scene.soil = soilOf<Dim>(it->second);
}

template <int Dim>
void requireApart(const Scene<Dim>& scene, const std::filesystem::path& file)
{
    const Water<Dim>& water = scene.water;
    const Real reach = 0.1 * scene.scheme.spacing;
    CellGrid<Dim> grid;
    grid.build(water.x, scene.scheme.spacing);
    std::vector<Index> other(water.size(), -1);
    parallelFor(water.size(), [&](Index i) {
        grid.forEachNear(water.x[i], reach, [&](Index j) {
            if (j != i && norm(water.x[j] - water.x[i]) <= reach) other[i] = j;
        });
    });
    for (std::size_t i = 0; i < other.size(); ++i)
        if (other[i] >= 0)
            throw FatalIOError(
                fmt::format("The water particles {} and {} at ({:g}) are {:.3g} m apart, less than "
                            "a tenth of the spacing, and would "
                            "stay together as one: move one of them, or run createParticles again.",
                            water.id[i], water.id[other[i]], fmt::join(water.x[i].c, " "),
                            norm(water.x[i] - water.x[other[i]])),
                file.string(), 0);
}

template <int Dim>
void sortParticles(Scene<Dim>& scene, Real reach)
{
    CellGrid<Dim> grid;
    PairList<Dim>::binByCells(scene.water.x, reach, grid);
    scene.water.reorder(grid.order());
}

template <int Dim>
ParticleFile waterFile(const Scene<Dim>& scene, const StepFields<Dim>& fields)
{
    ParticleFile file = fileOf(scene.water, scene.scheme.spacing);
    file.scalars["p"] = pressure(scene, fields);
    const auto& eps = fields.soil.porosity;
    file.scalars["porosity"].assign(eps.begin(),
                                    eps.begin() + static_cast<std::ptrdiff_t>(scene.water.size()));
    if (scene.porous) {
        std::vector<Vec<Dim>> darcy(scene.water.u);
        for (std::size_t i = 0; i < darcy.size(); ++i) darcy[i] *= eps[i];
        file.vectors["UDarcy"] = toVectors3(darcy);
    }
    return file;
}

template <int Dim>
std::vector<Real> pressure(const Scene<Dim>& scene, const StepFields<Dim>& fields)
{
    const Scheme<Dim>& scheme = scene.scheme;
    const Real g = norm(scheme.force), surface = Real(0.5) * scheme.density * g * scheme.spacing;
    std::vector<Real> p(scene.water.p);
    const auto& role = fields.role;
    if (scheme.surfaceCarries || g == 0) return p;
    if (std::find(role.begin(), role.end(), SurfaceRole::surface) == role.end()) return p;
    parallelFor(p.size(), [&](Index i) {
        // Soil holds its water against falling
        const bool held = scene.porous && fields.soil.zone[i] != kClearWater;
        // |grad p|/(rho |f|)
        const Real carried = norm(scene.water.forceGradient[i] + scheme.force) / g;
        p[i] += surface * (held ? 1 : std::min(Real(1), carried));
    });
    return p;
}

#define ISPH_INSTANTIATE(Dim)                                                                      \
    template void takeParticles(const std::map<std::string, ParticleFile>&, Scene<Dim>&);          \
    template void requireApart(const Scene<Dim>&, const std::filesystem::path&);                   \
    template void sortParticles(Scene<Dim>&, Real);                                                \
    template ParticleFile waterFile(const Scene<Dim>&, const StepFields<Dim>&);                    \
    template std::vector<Real> pressure(const Scene<Dim>&, const StepFields<Dim>&);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
