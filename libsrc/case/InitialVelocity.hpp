// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities of water at the start, from constants or expressions.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

/// The entry `velocity` of a water region: (1 0 0) or ("sin(pi*x)" "0" "0"), expressions of x, y, z
/// [m] in m/s; empty where it is absent. Throws FatalIOError with muParser's message.
VelocityField readVelocity(const Dictionary& dict);

}  // namespace isph
