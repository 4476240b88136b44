// SPDX-License-Identifier: GPL-3.0-or-later
// What createParticles tells of its particles.
#pragma once
#include "CaseSetup.hpp"

#include "case/WallLayers.hpp"

namespace isph {

/// Numbers, volumes beside the exact ones, extents and expected memory of a run.
void report(const CaseSetup& setup, const WaterParticles& water, const WallParticles& walls,
            const SoilParticles& soil);

}  // namespace isph
