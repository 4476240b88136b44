// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes for tests, made in the program instead of read from a case.
#pragma once
#include "Scatter.hpp"
#include "core/Timers.hpp"
#include "integrator/DragImplicitStep.hpp"
#include "integrator/Scene.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

namespace isph {

/// Lattices of water and soil, box walls around a tank. What is not said is as in a case without
/// the entry; the pressure is solved to 1e-11, so that its tolerance is not what a test measures.
template <int Dim>
class SceneBuilder {
public:
    using Counts = std::array<int, Dim>;

    explicit SceneBuilder(Real spacing, Real smoothingRatio = 1.5)
    {
        scene_.scheme.spacing = spacing;
        scene_.scheme.h0 = smoothingRatio * spacing;
        scene_.scheme.force[Dim - 1] = -9.81;
    }
    SceneBuilder& force(const Vec<Dim>& f) { return scene_.scheme.force = f, *this; }
    SceneBuilder& viscosity(Real nu) { return scene_.scheme.viscosity = nu, *this; }
    SceneBuilder& relaxationTime(Real T) { return relaxationTime_ = T, *this; }

    /// Water on a lattice, of as many cells as the spacing asks for; or of `count`, as in soil.
    SceneBuilder& water(const Vec<Dim>& min, const Vec<Dim>& max, const Vec<Dim>& u = {})
    {
        return waterCells(min, max, cells(min, max), u);
    }
    SceneBuilder& waterCells(const Vec<Dim>& min, const Vec<Dim>& max, const Counts& count,
                             const Vec<Dim>& u = {})
    {
        for (const Vec<Dim>& x : lattice<Dim>(min, max, count)) particle(x, u);
        return *this;
    }
    SceneBuilder& particle(const Vec<Dim>& x, const Vec<Dim>& u = {})
    {
        Water<Dim>& w = scene_.water;
        w.id.push_back(static_cast<std::int64_t>(w.size()));
        w.x.push_back(x), w.u.push_back(u), w.uOld.push_back(u), w.p.push_back(0),
            w.forceGradient.push_back({});
        w.forceGradientOld.push_back({});
        return *this;
    }
    SceneBuilder& shakeWater(Real spacings)
    {
        return shake(scene_.water.x, spacings * scene_.scheme.spacing), *this;
    }

    /// A tank: five layers of walls around a box, but for what `open` refuses.
    SceneBuilder& tank(
        const Vec<Dim>& min, const Vec<Dim>& max,
        const std::function<bool(const Vec<Dim>&)>& open = [](const Vec<Dim>&) { return false; })
    {
        const Real d0 = scene_.scheme.spacing, thick = 5 * d0;
        Vec<Dim> low = min, high = max;
        for (int d = 0; d < Dim; ++d) low[d] -= thick, high[d] += thick;
        for (const Vec<Dim>& x : lattice<Dim>(low, high, cells(low, high))) {
            Vec<Dim> foot = x;
            for (int d = 0; d < Dim; ++d) foot[d] = std::clamp(x[d], min[d], max[d]);
            if (foot == x || open(x)) continue;
            addWall(x, foot - x);
        }
        return *this;
    }
    /// A tank without a lid.
    SceneBuilder& openTank(const Vec<Dim>& min, const Vec<Dim>& max)
    {
        return tank(min, max, [=](const Vec<Dim>& x) { return x[Dim - 1] > max[Dim - 1]; });
    }
    SceneBuilder& periodic(const Vec<Dim>& min, const Vec<Dim>& max,
                           const std::array<bool, Dim>& directions)
    {
        scene_.box.min = min, scene_.box.max = max, scene_.box.periodic = directions;
        return *this;
    }
    /// A lattice of soil in a zone of its own.
    SceneBuilder& soil(const Vec<Dim>& min, const Vec<Dim>& max, const std::string& zone)
    {
        SoilZone z;
        z.name = "zone" + std::to_string(zones_.size());
        z.model = PorousModel::select(Dictionary::parse(zone, z.name));
        z.porosity = z.model->porosity();
        for (const Vec<Dim>& x : lattice<Dim>(min, max, cells(min, max))) {
            Soil<Dim>& s = scene_.soil;
            s.id.push_back(static_cast<std::int64_t>(s.size()));
            s.x.push_back(x), s.u.push_back({}), s.released.push_back(0);
            s.zone.push_back(static_cast<std::int64_t>(zones_.size()));
            s.solidVolume.push_back((1 - z.porosity) * scene_.scheme.particleVolume());
        }
        scene_.soil.names.push_back(z.name);
        zones_.push_back(std::move(z));
        return *this;
    }

