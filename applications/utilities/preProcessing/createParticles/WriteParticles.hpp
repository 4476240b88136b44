// SPDX-License-Identifier: GPL-3.0-or-later
// The particle files of the start.
#pragma once
#include "case/Fill.hpp"
#include "case/WallLayers.hpp"

namespace isph {

/// Writes water.vtp, walls.vtp and soil.vtp into `folder` (made if missing), the last two if they
/// hold anything; files of an earlier run that have no successor are removed. Each file is whole or
/// absent.
void writeParticles(const std::filesystem::path& folder, const CaseGeometry& geometry,
                    const std::vector<ZonePorosity>& zones, const WaterParticles& water,
                    const WallParticles& walls, const SoilParticles& soil);

}  // namespace isph
