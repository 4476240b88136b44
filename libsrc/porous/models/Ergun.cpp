// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/models/Grains.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Resistance of a packed bed of round grains.                                      [theory (4.6)]
///   a = 150 nu (1-eps)^2/(eps^3 D50^2)  [1/s]      b = 1.75 (1-eps)/(eps^3 D50)  [1/m]
/// Its slow limit is the Blake-Kozeny permeability K = eps^3 D50^2/(150 (1-eps)^2).
/// source  Ergun (1952), Chem. Eng. Prog. 48(2), 89-94; Soulsby (1997), table 6
class Ergun : public PorousModel {
public:
    static Schema keys() { return {porosityKey(), grainDiameterKey()}; }

    explicit Ergun(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")), d_(keys().get<Real>(dict, "D50"))
    {
    }

    Resistance resistance(Real porosity, Real nu) const override
    {
        return grainResistance(150, 1.75, porosity, d_, nu);
    }

    std::string formula() const override
    {
        return fmt::format(
            "ergun: a = 150 nu (1 - eps)^2/(eps^3 D50^2), "
            "b = 1.75 (1 - eps)/(eps^3 D50), D50 = {:g} m",
            d_);
    }

private:
    Real d_;
};

const PorousModel::Table::Entry<Ergun> entry{"ergun"};

}  // namespace
}  // namespace isph
