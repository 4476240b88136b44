// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/PointCloud.hpp"

#include "neighbours/CellGrid.hpp"

#include <cmath>

namespace isph {

namespace {
constexpr Real kWetFrom = 0.95, kWetTo = 0.65;  // marker to water in local spacings  [theory (6.5)]

template <int Dim>
Real root(Real a) { return Dim == 2 ? std::sqrt(a) : std::cbrt(a); }
}  // namespace

template <int Dim>
WallCloud<Dim>::WallCloud(const Walls<Dim>& walls, const PeriodicBox<Dim>& box, Real reach)
    : x(walls.x), normal(walls.normal), depth(walls.depth), volume(walls.volume), wall(walls.wall)
{
    owner.resize(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) owner[k] = static_cast<Index>(k);
    if (!box.any()) return;
    for (Index k = 0; k < static_cast<Index>(walls.size()); ++k)
        box.forImages(walls.x[k], reach, [&](const Vec<Dim>& shift) {
            x.push_back(walls.x[k] + shift);
            normal.push_back(walls.normal[k]);
            depth.push_back(walls.depth[k]);
            volume.push_back(walls.volume[k]);
            wall.push_back(walls.wall[k]);
            owner.push_back(k);
        });
}

template <int Dim>
void layPoints(const Water<Dim>& water, Span<const Real> porosity, const WallCloud<Dim>& walls,
               const PeriodicBox<Dim>& box, Real spacing, Real h0, Real support,
               Points<Dim>& points)
{
    const Index n = static_cast<Index>(water.size());
    const std::size_t all = water.size() + static_cast<std::size_t>(points.images()) + walls.size();
    points.water = n;
    if (points.x.capacity() < all)   // grown, they would take twice the room
        points.x = std::vector<Vec<Dim>>(), points.owner = std::vector<Index>();
    points.x.reserve(all), points.owner.reserve(all);
    points.x.resize(n), points.owner.resize(n);
    parallelFor(n, [&](Index i) { points.x[i] = water.x[i], points.owner[i] = i; });
    if (box.any()) {
        const auto h = [&](Index i) { return h0 / root<Dim>(porosity[i]); };
        const Real largestH = orderedMax(n, h0, h);
        box.requireLength(support * largestH);
        for (Index i = 0; i < n; ++i)
            box.forImages(water.x[i], support * largestH, [&](const Vec<Dim>& shift) {
                points.x.push_back(water.x[i] + shift);
                points.owner.push_back(i);
            });
    }
    points.fluid = static_cast<Index>(points.x.size());
    points.x.insert(points.x.end(), walls.x.begin(), walls.x.end());
    points.owner.insert(points.owner.end(), walls.owner.begin(), walls.owner.end());
    points.volume.resize(points.x.size());
    points.h.resize(points.x.size());
    const Real cell = Dim == 2 ? sqr(spacing) : cube(spacing);
    parallelFor(points.x.size(), [&](Index k) {
        const bool fluid = k < points.fluid;
        const Real eps = fluid ? porosity[points.owner[k]] : 1;
        points.volume[k] = fluid ? cell / eps : walls.volume[k - points.fluid];
        points.h[k] = h0 / root<Dim>(eps);
    });
}

template <int Dim>
void dryWalls(const WallCloud<Dim>& walls, Real spacing, Real h0, Points<Dim>& points)
{
    const Index fluid = points.fluid;
    if (walls.size() == 0) return;
    const Real largestH = orderedMax(fluid, h0, [&](Index i) { return points.h[i]; });
    const Real reach = kWetFrom * spacing * largestH / h0;
    CellGrid<Dim> grid;
    grid.build(Span<const Vec<Dim>>(points.x.data(), fluid), std::max(reach, 2 * spacing));
    parallelFor(walls.size(), [&](Index k) {
        const Vec<Dim> marker =
            walls.x[k] + (walls.depth[k] + Real(0.5) * spacing) * walls.normal[k];
        Real distance = kWetFrom;                // in local spacings
        Real nearest = reach * reach, h = h0;   // the nearest water lends its h to the wall
        grid.forEachNear(marker, reach, [&](Index j) {
            const Real r2 = normSqr(marker - points.x[j]);
            distance = std::min(distance, std::sqrt(r2) * h0 / (spacing * points.h[j]));
            if (r2 < nearest) nearest = r2, h = points.h[j];
        });
        const Real wet = std::min(Real(1), (kWetFrom - distance) / (kWetFrom - kWetTo));
        points.volume[fluid + k] = wet * walls.volume[k];
        points.h[fluid + k] = h;
    });
}

template struct WallCloud<2>;
template struct WallCloud<3>;
template void layPoints(const Water<2>&, Span<const Real>, const WallCloud<2>&,
                        const PeriodicBox<2>&, Real, Real, Real, Points<2>&);
template void layPoints(const Water<3>&, Span<const Real>, const WallCloud<3>&,
                        const PeriodicBox<3>&, Real, Real, Real, Points<3>&);
template void dryWalls(const WallCloud<2>&, Real, Real, Points<2>&);
template void dryWalls(const WallCloud<3>&, Real, Real, Points<3>&);

}  // namespace isph
