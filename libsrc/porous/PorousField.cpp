// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousField.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kLeastPorosity = 0.02;   // reached only by clumps of released grains
constexpr Real kLeastOpenSpace = 0.1;   // share of a kernel that is not wall, deep in corners
constexpr Real kSoilWidth = 1.5;        // h of the soil sums in d0, for a support of 2 h

/// Drag factor across a soil surface: no thin tail of drag reaches into the water above it.
Real clampedShare(Real share)
{
    return std::clamp((share - kClampCentre) / kClampWidth + Real(0.5), Real(0), Real(1));
}

/// Depth into the bed in d0. Across a flat surface phi is close to a normal distribution of standard
/// deviation 0.79 d0; its logistic twin is inverted, as far as phi still tells a depth. [theory (4.15)]
Real depthOf(Real share)
{
    constexpr Real width = 0.79 / 1.7, most = 2.2;
    const Real bounded = std::clamp(share, Real(1e-3), Real(1 - 1e-3));
    return std::clamp(width * std::log(bounded / (1 - bounded)), -most, most);
}
/// Ranks of the zones by their resistance to 1 mm/s: at a face between two soils the gradient of the rank
/// is the normal, as that of phi is at a face to water.                                    [theory (4.14)]
std::vector<Real> ranksOf(const std::vector<SoilZone>& zones)
{
    constexpr Real speed = 1e-3, least = 1e-12;
    std::vector<Real> rank;
    for (const SoilZone& zone : zones)
        rank.push_back(std::log10(std::max(least, zone.resistance.linear + speed * zone.resistance.quadratic)));
    const Real lowest = rank.empty() ? 0 : *std::min_element(rank.begin(), rank.end());
    for (Real& r : rank) r += 1 - lowest;
    return rank;
}
}  // namespace

std::vector<SoilZone> readZones(const Dictionary& porousZones, const std::vector<std::string>& names)
{
    std::vector<SoilZone> zones;
    for (const std::string& name : names) {
        if (!porousZones.found(name))
            porousZones.fail(name, "The soil zone " + name + " has no entry in constant/porousZones.");
        SoilZone zone;
        zone.name = name;
        zone.model = PorousModel::select(porousZones.subDict(name));
        zone.porosity = zone.model->porosity();
        zones.push_back(std::move(zone));
    }
    return zones;
}

/// Points near a place with their kernel values, in arrays that are used again.
template <int Dim>
struct PorousField<Dim>::Near {
    std::vector<Index> j;
    std::vector<Vec<Dim>> r;
    std::vector<Real> q, w, slope;
};

template <int Dim>
PorousField<Dim>::PorousField(std::vector<SoilZone> zones, const Kernel& kernel,
                              const WallCloud<Dim>& walls, Real spacing)
    : zones_(std::move(zones)),
      rank_(ranksOf(zones_)),
      kernel_(kernel),
      h_(kSoilWidth * spacing * 2 / kernel.supportRadius()),
      reach_(kernel.supportRadius() * h_),
      spacing_(spacing),
      wallX_(walls.x),
      wallVolume_(walls.volume)
{
    const Real power = Dim == 2 ? sqr(h_) : cube(h_);
    scaleW_ = kernel.normalisation(Dim) / power / latticeSum(kernel, Dim, h_ / spacing);
    scaleGrad_ = scaleW_ / sqr(h_);
    wallGrid_.build(wallX_, reach_);
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
    soilGrid_.build(soilX_, reach_);
}

template <int Dim>
void PorousField<Dim>::gather(const CellGrid<Dim>& grid, const std::vector<Vec<Dim>>& points,
                              const Vec<Dim>& x, Near& near) const
{
    near.j.clear(), near.r.clear(), near.q.clear();
    grid.forEachNear(x, reach_, [&](Index k) {
        const Vec<Dim> r = x - points[k];
        const Real r2 = normSqr(r);
        if (r2 >= sqr(reach_)) return;
        near.j.push_back(k), near.r.push_back(r), near.q.push_back(std::sqrt(r2) / h_);
    });
    near.w.resize(near.q.size()), near.slope.resize(near.q.size());
    kernel_.evaluate(near.q, near.w, near.slope);
}

template <int Dim>
SoilSums<Dim> PorousField<Dim>::sums(const Vec<Dim>& x, Index except, Near& near,
                                     std::vector<Real>& zoneShare) const
{
    SoilSums<Dim> s;
    std::fill(zoneShare.begin(), zoneShare.end(), Real(0));
    gather(soilGrid_, soilX_, x, near);
    for (std::size_t n = 0; n < near.j.size(); ++n) {
        const Index k = near.j[n];
        if (k == except) continue;
        const Real VW = soilVolume_[k] * near.w[n] * scaleW_;
        const Vec<Dim> VgradW = (soilVolume_[k] * near.slope[n] * scaleGrad_) * near.r[n];
        s.solid += VW;
        s.gradSolid += VgradW;
        if (released_[k]) {
            s.divergence += dot(soilU_[k], VgradW);
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
    for (std::size_t n = 0; n < near.j.size(); ++n) {
        const Real V = wallVolume_[near.j[n]];
        wall += V * near.w[n] * scaleW_;
        gradWall += (V * near.slope[n] * scaleGrad_) * near.r[n];
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
    Near near;
    std::vector<Real> zoneShare(zones_.size());
    return sums(x, except, near, zoneShare);
}

template <int Dim>
void PorousField<Dim>::setParticle(const SoilSums<Dim>& s, const std::vector<Real>& zoneShare,
                                   std::size_t i, PorousState<Dim>& state) const
{
    const Real eps = std::max(kLeastPorosity, 1 - s.solid / s.open);
    const Real share = std::min(Real(1), s.share / s.open);
    Real a = 0, b = 0, inertia = 1;
    if (share > 0) {
        const Real drag = clampedShare(share) / s.share;
        Real dominant = 0;
        for (std::size_t z = 0; z < zones_.size(); ++z) {
            a += drag * zoneShare[z] * zones_[z].resistance.linear;
            b += drag * zoneShare[z] * zones_[z].resistance.quadratic;
            if (zoneShare[z] > dominant) {
                dominant = zoneShare[z];
                inertia = zones_[z].model->inertiaCoefficient(eps);
            }
        }
    }
    state.porosity[i] = eps;
    state.share[i] = share;
    state.depth[i] = depthOf(share);
    state.linear[i] = a;
    state.quadratic[i] = b;
    state.mobility[i] = eps / inertia;
    state.normal[i] = s.gradRank;
    if (anyReleased_) state.solidsDivergence[i] = s.divergence;
}

template <int Dim>
void PorousField<Dim>::evaluate(Span<const Vec<Dim>> x, PorousState<Dim>& state) const
{
    const std::size_t n = x.size();
    state.porosity.resize(n), state.share.resize(n), state.depth.resize(n), state.linear.resize(n);
    state.quadratic.resize(n), state.mobility.resize(n), state.normal.resize(n);
    state.solidsDivergence.resize(anyReleased_ ? n : 0);
#pragma omp parallel
    {
        Near near;
        std::vector<Real> zoneShare(zones_.size());
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i)
            setParticle(sums(x[i], -1, near, zoneShare), zoneShare, static_cast<std::size_t>(i), state);
    }
}

template class PorousField<2>;
template class PorousField<3>;

}  // namespace isph
