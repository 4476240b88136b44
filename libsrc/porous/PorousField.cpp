// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousField.hpp"

#include "core/LatticeSpline.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kLeastPorosity = 0.02;   // reached only by clumps of released grains
constexpr Real kLeastOpenSpace = 0.1;   // share of a kernel that is not wall, deep in corners

/// Ranks of the zones by their resistance to 1 mm/s: at a face between two soils the gradient of
/// the rank is the normal, as that of phi is at a face to water.                    [theory (4.14)]
std::vector<Real> ranksOf(const std::vector<SoilZone>& zones)
{
    constexpr Real speed = 1e-3, least = 1e-12;
    std::vector<Real> rank;
    for (const SoilZone& zone : zones)
        rank.push_back(std::log10(
            std::max(least, zone.resistance.linear + speed * zone.resistance.quadratic)));
    const Real lowest = rank.empty() ? 0 : *std::min_element(rank.begin(), rank.end());
    for (Real& r : rank) r += 1 - lowest;
    return rank;
}
}  // namespace

std::vector<SoilZone> readZones(const Dictionary& porousZones,
                                const std::vector<std::string>& names)
{
    std::vector<SoilZone> zones;
    for (const std::string& name : names) {
        if (!porousZones.found(name))
            porousZones.fail(name,
                             "The soil zone " + name + " has no entry in constant/porousZones.");
        SoilZone zone;
        zone.name = name;
        zone.model = PorousModel::select(porousZones.subDict(name));
        zone.porosity = zone.model->porosity();
        zones.push_back(std::move(zone));
    }
    return zones;
}

template <int Dim>
PorousField<Dim>::PorousField(std::vector<SoilZone> zones, const WallCloud<Dim>& walls,
                              Real spacing)
    : zones_(std::move(zones)),
      rank_(ranksOf(zones_)),
      spacing_(spacing),
      reach_(latticeSpline::kReach * spacing),
      wallX_(walls.x),
      wallVolume_(walls.volume)
{
    for (Real& V : wallVolume_) V /= Dim == 2 ? sqr(spacing) : cube(spacing);
    wallGrid_.build(wallX_, reach_ / 2);
}

template <int Dim>
void PorousField<Dim>::place(const Soil<Dim>& soil, const PeriodicBox<Dim>& box)
{
    soilX_ = soil.x;
    soilU_ = soil.u;
    soilVolume_ = soil.solidVolume;
    soilZone_.assign(soil.zone.begin(), soil.zone.end());
    released_.assign(soil.released.begin(), soil.released.end());
    anyReleased_ = std::find(released_.begin(), released_.end(), 1) != released_.end();
    for (std::size_t k = 0; k < soil.size() && box.any(); ++k)
        box.forImages(soil.x[k], reach_ + spacing_, [&](const Vec<Dim>& shift) {
            soilX_.push_back(soil.x[k] + shift);
            soilU_.push_back(soil.u[k]);
            soilVolume_.push_back(soil.solidVolume[k]);
            soilZone_.push_back(static_cast<Index>(soil.zone[k]));
            released_.push_back(released_[k]);
        });
    for (Real& V : soilVolume_) V /= Dim == 2 ? sqr(spacing_) : cube(spacing_);
    soilGrid_.build(soilX_, reach_ / 2);
}

/// Points near a place with their weights, in arrays that are used again.
template <int Dim>
struct PorousField<Dim>::Near {
    std::vector<Index> k;
    std::array<std::vector<Real>, Dim> r, M, slope;   ///< in units of d0, along each axis

    void weigh()
    {
        for (int d = 0; d < Dim; ++d) {
            M[d].resize(k.size()), slope[d].resize(k.size());
            for (std::size_t n = 0; n < k.size(); ++n) {
                M[d][n] = latticeSpline::value(r[d][n]);
                slope[d][n] = latticeSpline::slope(r[d][n]);
            }
        }
    }
    Real W(std::size_t n) const
    {
        Real W = 1;
        for (int d = 0; d < Dim; ++d) W *= M[d][n];
        return W;
    }
    Vec<Dim> gradW(std::size_t n) const
    {
        Vec<Dim> grad;
        for (int d = 0; d < Dim; ++d) {
            grad[d] = 1;
            for (int e = 0; e < Dim; ++e) grad[d] *= d == e ? slope[e][n] : M[e][n];
        }
        return grad;
    }
};

template <int Dim>
void PorousField<Dim>::gather(const CellGrid<Dim>& grid, const std::vector<Vec<Dim>>& points,
                              const Vec<Dim>& x, Near& near) const
{
    near.k.clear();
    for (int d = 0; d < Dim; ++d) near.r[d].clear();
    grid.forEachNear(x, reach_, [&](Index k) {
        const Vec<Dim> r = (1 / spacing_) * (x - points[k]);
        for (int d = 0; d < Dim; ++d)
            if (std::abs(r[d]) >= latticeSpline::kReach) return;
        near.k.push_back(k);
        for (int d = 0; d < Dim; ++d) near.r[d].push_back(r[d]);
    });
    near.weigh();
}

