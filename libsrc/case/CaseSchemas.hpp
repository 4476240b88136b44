// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a case's files, declared once for those that read them and those that check them.
#pragma once
#include "dictionary/Schema.hpp"

#include <array>

namespace isph {

Schema particlesKeys();      ///< system/particlesDict
Schema domainKeys();         ///< its domain
Schema wallKeys();           ///< of a region of walls, beside the keys of its shape
Schema waterKeys();          ///< of a region of water, likewise
Schema soilKeys();           ///< of a region of soil, likewise
Schema boundaryKeys();       ///< system/boundaryDict
Schema wallConditionKeys();  ///< one wall of it
Schema gravityKeys();        ///< constant/g
Schema transportKeys();      ///< constant/transportProperties

/// g + bodyForce of constant/g [m/s2]. In two dimensions a z is refused.
Vector3 readForce(const Dictionary& gravity, int dimension);

/// The directions that system/boundaryDict calls periodic. In two dimensions z is refused.
std::array<bool, 3> readPeriodic(const Dictionary& boundaryDict, int dimension);

}  // namespace isph
