// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity and resistance at the water particles, from the soil particles around them.  [theory (4.10)-(4.14)]
#pragma once
#include "boundaries/PointCloud.hpp"
#include "kernels/Kernel.hpp"
#include "neighbours/CellGrid.hpp"
#include "porous/PorousModel.hpp"

#include <memory>
#include <string>
#include <vector>

namespace isph {

/// One soil zone with its law evaluated once.
struct SoilZone {
    std::string name;
    std::unique_ptr<PorousModel> model;
    Real porosity = 0;        ///< of the intact soil
    Resistance resistance;    ///< a, b of the intact soil
};

/// What the soil means to a water particle.
template <int Dim>
struct PorousState {
    std::vector<Real> porosity;      ///< eps, 1 in clear water
    std::vector<Real> share;         ///< phi = (1 - eps)/(1 - eps_soil), 0 in water, 1 in soil
    std::vector<Real> linear;        ///< a [1/s]
    std::vector<Real> quadratic;     ///< b [1/m]
    std::vector<Real> mobility;      ///< k = eps/C_r(eps)
    std::vector<Vec<Dim>> normal;    ///< grad phi, towards the soil [1/m]; its direction is used
};

template <int Dim>
class PorousField {
public:
    PorousField(std::vector<SoilZone> zones, const Kernel& kernel, const WallCloud<Dim>& walls, Real spacing);

    const std::vector<SoilZone>& zones() const { return zones_; }

    /// Bins the soil particles; again whenever they moved.
    void place(const Soil<Dim>& soil, const PeriodicBox<Dim>& box);

    /// eps, phi, a, b, k and the normal at the points x.
    void evaluate(Span<const Vec<Dim>> x, PorousState<Dim>& state) const;

private:
    struct Sums;
    Sums sumsAt(const Vec<Dim>& x, std::vector<Real>& zoneShare) const;

    std::vector<SoilZone> zones_;
    const Kernel& kernel_;
    const WallCloud<Dim>& walls_;
    Real spacing_, h_, reach_, latticeSum_, sigma_;
    CellGrid<Dim> soilGrid_, wallGrid_;
    std::vector<Vec<Dim>> soilX_;
    std::vector<Real> soilVolume_;
    std::vector<Index> soilZone_;
};

extern template class PorousField<2>;
extern template class PorousField<3>;

}  // namespace isph
