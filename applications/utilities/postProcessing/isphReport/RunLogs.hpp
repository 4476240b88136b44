// SPDX-License-Identifier: GPL-3.0-or-later
// What the logs of a variant's programs tell.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace isph {

struct LogFacts {
    Real particles = 0;  ///< of water
    Real steps = 0;
    std::string lastTime;  ///< of the last step, as printed; empty before the first
    std::string error;     ///< message of the fatal error, a line; empty where there is none
};

LogFacts readLog(const std::filesystem::path& file);

/// The last "Progress = x %" of a log that is being written, as a share.
Real lastProgress(const std::filesystem::path& file);

/// "<name> <value> <unit> bound <bound> ok|FAIL", as isphCompare prints it.
std::vector<std::pair<std::string, Real>> readCheckLines(const std::filesystem::path& file);

}  // namespace isph
