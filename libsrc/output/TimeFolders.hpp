// SPDX-License-Identifier: GPL-3.0-or-later
// Time folders of a run: written whole, listed in <case>.pvd for ParaView, read again at a restart.
#pragma once
#include "case/TimeList.hpp"
#include "output/VtpFile.hpp"

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace isph {

/// The parts of a time folder by name: "water" for water.vtp.
using ParticleParts = std::map<std::string, std::reference_wrapper<const ParticleFile>>;

/// Writes <case>/<state.name>/<part>.vtp and uniform/time in a hidden folder beside it that is then
/// renamed: a run that is killed leaves whole time folders only. A folder of that name is replaced.
/// Throws FatalIOError if it cannot be written.
void writeTimeFolder(const std::filesystem::path& caseDir, const TimeState& state,
                     const ParticleParts& parts);

/// Every particle file of a time folder. Throws FatalIOError if one is missing, cut off or damaged.
std::map<std::string, ParticleFile> readTimeFolder(const TimeFolder& folder);

/// <case>/<name of the case's folder>.pvd
std::filesystem::path pvdFile(const std::filesystem::path& caseDir);

/// Rewrites the .pvd file from the time folders that exist: every .vtp file with its time. It is
/// replaced as a whole, so that ParaView never reads half of it. Throws FatalIOError.
void writePvd(const std::filesystem::path& caseDir);

/// What a run writes: time folders, the .pvd file, and the removal of the oldest (purgeWrite).
class TimeFolderWriter {
public:
    /// Removes what a run that was killed has left half written.
    explicit TimeFolderWriter(std::filesystem::path caseDir);

    /// keep: of the folders that this writer has written the latest so many stay; 0: all.
    void write(const TimeState& state, const ParticleParts& parts, int keep = 0);

private:
    std::filesystem::path caseDir_;
    std::deque<std::string> written_;  ///< names, oldest first
};

}  // namespace isph
