// SPDX-License-Identifier: GPL-3.0-or-later
#include "turbulence/TurbulenceModel.hpp"

#include <algorithm>

namespace isph {
namespace {

/// No eddy viscosity: nuT = 0.
class Laminar : public TurbulenceModel {
public:
    static Schema keys() { return {}; }
    explicit Laminar(const Dictionary&) {}

    bool active() const override { return false; }

    void eddyViscosity(Span<const Real>, Span<const Real>, Real, Span<Real> nuT) const override
    {
        std::fill(nuT.begin(), nuT.end(), 0.0);
    }

    std::string formula() const override { return "laminar: nuT = 0"; }
};

const TurbulenceModel::Table::Entry<Laminar> entry{"laminar"};

}  // namespace
}  // namespace isph
