// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/ProjectionStep.hpp"

#include "operators/StrainRate.hpp"

namespace isph {

template <int Dim>
ProjectionStep<Dim>::ProjectionStep(Scene<Dim>& scene, Timers& timers)
    : scene_(scene), timers_(timers), guard_(scene.wallCloud, scene.scheme.spacing),
      lattice_{latticeSum(*scene.kernel, Dim, scene.scheme.h0 / scene.scheme.spacing),
               latticeSupport(*scene.kernel, Dim, scene.scheme.h0 / scene.scheme.spacing)}
{
}

template <int Dim>
void ProjectionStep<Dim>::look()
{
    const Water<Dim>& water = scene_.water;
    const Scheme<Dim>& scheme = scene_.scheme;
    Points<Dim>& points = fields_.points;
    auto& soil = fields_.soil;
    if (scene_.porous) {
        const auto timer = timers_.scope("porosity");
        scene_.porous->evaluate(water.x, soil);
    } else {
        soil.porosity.assign(water.size(), 1);
    }
    {
        const auto timer = timers_.scope("neighbours");
        layPoints<Dim>(water, soil.porosity, scene_.wallCloud, scene_.box, scheme.spacing,
                       scheme.h0, scene_.kernel->supportRadius(), points);
        dryWalls(scene_.wallCloud, scheme.spacing, scheme.h0, points);
        fields_.pairs.build(points, *scene_.kernel);
    }
    const auto timer = timers_.scope("corrections and surface");
    fields_.corrections.compute(points, fields_.pairs);
    findFreeSurface(points, fields_.pairs, fields_.corrections, fields_.role);
    if (scene_.porous) {
        const auto refresh = [&](auto& field) {
            field.resize(points.fluid), points.refresh(field);
        };
        refresh(soil.porosity), refresh(soil.sharpPorosity), refresh(soil.zone),
            refresh(soil.depth);
        refresh(soil.mobility), refresh(soil.normal), refresh(soil.inertia);
        if (!soil.solidsFlux.empty()) refresh(soil.solidsFlux);
    }
}

template <int Dim>
void ProjectionStep<Dim>::eddies()
{
    const Points<Dim>& points = fields_.points;
    const auto& soil = fields_.soil;
    const auto& u = scene_.water.u;
    const auto timer = timers_.scope("turbulence");
    std::vector<Vec<Dim>> all(u);
    std::vector<Real> rate;
    all.resize(points.fluid);
    points.refresh(all);
    strainRate<Dim>(points, fields_.pairs, fields_.corrections, all, rate);
    fields_.eddyViscosity.resize(points.fluid);
    scene_.turbulence->eddyViscosity(rate, Span<const Real>(soil.porosity).first(rate.size()),
                                     scene_.scheme.spacing,
                                     Span<Real>(fields_.eddyViscosity).first(rate.size()));
    points.refresh(fields_.eddyViscosity);
}

template class ProjectionStep<2>;
template class ProjectionStep<3>;

}  // namespace isph
