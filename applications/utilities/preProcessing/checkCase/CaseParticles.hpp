// SPDX-License-Identifier: GPL-3.0-or-later
// The particles that a case starts from.
#pragma once
#include "CaseSetup.hpp"

#include "case/WallLayers.hpp"

namespace isph {

struct CaseParticles {
    bool fromFiles = false;  ///< of 0/; else laid as createParticles would
    WaterParticles water;    ///< of files: positions and velocities
    WallParticles walls;
    SoilParticles soil;
};

/// Reads 0/ if it has water, else lays the particles.
/// errors  those of readParticleFile, fillSoil and fillWater; FatalIOError where 0/ was made for
/// another
///         spacing or dimension than particlesDict has now
CaseParticles particlesOf(const CaseSetup& setup, const std::filesystem::path& caseDir);

}  // namespace isph
