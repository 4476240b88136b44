// SPDX-License-Identifier: GPL-3.0-or-later
// What createParticles reads from a case before it lays particles.
#pragma once
#include "case/Fill.hpp"
#include "kernels/Kernel.hpp"

#include <memory>

namespace isph {

struct CaseSetup {
    CaseGeometry geometry;
    std::vector<ZonePorosity> zones;  ///< in the order of constant/porousZones
    Dictionary porousZones;
    std::unique_ptr<Kernel> kernel;
    Real supportRadius = 0;           ///< of the kernel in the densest soil [m]
    Real clearRadius = 0;             ///< of the kernel in clear water [m]
    Real wallThickness() const { return supportRadius + 0.5 * geometry.spacing; }
};

/// Reads system/particlesDict, boundaryDict, isphSchemes and constant/porousZones of a case; the
/// last three may be missing (no periodic direction; defaults of the schemes; no soil). Loads the
/// libraries of system/controlDict, if there is one.
CaseSetup readCase(const std::filesystem::path& caseDir);

}  // namespace isph
