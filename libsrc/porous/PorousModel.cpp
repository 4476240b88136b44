// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousModel.hpp"

#include <fmt/core.h>

#include <cmath>

namespace isph {

PorousModel::Table& PorousModel::table()
{
    static Table one;
    return one;
}

std::unique_ptr<PorousModel> PorousModel::select(const Dictionary& zone)
{
    return table().selectOnly(zone);
}

Real PorousModel::inertiaCoefficient(Real porosity) const
{
    const Real addedMass = 0.34;  // van Gent (1995), thesis, Delft; paper (6)
    return 1 + addedMass * (1 - porosity) / porosity;
}

Real PorousModel::inertiaIntegral(Real porosity) const
{
    // Gauss's three points over y = 1/eps: exact where C_r is a polynomial of fourth degree in it;
    // (4.2) is linear.
    const Real middle = (1 / porosity + 1) / 2, half = (1 / porosity - 1) / 2,
               node = std::sqrt(Real(0.6));
    const auto slope = [&](Real y) { return 2 * y * inertiaCoefficient(1 / y); };
    return half *
           (5 * slope(middle - node * half) + 8 * slope(middle) + 5 * slope(middle + node * half)) /
           9;
}

Real permeability(const Resistance& r, Real nu)
{
    return nu / r.linear;
}

Real forchheimerCoefficient(const Resistance& r, Real nu)
{
    return r.quadratic * std::sqrt(permeability(r, nu));
}

std::string describe(const std::string& zone, const PorousModel& model, Real nu)
{
    const Real porosity = model.porosity();
    const Resistance r = model.resistance(porosity, nu);
    return fmt::format(
        "Porous zone {}\n    {}\n"
        "    porosity = {:.4g}, a = {:.4g} [1/s], b = {:.4g} [1/m], K = {:.4g} [m^2], "
        "C = {:.4g}, C_r = {:.4g}",
        zone, model.formula(), porosity, r.linear, r.quadratic, permeability(r, nu),
        forchheimerCoefficient(r, nu), model.inertiaCoefficient(porosity));
}

}  // namespace isph
