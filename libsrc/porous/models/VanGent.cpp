// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Grains.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Resistance of rock in oscillating flow.                                          [theory (4.5)]
///   a = alphaC nu (1-eps)^2/(eps^3 D50^2)  [1/s]
///   b = betaC (1 + 7.5/KC) (1-eps)/(eps^3 D50)  [1/m]
/// KC = U T/(eps D50), the Keulegan-Carpenter number of the waves; its term vanishes in steady flow
/// (large KC), where the model is akbari. Van Gent's diameter is the nominal one, D_n50 = 0.84 D50.
/// source  van Gent (1995), thesis, Delft; form as in waves2Foam and olaFlow
class VanGent : public PorousModel {
public:
    static Schema keys()
    {
        return {porosityKey(), grainDiameterKey(),
                coefficientKey("alphaC", "1000", "linear (viscous) resistance").above(0),
                coefficientKey("betaC", "1.1", "quadratic (inertial) resistance"),
                Key::scalar("KC", "Keulegan-Carpenter number of the flow in the pores").above(0)};
    }

    explicit VanGent(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")),
          d_(keys().get<Real>(dict, "D50")),
          alphaC_(keys().get<Real>(dict, "alphaC")),
          betaC_(keys().get<Real>(dict, "betaC")),
          KC_(keys().get<Real>(dict, "KC"))
    {
    }

    Resistance resistance(Real porosity, Real nu) const override
    {
        return grainResistance(alphaC_, betaC_ * (1 + 7.5 / KC_), porosity, d_, nu);
    }

    std::string formula() const override
    {
        return fmt::format(
            "vanGent: a = {:g} nu (1 - eps)^2/(eps^3 D50^2), b = {:g} (1 + 7.5/KC) "
            "(1 - eps)/(eps^3 D50), KC = {:g}, D50 = {:g} m",
            alphaC_, betaC_, KC_, d_);
    }

private:
    Real d_, alphaC_, betaC_, KC_;
};

const PorousModel::Table::Entry<VanGent> entry{"vanGent"};

}  // namespace
}  // namespace isph
