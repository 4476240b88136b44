// SPDX-License-Identifier: GPL-3.0-or-later
// Every dictionary of a case against the keys that its readers declare.
#pragma once
#include "Checklist.hpp"

#include <filesystem>

namespace isph {

/// system/controlDict with its function objects, isphSchemes, isphSolution, particlesDict,
/// boundaryDict, constant/g, transportProperties, porousZones, turbulenceProperties and
/// erosionProperties.
void checkDictionaries(const std::filesystem::path& caseDir, Checklist& list);

}  // namespace isph
