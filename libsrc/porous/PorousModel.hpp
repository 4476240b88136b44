// SPDX-License-Identifier: GPL-3.0-or-later
// Resistance of the soil to seepage, a v_D + b |v_D| v_D per unit mass of water.     [theory (4.1)]
#pragma once
#include "core/Types.hpp"
#include "selection/ModelTable.hpp"

#include <string>

namespace isph {

struct Resistance {
    Real linear = 0;     ///< a [1/s]
    Real quadratic = 0;  ///< b [1/m]
};

/// The law of one soil zone. It is asked once per zone; particles scale its values by the local
/// share of soil, so no model is called per particle.
class PorousModel {
public:
    static constexpr const char* family = "porousModel";
    using Table = ModelTable<PorousModel>;
    static Table& table();
    /// The model that a zone's dictionary names: porousModel <type>; <type>Coeffs {...}.
    static std::unique_ptr<PorousModel> select(const Dictionary& zone);

    virtual ~PorousModel() = default;

    /// a and b of soil of the given porosity, 0 < porosity <= 1, in water of kinematic viscosity nu
    /// [m2/s]. Models of grains give 0 at porosity 1; measured permeabilities keep their value.
    virtual Resistance resistance(Real porosity, Real nu) const = 0;
    /// The formula in one line with its coefficients, for the log: "ergun: a = 150 nu ...".
    virtual std::string formula() const = 0;
    /// Porosity of the intact soil, 0 < eps < 1.
    Real porosity() const { return porosity_; }
    /// C_r = 1 + 0.34 (1 - eps)/eps, the inertia coefficient.            [theory (4.2), paper (6)]
    virtual Real inertiaCoefficient(Real porosity) const;

    /// chi = integral of C_r d(1/eps^2) from clear water to this porosity: times v^2/2 what a flow
    /// v loses of its p/rho0 on the way into the pores.                             [theory (3.13)]
    Real inertiaIntegral(Real porosity) const;

protected:
    explicit PorousModel(Real porosity) : porosity_(porosity) {}

private:
    Real porosity_;
};

/// K = nu/a [m2], the intrinsic permeability of Darcy's law; infinite where a = 0.
Real permeability(const Resistance& r, Real nu);
/// C = b sqrt(K), the coefficient of  nu/K v_D + C/sqrt(K) |v_D| v_D.        [paper (4)]
Real forchheimerCoefficient(const Resistance& r, Real nu);

/// Three lines for the log: the zone, its formula, and its porosity, a, b, K, C and C_r in water of
/// kinematic viscosity nu [m2/s].
std::string describe(const std::string& zone, const PorousModel& model, Real nu);

}  // namespace isph
