// SPDX-License-Identifier: GPL-3.0-or-later
// What the models of granular soil share: keys and the two groups of porosity and grain size.
#pragma once
#include "porous/PorousModel.hpp"

#include <cassert>

namespace isph {

inline Key porosityKey()
{
    return Key::scalar("porosity", "volume of the pores over volume of the soil").above(0).below(1);
}

inline Key grainDiameterKey()
{
    return Key::scalar("D50", "median grain diameter").units(dims::length).above(0);
}

/// A coefficient of a formula, >= 0, with the value of the literature as its default.
inline Key coefficientKey(const std::string& name, const std::string& preset,
                          const std::string& description)
{
    return Key::scalar(name, description).byDefault(preset).atLeast(0);
}

/// Resistance of grains of size d,  a = A nu (1-eps)^2/(eps^3 d^2),  b = B (1-eps)/(eps^3 d).
/// Every formula of this form is its pair of numbers A and B.                     [theory (4.3)]
inline Resistance grainResistance(Real A, Real B, Real porosity, Real d, Real nu)
{
    assert(porosity > 0 && porosity <= 1);
    return {A * nu * sqr(1 - porosity) / (cube(porosity) * sqr(d)),
            B * (1 - porosity) / (cube(porosity) * d)};
}

}  // namespace isph
