// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the models that take a measured permeability.
#pragma once
#include "porous/models/Grains.hpp"

namespace isph {

inline Key permeabilityKey()
{
    return Key::scalar("K", "intrinsic permeability, k nu/g of the hydraulic conductivity k [m/s]")
        .units(dims::area)
        .above(0);
}

}  // namespace isph
