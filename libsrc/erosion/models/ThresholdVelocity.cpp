// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Parallel.hpp"
#include "erosion/ErosionModel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isph {
namespace {

/// Drag, lift, friction and submerged weight of one grain.    [theory (9.1), paper (18), (19)]
///   u^2 = 2 A3 (muF cos theta - sin theta) (rhoS/rho - 1) g d / ((CD + muF CL) A2)
/// theta > 0 where the flow runs downslope, so that one formula is both of the paper's. With
/// muF = tan phi the factor of the slope is sin(phi - theta)/sin(phi) of the level bed. At the
/// angle of repose it vanishes and beyond it the root would be imaginary: minSlopeFactor is its
/// floor. valid   u is the velocity at the grain, half to one diameter above the bed, not the
/// friction
///         velocity that the paper calls it (1.4 times as large for 0.2 mm, 5 times for 10 mm) and
///         not the velocity of a particle of 10 mm. A constant CD is that of coarse grains: 0.2 mm
///         sand at the default 0.4 needs u 4 times as large as with CD(Re).
/// source  paper (18), (19); defaults: sphere A2 = pi/4, A3 = pi/6, tan 33 degrees, quartz
class ThresholdVelocity : public ErosionModel {
public:
    static Schema keys();
    explicit ThresholdVelocity(const Dictionary& dict);

    void threshold(Span<const Real> slopeDownFlow, Real rho, Real g,
                   Span<Real> uLimit) const override
    {
        assert(slopeDownFlow.size() == uLimit.size());
        const Real buoyancy =
            std::max(rhoS_ / rho - 1, 0.0);  // grains that float have no threshold
        const Real scale = 2 * A3_ * buoyancy * g * d_ / ((CD_ + muF_ * CL_) * A2_);
        parallelFor(uLimit.size(), [&](Index i) {
            const Real theta = slopeDownFlow[i];
            const Real grip =
                std::max(muF_ * std::cos(theta) - std::sin(theta), minSlopeFactor_ * muF_);
            uLimit[i] = std::sqrt(scale * grip);
        });
    }

    Real solidDensity() const override { return rhoS_; }
    Real grainDiameter() const override { return d_; }

    std::string formula() const override
    {
        return fmt::format(
            "thresholdVelocity: u^2 = 2 A3 (muF cos(theta) - sin(theta)) (rhoS/rho - 1) g d"
            "/((CD + muF CL) A2), d = {:g} m, rhoS = {:g} kg/m^3, muF = {:g}, CD = {:g}, "
            "CL = {:g}, A2 = {:g}, A3 = {:g}",
            d_, rhoS_, muF_, CD_, CL_, A2_, A3_);
    }

private:
    Real d_, rhoS_, muF_, CD_, CL_, A2_, A3_, minSlopeFactor_;
};

Schema ThresholdVelocity::keys()
{
    return {
        Key::scalar("D50", "d, the median grain diameter").units(dims::length).above(0),
        Key::scalar("solidDensity", "rhoS, the density of the grains")
            .units(dims::density)
            .byDefault("2650")
            .above(0),
        Key::scalar("frictionCoefficient", "muF, the tangent of the angle of repose")
            .byDefault("0.65")
            .above(0),
        Key::scalar("dragCoefficient", "CD of a grain").byDefault("0.4").above(0),
        Key::scalar("liftCoefficient", "CL of a grain").byDefault("0.2").atLeast(0),
        Key::scalar("areaCoefficient", "A2, the grain's cross-section over d^2, pi/4 of a sphere")
            .byDefault("0.78539816339744831")
            .above(0),
        Key::scalar("volumeCoefficient", "A3, the grain's volume over d^3, pi/6 of a sphere")
            .byDefault("0.52359877559829887")
            .above(0),
        Key::scalar("minSlopeFactor",
                    "u^2 on steep slopes is at least this part of that on level ground")
            .byDefault("0.1")
            .atLeast(0)
            .atMost(1)};
}

ThresholdVelocity::ThresholdVelocity(const Dictionary& dict)
    : d_(keys().get<Real>(dict, "D50")),
      rhoS_(keys().get<Real>(dict, "solidDensity")),
      muF_(keys().get<Real>(dict, "frictionCoefficient")),
      CD_(keys().get<Real>(dict, "dragCoefficient")),
      CL_(keys().get<Real>(dict, "liftCoefficient")),
      A2_(keys().get<Real>(dict, "areaCoefficient")),
      A3_(keys().get<Real>(dict, "volumeCoefficient")),
      minSlopeFactor_(keys().get<Real>(dict, "minSlopeFactor"))
{
}

const ErosionModel::Table::Entry<ThresholdVelocity> entry{"thresholdVelocity"};

}  // namespace
}  // namespace isph
