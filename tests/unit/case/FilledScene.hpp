// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that are filled from their text.
#pragma once
#include "Scene.hpp"

namespace isph::test {

inline const std::vector<ZonePorosity> zones{{"sand", 0.4}, {"rubble", 0.49}};

struct FilledScene {
    CaseGeometry g;
    WallParticles walls;
    SoilParticles soil;
    WaterParticles water;

    explicit FilledScene(const std::string& text, const std::string& periodic = "")
        : g(geometryOf(text, periodic)),
          walls(layWalls(g, 4 * g.spacing)),
          soil(fillSoil(g, zones)),
          water(fillWater(g, zones, walls, soil))
    {
    }
    /// Particles of the part, which the report lists.
    std::int64_t count(const std::string& region, const std::string& zone) const
    {
        for (const FilledPart& part : water.parts)
            if (part.region == region && part.zone == zone) return part.count;
        return -1;
    }
    /// Water and walls: sum_j V_j W_ij at each water particle, V_j = d0^D/eps_j and h_ij the mean
    /// of h = 1.5 d0/eps^(1/D), over the sum of a lattice.
    std::vector<Real> kernelSums() const
    {
        const SoilField field(g, soil, walls);
        const PackingKernel kernel{g.dimension};
        const PeriodicPoints all(g, water.x, 6 * g.spacing);
        const PointGrid near(3 * g.spacing, all.x), nearWalls(3 * g.spacing, walls.x);
        std::vector<Real> h, volume, sums;
        for (const Point& x : water.x) {
            volume.push_back(g.cellVolume() / field.porosity(x));
            h.push_back(1.5 * std::pow(volume.back(), 1.0 / g.dimension));
        }
        Real lattice = 0;
        for (int i = -3; i <= 3; ++i)
            for (int j = -3; j <= 3; ++j)
                lattice += kernel.w(std::hypot(i, j), 1.5);  // in two dimensions
        for (std::size_t i = 0; i < water.x.size(); ++i) {
            Real sum = 0;
            near.forEachWithin(water.x[i], 6 * g.spacing, [&](Index k, const Point& r) {
                const Index j = all.owner[k];
                sum += volume[j] * kernel.w(norm(r), 0.5 * (h[i] + h[j]));
            });
            nearWalls.forEachWithin(water.x[i], 2 * h[i], [&](Index k, const Point& r) {
                sum += walls.volume[k] * kernel.w(norm(r), h[i]);
            });
            sums.push_back(sum / lattice);
        }
        return sums;
    }
};

inline std::string tank(const std::string& spacing, const std::string& rest)
{
    return "spacing " + spacing +
           "; dimension 2; domain { min (0 0 0); max (1 0.6 0); }"
           "walls { tank { type box; min (0 0 0); max (1 0.6 0); open (top); } } " +
           rest;
}

inline std::string box(const std::string& name, const std::string& min, const std::string& max,
                       const std::string& more = "")
{
    return name + " { type box; min (" + min + "); max (" + max + "); " + more + " }";
}

}  // namespace isph::test
