// SPDX-License-Identifier: GPL-3.0-or-later
// What createParticles reads from a case before it lays particles.
#pragma once
#include "case/Fill.hpp"

namespace isph {

struct CaseSetup {
    CaseGeometry geometry;
    std::vector<ZonePorosity> zones;   ///< in the order of constant/porousZones
    Real supportRadius = 0;            ///< of the kernel in the densest soil [m]
    Real wallThickness() const { return supportRadius + 0.5 * geometry.spacing; }
};

/// Reads system/particlesDict, boundaryDict, isphSchemes and constant/porousZones of a case; the last
/// three may be missing (no periodic direction; wendlandC2 with h = 1.5 d0; no soil).
CaseSetup readCase(const std::filesystem::path& caseDir);

}  // namespace isph
