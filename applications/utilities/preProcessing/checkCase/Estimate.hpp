// SPDX-License-Identifier: GPL-3.0-or-later
// Memory and time that a run is expected to take.
#pragma once
#include "CaseParticles.hpp"

namespace isph {

/// Prints both. Steps follow from controlDict: deltaT, or with adjustTimeStep maxCo at the speed
/// sqrt(2 g H) of water that falls through its own height, or at the speed it has.
void printEstimate(const CaseSetup& setup, const CaseParticles& particles, const Point& gravity,
                   const std::filesystem::path& caseDir);

}  // namespace isph
