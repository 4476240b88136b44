// SPDX-License-Identifier: GPL-3.0-or-later
// A case directory read into a scene.
#pragma once
#include "case/TimeList.hpp"
#include "integrator/SchemeKeys.hpp"
#include "integrator/Scene.hpp"

#include <filesystem>

namespace isph {

/// The dictionaries of a case; those that a scene does not need may be absent and are then empty.
struct CaseFiles {
    explicit CaseFiles(const std::filesystem::path& caseDir);

    std::filesystem::path caseDir;
    Dictionary particles, boundaries, gravity, transport, porousZones, turbulence, erosion, schemes,
        solution;
    bool hasErosion = false;
    int dimension() const;
};

/// Particles from the time folder, everything else from the dictionaries. Throws FatalIOError.
template <int Dim>
Scene<Dim> readScene(const CaseFiles& files, const TimeFolder& start);

}  // namespace isph
