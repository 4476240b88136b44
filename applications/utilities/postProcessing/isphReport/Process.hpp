// SPDX-License-Identifier: GPL-3.0-or-later
// Commands run one by one, with what they used.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

namespace isph {

struct ProcessEnd {
    int code = 0;    ///< exit code
    int signal = 0;  ///< that ended it, 0 if none
    bool timedOut = false;
    Real wall = 0, cpu = 0;  ///< [s]
    Real memory = 0;         ///< largest resident set [bytes]

    bool succeeded() const { return code == 0 && signal == 0 && !timedOut; }
};

struct Command {
    std::string line;  ///< for the shell; programs of this project are found beside this one
    std::filesystem::path folder, log;
    int threads = 1;
    std::optional<Real> timeLimit;  ///< [s]
};

/// Runs a command to its end. After a stop signal to this program (StopSignal.hpp) the command gets
/// SIGTERM. Throws FatalError where no process can be made.
ProcessEnd runCommand(const Command& command);

/// While it lives no command starts. A command takes the files with it that are open when it
/// starts, and a script that somebody has open for writing cannot be run ("text file busy"):
/// scripts are written under this lock.
std::unique_lock<std::mutex> holdStarts();

/// Puts the folder of this program before the others of PATH.
void findOwnPrograms();

}  // namespace isph
