// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Grains.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Resistance of Akbari's unified equation.                         [theory (4.4), paper (8), (9)]
///   a = alphaC nu (1-eps)^2/(eps^3 D50^2)  [1/s]      b = betaC (1-eps)/(eps^3 D50)  [1/m]
/// that is  K = eps^3 D50^2/(alphaC (1-eps)^2),  C = betaC/(sqrt(alphaC) eps^1.5).
/// Coarse rock hardly feels alphaC; for grains of a few mm and finer it decides, and 1000 may be
/// five times too high: calibrate it with a measured permeability (Liu et al. use 200).
/// source  Akbari (2014), Coastal Eng., doi 10.1016/j.coastaleng.2014.03.004; the values are van
///         Gent's (1995) without his KC term
class Akbari : public PorousModel {
public:
    static Schema keys()
    {
        return {
            porosityKey(), grainDiameterKey(),
            coefficientKey("alphaC", "1000", "linear (viscous) resistance, 200 to 1000").above(0),
            coefficientKey("betaC", "1.1", "quadratic (inertial) resistance, 0.8 to 2.8")};
    }

    explicit Akbari(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")),
          d_(keys().get<Real>(dict, "D50")),
          alphaC_(keys().get<Real>(dict, "alphaC")),
          betaC_(keys().get<Real>(dict, "betaC"))
    {
    }

    Resistance resistance(Real porosity, Real nu) const override
    {
        return grainResistance(alphaC_, betaC_, porosity, d_, nu);
    }

    std::string formula() const override
    {
        return fmt::format(
            "akbari: a = {:g} nu (1 - eps)^2/(eps^3 D50^2), "
            "b = {:g} (1 - eps)/(eps^3 D50), D50 = {:g} m",
            alphaC_, betaC_, d_);
    }

private:
    Real d_, alphaC_, betaC_;
};

const PorousModel::Table::Entry<Akbari> entry{"akbari"};

}  // namespace
}  // namespace isph
