// SPDX-License-Identifier: GPL-3.0-or-later
// Water, walls and soil of a case against what the scheme needs.
#pragma once
#include "CaseParticles.hpp"
#include "Checklist.hpp"

namespace isph {

/// Distances of the water particles, periods, thickness of soil and walls, holes in walls.
void checkParticles(const CaseSetup& setup, const CaseParticles& particles, const Point& gravity,
                    Checklist& list);

/// Notes zones whose grains (D50) are larger than the spacing.
void noteGrains(const CaseSetup& setup, const std::filesystem::path& caseDir, Checklist& list);

}  // namespace isph
