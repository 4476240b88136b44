// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity and resistance at the water particles, from the soil particles around them.
//                                                                          [theory (4.10)-(4.14)]
#pragma once
#include "boundaries/PointCloud.hpp"
#include "neighbours/CellGrid.hpp"
#include "porous/PorousModel.hpp"

#include <memory>
#include <string>
#include <vector>

namespace isph {

/// Number of the clear water among the zones.
inline constexpr Index kClearWater = -1;

/// One soil zone with its law evaluated once.
struct SoilZone {
    std::string name;
    std::unique_ptr<PorousModel> model;
    Real porosity = 0;       ///< of the intact soil
    Resistance resistance;   ///< a, b of the intact soil
};

/// The zones of constant/porousZones in the order of their names in a soil file; resistances are
/// left to whoever knows the water.   errors  FatalIOError: a zone has no entry, or a wrong one
std::vector<SoilZone> readZones(const Dictionary& porousZones,
                                const std::vector<std::string>& names);

/// What the soil means to a water particle.
template <int Dim>
struct PorousState {
    std::vector<Real> porosity;     ///< eps, 1 in clear water
    /// With faces as sharp as they are, PorousField::sharpPorosityAt
    std::vector<Real> sharpPorosity;
    std::vector<Real> share;        ///< phi of the bed: 0 in water, 1 in soil
    std::vector<Index> zone;        ///< with the largest share, or kClearWater
    std::vector<Real> depth;        ///< beneath the nearest face of that zone, in d0
    std::vector<Real> linear;       ///< a of the zone [1/s]
    std::vector<Real> quadratic;    ///< b of the zone [1/m]
    std::vector<Real> mobility;     ///< k = eps/C_r(eps)
    /// Chi, 0 in clear water                               [theory (3.13)]
    std::vector<Real> inertia;
    /// Grad psi, towards the soil that resists more [1/m]; its direction is used
    std::vector<Vec<Dim>> normal;
    /// V_s of released soil [m/s]; empty without   [theory (9.5)]
    std::vector<Vec<Dim>> solidsFlux;
};

/// Sums over soil and walls at a point.
template <int Dim>
struct SoilSums {
    Real solid = 0;             ///< volume of grains per volume, bed and released
    Real share = 0;             ///< of the bed, in units of intact soil
    Real open = 1;              ///< share of the kernel that no wall fills
    Vec<Dim> flux{};            ///< v_s, volume flux of released soil [m/s]
    Real rank = 0;              ///< psi: shares of the zones, each times its rank
    Vec<Dim> gradShare{}, gradSolid{}, gradRank{};   ///< [1/m]
};

template <int Dim>
class PorousField {
public:
    PorousField(std::vector<SoilZone> zones, const WallCloud<Dim>& walls, Real spacing);

    const std::vector<SoilZone>& zones() const { return zones_; }

    /// Bins the soil particles; again whenever they moved.
    void place(const Soil<Dim>& soil, const PeriodicBox<Dim>& box);

    /// eps, phi, a, b, k and the normal at the points x. Soil goes on behind walls: the sums are
    /// divided by the share of the kernel that is not wall.
    void evaluate(Span<const Vec<Dim>> x, PorousState<Dim>& state) const;

    /// Porosity at one point with faces as sharp as they are: that of the zone with the largest
    /// share, less the grains of released soil.
    Real sharpPorosityAt(const Vec<Dim>& x) const;

    /// Zone with the largest share at one point, or kClearWater.
    Index zoneAt(const Vec<Dim>& x) const;

    /// The sums at one point, without the soil particle `except` (-1: with all).
    SoilSums<Dim> at(const Vec<Dim>& x, Index except) const;

private:
    struct Place;
    Place placeOf(const SoilSums<Dim>& s, const std::vector<Real>& zoneShare) const;
    Place placeAt(const Vec<Dim>& x) const;
    struct Near;
    SoilSums<Dim> sums(const Vec<Dim>& x, Index except, Near& near,
                       std::vector<Real>& zoneShare) const;
    void gather(const CellGrid<Dim>& grid, const std::vector<Vec<Dim>>& points, const Vec<Dim>& x,
                Near& near) const;
    void setParticle(const SoilSums<Dim>& s, const std::vector<Real>& zoneShare, std::size_t i,
                     PorousState<Dim>& state) const;

    std::vector<SoilZone> zones_;
    /// Of the zones: 1 for the least resistance, +1 for each tenfold of it
    std::vector<Real> rank_;
    Real spacing_, reach_;
    CellGrid<Dim> soilGrid_, wallGrid_;
    std::vector<Vec<Dim>> wallX_, soilX_, soilU_;
    std::vector<Real> wallVolume_, soilVolume_;   ///< in units of d0^D
    std::vector<Index> soilZone_;
    std::vector<char> released_;
    bool anyReleased_ = false;
};

extern template class PorousField<2>;
extern template class PorousField<3>;

}  // namespace isph
