// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Parallel.hpp"
#include "turbulence/TurbulenceModel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace isph {
namespace {

/// Eddies smaller than the spacing, in equilibrium with the strain they see.  [theory (8.1), (8.2)]
///   nuT = (Cs d0)^2 |S| f(eps)                                              [m2/s]
///   f = t^2 (3 - 2t),   t = clamp((eps - porosityOff)/(1 - porosityOff), 0, 1)
/// f is 1 in clear water, 0 in soil up to the porosity porosityOff, and falls smoothly over the
/// outer part of the layer over which the porosity of the particles does.
/// source  Smagorinsky (1963), Mon. Weather Rev. 91(3), 99-164; Cs 0.1 to 0.2
class Smagorinsky : public TurbulenceModel {
public:
    static Schema keys()
    {
        return {Key::scalar("Cs", "Smagorinsky constant, 0.1 to 0.2")
                    .byDefault("0.15")
                    .atLeast(0)
                    .atMost(1),
                Key::scalar("porosityOff", "porosity at and below which there is no eddy viscosity")
                    .byDefault("0.9")
                    .atLeast(0)
                    .below(1)};
    }

    explicit Smagorinsky(const Dictionary& dict)
        : Cs_(keys().get<Real>(dict, "Cs")), porosityOff_(keys().get<Real>(dict, "porosityOff"))
    {
    }

    bool active() const override { return Cs_ > 0; }

    void eddyViscosity(Span<const Real> strainRate, Span<const Real> porosity, Real spacing,
                       Span<Real> nuT) const override
    {
        assert(strainRate.size() == nuT.size() && porosity.size() == nuT.size());
        const Real mixingLength2 = sqr(Cs_ * spacing), width = 1 - porosityOff_;
        parallelFor(nuT.size(), [&](Index i) {
            const Real t = std::clamp((porosity[i] - porosityOff_) / width, 0.0, 1.0);
            nuT[i] = mixingLength2 * strainRate[i] * sqr(t) * (3 - 2 * t);
        });
    }

    std::string formula() const override
    {
        return fmt::format("Smagorinsky: nuT = ({:g} d0)^2 |S|, falling to 0 at porosity {:g}", Cs_,
                           porosityOff_);
    }

private:
    Real Cs_, porosityOff_;
};

const TurbulenceModel::Table::Entry<Smagorinsky> entry{"Smagorinsky"};

}  // namespace
}  // namespace isph