    Scene<Dim> build(const std::string& kernel = "wendlandC2", const std::string& solver = "PCG")
    {
        scene_.kernel = kernelNamed(kernel);
        scene_.solver = PressureSolver::select(
            Dictionary::parse("solver " + solver + "; tolerance 1e-11; maxIter 5000;"));
        scene_.scheme.relaxationTime = relaxationTime_ > 0 ? relaxationTime_ : automaticTime();
        // Porosities above 1/4
        const Real reach = scene_.kernel->supportRadius() * scene_.scheme.h0 * 2;
        scene_.wallCloud = WallCloud<Dim>(scene_.walls, scene_.box, reach);
        if (!zones_.empty()) {
            for (SoilZone& z : zones_)
                z.resistance = z.model->resistance(z.porosity, scene_.scheme.viscosity);
            scene_.porous = std::make_unique<PorousField<Dim>>(std::move(zones_), scene_.wallCloud,
                                                               scene_.scheme.spacing);
            scene_.porous->place(scene_.soil, scene_.box);
        }
        return std::move(scene_);
    }

private:
    Counts cells(const Vec<Dim>& min, const Vec<Dim>& max) const
    {
        Counts count;
        for (int d = 0; d < Dim; ++d)
            count[d] = static_cast<int>(std::lround((max[d] - min[d]) / scene_.scheme.spacing));
        return count;
    }
    void addWall(const Vec<Dim>& x, const Vec<Dim>& toSurface)
    {
        Walls<Dim>& w = scene_.walls;
        w.x.push_back(x), w.normal.push_back(unit(toSurface)), w.depth.push_back(norm(toSurface));
        w.volume.push_back(scene_.scheme.particleVolume());
        w.wall.push_back(0), w.id.push_back(static_cast<std::int64_t>(w.id.size()));
        w.names = {"tank"};
    }
    /// 0.7 sqrt(H/|g|) of (5.5), H the water's extent along g.
    Real automaticTime() const
    {
        const Real g = norm(scene_.scheme.force);
        if (g == 0 || scene_.water.size() == 0) return scene_.scheme.relaxationTime;
        const Vec<Dim> up = -unit(scene_.scheme.force);
        Real low = std::numeric_limits<Real>::max(), high = -low;
        for (const Vec<Dim>& x : scene_.water.x)
            low = std::min(low, dot(x, up)), high = std::max(high, dot(x, up));
        return 0.7 * std::sqrt((high - low + scene_.scheme.spacing) / g);
    }

    Scene<Dim> scene_;
    std::vector<SoilZone> zones_;
    Real relaxationTime_ = 0;
};

/// Advances a scene by `steps` equal steps from rest in its history; `each` sees it after every
/// step.
template <int Dim>
StepReport advance(Scene<Dim>& scene, Real dt, int steps,
                   const std::function<void(int, const StepFields<Dim>&)>& each = {})
{
    Timers timers;
    DragImplicitStep<Dim> step(scene, timers);
    StepReport report;
    step.look();
    for (int n = 1; n <= steps; ++n) {
        report = step.advance(dt, n == 1 ? 0 : dt);
        if (!report.pressure.converged)
            throw FatalError("The pressure did not converge in step " + std::to_string(n));
        if (each) each(n, step.fields());
    }
    return report;
}

/// Kinetic energy of the water per unit mass of one particle, sum u^2/2.
template <int Dim>
Real kineticEnergy(const Water<Dim>& water)
{
    Real sum = 0;
    for (const Vec<Dim>& u : water.u) sum += normSqr(u) / 2;
    return sum;
}

}  // namespace isph
