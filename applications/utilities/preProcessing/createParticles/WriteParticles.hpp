// SPDX-License-Identifier: GPL-3.0-or-later
// The particle files of the start.
#pragma once
#include "CaseSetup.hpp"

#include "case/WallLayers.hpp"

namespace isph {

/// Writes water.vtp, walls.vtp and soil.vtp into `folder` (made if missing), the last two if they
/// hold anything; files of an earlier run that have no successor are removed. Each file is whole or
/// absent. The water has the porosity that the solver finds at its particles.
void writeParticles(const std::filesystem::path& folder, const CaseSetup& setup,
                    const WaterParticles& water, const WallParticles& walls,
                    const SoilParticles& soil);

}  // namespace isph
