// SPDX-License-Identifier: GPL-3.0-or-later
// The time folders of a case, and where a run starts from.
#pragma once
#include "dictionary/Dictionary.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// A folder of a case whose name is a number.
struct TimeFolder {
    Real value = 0;  ///< its name as a number [s]
    std::string name;
    std::filesystem::path path;
};

/// The time folders of a case in the order of time.
std::vector<TimeFolder> timeFolders(const std::filesystem::path& caseDir);

/// Those that a selection names: "0.35,0.75", ranges "0.5:1", ":1", "2:", words latestTime,
/// firstTime. A single time stands for the folder nearest to it. Throws FatalError if an item
/// matches none.
std::vector<TimeFolder> selectTimes(const std::vector<TimeFolder>& folders,
                                    const std::string& selection);

/// <time>/uniform/time: where a run stood, in full precision.
struct TimeState {
    Real value = 0;  ///< [s]
    std::string name = "0";
    int index = 0;                   ///< steps since the case began
    Real deltaT = 0;                 ///< last step [s], 0 before the first
    Real deltaT0 = 0;                ///< the step before it [s]
    std::vector<std::string> parts;  ///< particle files that belong to the folder ("water", ...)
};

/// The file's text; parseTimeState(timeStateText(s)) is s, bit for bit.
std::string timeStateText(const TimeState& state);

/// Reads <folder>/uniform/time and checks that every part it names is there. The folder of time 0
/// may lack it: its state is then the default one. errors  FatalIOError: the folder was cut off in
/// the middle (names what is missing)
TimeState readTimeState(const TimeFolder& folder);

/// Start of a run by controlDict's startFrom and startTime.
/// errors  FatalIOError at the entry: no time folder, or none of that time (lists those there are)
TimeFolder startFolder(const Dictionary& controlDict, const std::filesystem::path& caseDir);

}  // namespace isph
