// SPDX-License-Identifier: GPL-3.0-or-later
#include "SceneFiles.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

template <int Dim>
void takeParticles(const std::map<std::string, ParticleFile>& files, Scene<Dim>& scene)
{
    scene.water = waterOf<Dim>(files.at("water"));
    if (const auto it = files.find("walls"); it != files.end()) scene.walls = wallsOf<Dim>(it->second);
    if (const auto it = files.find("soil"); it != files.end()) scene.soil = soilOf<Dim>(it->second);
}

template <int Dim>
void sortParticles(Scene<Dim>& scene)
{
    CellGrid<Dim> grid;
    grid.build(scene.water.x, scene.kernel->supportRadius() * scene.scheme.h0);
    scene.water.reorder(grid.order());
}

template <int Dim>
ParticleFile waterFile(const Scene<Dim>& scene, const StepFields<Dim>& fields)
{
    ParticleFile file = fileOf(scene.water, scene.scheme.spacing);
    file.scalars["p"] = pressure(scene);
    const auto& eps = fields.soil.porosity;
    file.scalars["porosity"].assign(eps.begin(), eps.begin() + static_cast<std::ptrdiff_t>(scene.water.size()));
    if (scene.porous) {
        std::vector<Vec<Dim>> darcy(scene.water.u);
        for (std::size_t i = 0; i < darcy.size(); ++i) darcy[i] *= eps[i];
        file.vectors["UDarcy"] = toVectors3(darcy);
    }
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

#define ISPH_INSTANTIATE(Dim)                                                                      \
    template void takeParticles(const std::map<std::string, ParticleFile>&, Scene<Dim>&);          \
    template void sortParticles(Scene<Dim>&);                                                      \
    template ParticleFile waterFile(const Scene<Dim>&, const StepFields<Dim>&);                    \
    template std::vector<Real> pressure(const Scene<Dim>&);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
