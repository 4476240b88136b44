// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlowViews.hpp"

#include "SceneFiles.hpp"

#include <algorithm>

namespace isph {

template <int Dim>
FlowView flowView(const Scene<Dim>& scene, const StepFields<Dim>& fields, Real time)
{
    const auto n = static_cast<std::ptrdiff_t>(scene.water.size());
    FlowView view;
    view.dimension = Dim;
    view.time = time;
    view.spacing = scene.scheme.spacing;
    view.density = scene.scheme.density;
    view.gravity = toVector3(scene.scheme.force);
    view.kernel = scene.kernel.get();
    view.smoothingRatio = scene.scheme.h0 / scene.scheme.spacing;
    view.position = toVectors3(scene.water.x);
    view.id = scene.water.id;
    view.porosity.assign(fields.soil.porosity.begin(), fields.soil.porosity.begin() + n);
    view.scalars["porosity"] = view.porosity;
    if (scene.porous) {
        const auto at = [](const Vector3& place) {
            Vec<Dim> x;
            std::copy_n(place.begin(), Dim, x.c.begin());
            return x;
        };
        const PorousField<Dim>& soil = *scene.porous;
        view.porosityAt = [&soil, at](const Vector3& place) {
            return soil.sharpPorosityAt(at(place));
        };
        view.zone.assign(fields.soil.zone.begin(), fields.soil.zone.begin() + n);
        view.zoneAt = [&soil, at](const Vector3& place) { return soil.zoneAt(at(place)); };
    }
    view.scalars["p"] = pressure(scene, fields);
    view.vectors["U"] = toVectors3(scene.water.u);
    std::vector<Vec<Dim>> darcy(scene.water.u);
    for (std::size_t i = 0; i < darcy.size(); ++i) darcy[i] *= view.porosity[i];
    view.vectors["UDarcy"] = toVectors3(darcy);
    view.wallPosition = toVectors3(scene.wallCloud.x);
    view.wallVolume = scene.wallCloud.volume;
    for (int d = 0; d < Dim; ++d)
        view.periodic[static_cast<std::size_t>(d)] = scene.box.periodic[d];
    view.domainMin = toVector3(scene.box.min);
    view.domainMax = toVector3(scene.box.max);
    return view;
}

template FlowView flowView(const Scene<2>&, const StepFields<2>&, Real);
template FlowView flowView(const Scene<3>&, const StepFields<3>&, Real);

}  // namespace isph