template <int Dim>
SoilSums<Dim> PorousField<Dim>::sums(const Vec<Dim>& x, Index except, Near& near,
                                     std::vector<Real>& zoneShare) const
{
    SoilSums<Dim> s;
    std::fill(zoneShare.begin(), zoneShare.end(), Real(0));
    gather(soilGrid_, soilX_, x, near);
    for (std::size_t n = 0; n < near.k.size(); ++n) {
        const Index k = near.k[n];
        if (k == except) continue;
        const Real VW = soilVolume_[k] * near.W(n);
        const Vec<Dim> VgradW = (soilVolume_[k] / spacing_) * near.gradW(n);
        s.solid += VW;
        s.gradSolid += VgradW;
        if (released_[k]) {
            s.flux += VW * soilU_[k];
            continue;
        }
        const Real perSolid = 1 / (1 - zones_[soilZone_[k]].porosity);
        s.share += perSolid * VW;
        zoneShare[soilZone_[k]] += perSolid * VW;
        s.gradShare += perSolid * VgradW;
        s.rank += rank_[soilZone_[k]] * perSolid * VW;
        s.gradRank += rank_[soilZone_[k]] * perSolid * VgradW;
    }
    if (s.solid == 0) return s;
    gather(wallGrid_, wallX_, x, near);
    Real wall = 0;
    Vec<Dim> gradWall;
    for (std::size_t n = 0; n < near.k.size(); ++n) {
        const Real V = wallVolume_[near.k[n]];
        wall += V * near.W(n);
        gradWall += (V / spacing_) * near.gradW(n);
    }
    s.open = std::max(kLeastOpenSpace, 1 - wall);
    s.gradShare += s.share / s.open * gradWall;
    s.gradRank += s.rank / s.open * gradWall;
    s.gradSolid += s.solid / s.open * gradWall;
    return s;
}

template <int Dim>
SoilSums<Dim> PorousField<Dim>::at(const Vec<Dim>& x, Index except) const
{
    thread_local Near near;
    thread_local std::vector<Real> zoneShare;
    zoneShare.resize(zones_.size());
    return sums(x, except, near, zoneShare);
}

/// Where among the zones a point is.
template <int Dim>
struct PorousField<Dim>::Place {
    Index soil;            ///< zone with the largest share
    Real share;            ///< of that zone
    Index zone;            ///< the same, or kClearWater where that has more
    Real sharpPorosity;    ///< of `zone` less the grains of released soil
};

template <int Dim>
auto PorousField<Dim>::placeOf(const SoilSums<Dim>& s, const std::vector<Real>& zoneShare) const
    -> Place
{
    const auto most = std::max_element(zoneShare.begin(), zoneShare.end());
    Place place;
    place.soil = static_cast<Index>(most - zoneShare.begin());
    place.share = *most / s.open;
    place.zone = *most > s.open - s.share ? place.soil : kClearWater;
    Real moving = s.solid;
    for (std::size_t z = 0; z < zones_.size(); ++z)
        moving -= zoneShare[z] * (1 - zones_[z].porosity);
    const Real intact = place.zone == kClearWater ? 1 : zones_[place.zone].porosity;
    place.sharpPorosity = std::max(kLeastPorosity, intact - moving / s.open);
    return place;
}

template <int Dim>
auto PorousField<Dim>::placeAt(const Vec<Dim>& x) const -> Place
{
    thread_local Near near;
    thread_local std::vector<Real> zoneShare;
    zoneShare.resize(zones_.size());
    return placeOf(sums(x, -1, near, zoneShare), zoneShare);
}

template <int Dim>
Real PorousField<Dim>::sharpPorosityAt(const Vec<Dim>& x) const
{
    return placeAt(x).sharpPorosity;
}

template <int Dim>
Index PorousField<Dim>::zoneAt(const Vec<Dim>& x) const
{
    return placeAt(x).zone;
}

template <int Dim>
void PorousField<Dim>::setParticle(const SoilSums<Dim>& s, const std::vector<Real>& zoneShare,
                                   std::size_t i, PorousState<Dim>& state) const
{
    const Real eps = std::max(kLeastPorosity, 1 - s.solid / s.open);
    const Real share = std::min(Real(1), s.share / s.open);
    const Place place = placeOf(s, zoneShare);
    const bool clear = place.zone == kClearWater;
    const Resistance resistance = clear ? Resistance{} : zones_[place.zone].resistance;
    const Real inertia = place.share > 0 ? zones_[place.soil].model->inertiaCoefficient(eps) : 1;
    state.porosity[i] = eps;
    state.sharpPorosity[i] = place.sharpPorosity;
    state.share[i] = share;
    state.zone[i] = place.zone;
    state.depth[i] = latticeSpline::depthOf(clear ? 1 - share : place.share);
    state.linear[i] = resistance.linear;
    state.quadratic[i] = resistance.quadratic;
    state.mobility[i] = eps / inertia;
    state.inertia[i] = place.share > 0 ? zones_[place.soil].model->inertiaIntegral(eps) : 0;
    state.normal[i] = s.gradRank;
    if (anyReleased_) state.solidsFlux[i] = (1 / s.open) * s.flux;
}

template <int Dim>
void PorousField<Dim>::evaluate(Span<const Vec<Dim>> x, PorousState<Dim>& state) const
{
    const std::size_t n = x.size();
    state.porosity.resize(n), state.sharpPorosity.resize(n), state.share.resize(n),
        state.zone.resize(n), state.depth.resize(n);
    state.linear.resize(n), state.quadratic.resize(n), state.mobility.resize(n),
        state.normal.resize(n);
    state.inertia.resize(n);
    state.solidsFlux.resize(anyReleased_ ? n : 0);
#pragma omp parallel
    {
        Near near;
        std::vector<Real> zoneShare(zones_.size());
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i)
            setParticle(sums(x[i], -1, near, zoneShare), zoneShare, static_cast<std::size_t>(i),
                        state);
    }
}

template class PorousField<2>;
template class PorousField<3>;

}  // namespace isph
