// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Permeability.hpp"

#include <fmt/core.h>

#include <cmath>

namespace isph {
namespace {

/// Forchheimer's law with measured coefficients.                          [theory (4.9), paper (4)]
///   a = nu/K  [1/s]      b = C/sqrt(K)  [1/m]
/// OpenFOAM's DarcyForchheimer has d = 1/K and f = 2 C/sqrt(K).
/// source  Forchheimer (1901); C about 0.55, Ward (1964), J. Hydraul. Div. ASCE 90(5), 1-12
class DarcyForchheimer : public PorousModel {
public:
    static Schema keys()
    {
        return {porosityKey(), permeabilityKey(),
                Key::scalar("C", "quadratic resistance, about 0.5 for uniform grains").atLeast(0)};
    }

    explicit DarcyForchheimer(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")),
          K_(keys().get<Real>(dict, "K")),
          C_(keys().get<Real>(dict, "C"))
    {
    }

    Resistance resistance(Real, Real nu) const override { return {nu / K_, C_ / std::sqrt(K_)}; }

    std::string formula() const override
    {
        return fmt::format("darcyForchheimer: a = nu/K, b = C/sqrt(K), K = {:g} m^2, C = {:g}", K_,
                           C_);
    }

private:
    Real K_, C_;
};

const PorousModel::Table::Entry<DarcyForchheimer> entry{"darcyForchheimer"};

}  // namespace
}  // namespace isph
