// SPDX-License-Identifier: GPL-3.0-or-later
// One entry of reportDict's vary { }.
#pragma once
#include "ReportDict.hpp"

namespace isph {

/// A key { values (a b c); } that is known by name (spacing, kernel, deltaT, ...), or any other
/// with its file and entries; range { from; to; n; scale linear|log; } instead of values. The
/// entries must be in the case's file, unless the key is known and has a default. Throws
/// FatalIOError with file and line.
VariedKey readVariedKey(const Dictionary& dict, const std::filesystem::path& caseDir);

/// The names that need no file.
std::vector<std::string> knownKeys();

}  // namespace isph
