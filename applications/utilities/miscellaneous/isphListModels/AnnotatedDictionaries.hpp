// SPDX-License-Identifier: GPL-3.0-or-later
// Reference dictionaries of the model families, written from the models' own declarations.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace isph {

struct AnnotatedFile {
    std::string name;  ///< of the case's file: "porousZones"
    std::string text;
};

/// porousZones, turbulenceProperties, erosionProperties and kernels, with all models that are
/// loaded, their keys, defaults, dimensions and ranges. Each is a dictionary that can be read.
std::vector<AnnotatedFile> annotatedDictionaries();

/// Writes them into a folder, which is made where it is missing. Throws FatalError where it cannot.
void writeAnnotatedDictionaries(const std::filesystem::path& folder);

}  // namespace isph
