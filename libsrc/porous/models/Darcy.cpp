// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Permeability.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Darcy's law with a measured permeability K.                            [theory (4.8), paper (3)]
///   a = nu/K  [1/s]      b = 0
/// Valid while the grains' Reynolds number v_D D50/nu stays below 1 to 10: sand, not rubble.
/// source  Darcy (1856)
class Darcy : public PorousModel {
public:
    static Schema keys() { return {porosityKey(), permeabilityKey()}; }

    explicit Darcy(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")), K_(keys().get<Real>(dict, "K"))
    {
    }

    Resistance resistance(Real, Real nu) const override { return {nu / K_, 0}; }

    std::string formula() const override
    {
        return fmt::format("darcy: a = nu/K, b = 0, K = {:g} m^2", K_);
    }

private:
    Real K_;
};

const PorousModel::Table::Entry<Darcy> entry{"darcy"};

}  // namespace
}  // namespace isph
