// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Grains.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Resistance of natural sand and gravel.                                           [theory (4.7)]
///   a = alpha nu (1-eps)^3/(eps^2 D50^2)  [1/s]      b = beta (1-eps)/(eps^3 D50)  [1/m]
/// Mind the powers of a: akbari's alphaC of the same a is alpha eps (1-eps), about 240.
/// source  Engelund (1953), Trans. Danish Acad. Techn. Sci. 3; values from Soulsby (1997), table 6
class Engelund : public PorousModel {
public:
    static Schema keys()
    {
        return {
            porosityKey(), grainDiameterKey(),
            coefficientKey("alpha", "1000", "linear (viscous) resistance, 780 to 1500").above(0),
            coefficientKey("beta", "2.8", "quadratic (inertial) resistance, 1.8 to 3.6")};
    }

    explicit Engelund(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")),
          d_(keys().get<Real>(dict, "D50")),
          alpha_(keys().get<Real>(dict, "alpha")),
          beta_(keys().get<Real>(dict, "beta"))
    {
    }

    Resistance resistance(Real porosity, Real nu) const override
    {
        return grainResistance(alpha_ * porosity * (1 - porosity), beta_, porosity, d_, nu);
    }

    std::string formula() const override
    {
        return fmt::format(
            "engelund: a = {:g} nu (1 - eps)^3/(eps^2 D50^2), "
            "b = {:g} (1 - eps)/(eps^3 D50), D50 = {:g} m",
            alpha_, beta_, d_);
    }

private:
    Real d_, alpha_, beta_;
};

const PorousModel::Table::Entry<Engelund> entry{"engelund"};

}  // namespace
}  // namespace isph
