// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of an application: single-dash long options as OpenFOAM has them.
//
//     CommandLine line("createParticles", "Fills 0/ from system/particlesDict.");
//     line.argument("file", "dictionary to read").option("dict", "file", "alternative
//     dictionary").flag("check", "only checks"); if (const auto exitCode = line.parse(argc, argv))
//     return *exitCode; line.printBanner();
//
// Every application has -case <dir>, -libs '("libX.so")', -noFunctionObjects, -help and -version
// besides.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace isph {

class CommandLine {
public:
    CommandLine(std::string program, std::string description);

    CommandLine& flag(std::string name, std::string description);
    CommandLine& option(std::string name, std::string valueName, std::string description);
    /// An argument without a dash; all that are declared must be given.
    CommandLine& argument(std::string name, std::string description);

    /// Reads the arguments, sets FOAM_CASE and (where it is unset and can be found)
    /// ISPH_PROJECT_DIR in the environment, for the macros of dictionaries, and loads the libraries
    /// of -libs. An exit code where the program is to end at once: after -help and -version (0),
    /// after a wrong option, which is reported as "Invalid option: -x" with the usage (1). Throws
    /// FatalError for a case directory that is not there and for libraries that cannot be loaded.
    std::optional<int> parse(int argc, const char* const* argv);

    bool has(const std::string& name) const { return values_.count(name) != 0; }
    /// The value of an option or argument; `otherwise` where it was not given.
    std::string value(const std::string& name, const std::string& otherwise = "") const;
    /// Throws FatalError where the value is no number.
    Real number(const std::string& name, Real otherwise) const;

    /// The folder of -case, else the working directory; absolute.
    const std::filesystem::path& caseDir() const { return caseDir_; }
    bool functionObjects() const { return !has("noFunctionObjects"); }

    /// The banner and the lines Build, Exec, Date, Time, Host, PID, Case, nProcs of a run's log.
    void printBanner() const;
    std::string usage() const;

private:
    struct Item {
        std::string name, valueName, description;
    };
    void readWords(const std::vector<std::string>& words);
    void useCase();
    void loadLibraries() const;
    std::string invalidOption(const std::string& name) const;
    int refuse(const std::string& message) const;

    std::string program_, description_, words_;
    std::vector<Item> options_, arguments_;
    std::map<std::string, std::string> values_;
    std::filesystem::path caseDir_;
};

/// The version that -version prints.
std::string programVersion();

}  // namespace isph
