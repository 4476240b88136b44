// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a variant: made from the case, run, and known again when it is finished.
#pragma once
#include "Variants.hpp"

#include <map>

namespace isph {

/// How a variant ended, and what it cost.
struct Outcome {
    enum class State { stable, unstable, notRun, stopped };
    State state = State::notRun;
    std::string why;  ///< of unstable, notRun (its input or a command before it failed) and stopped
    Real particles = 0, steps = 0;
    Real wall = 0, cpu = 0;  ///< of the last command, the solver [s]
    Real memory = 0;         ///< its largest resident set [bytes]
    /// By name; those that could not be had are not there. Of stable variants only.
    std::map<std::string, Real> errors;
    std::vector<std::string> errorNames;  ///< in the order in which they were found
};

const char* describe(Outcome::State state);

class VariantCase {
public:
    /// Nothing is written. The variant's folder is <case>/report/<name>.
    VariantCase(const Report& report, const Variant& variant, const std::filesystem::path& caseDir);

    const Variant& variant() const { return variant_; }
    const std::filesystem::path& folder() const { return folder_; }
    /// The run is finished, and was one of these very dictionaries and commands.
    bool finished() const;
    /// Makes the folder anew and runs the commands in it. False if a stop signal ended it, which
    /// leaves it unfinished.
    bool run() const;
    /// Of a finished run, its errors read from what it wrote.
    Outcome outcome() const;
    /// Share of the run that is done, by its log.
    Real progress() const;

private:
    struct File {
        std::filesystem::path name;  ///< relative to the case
        std::string text;
    };
    std::vector<File> input() const;
    std::string fingerprint(const std::vector<File>& files) const;
    std::filesystem::path logOf(const std::string& command) const;
    void readErrors(Outcome& outcome) const;
    void checkLimits(Outcome& outcome) const;

    const Report& report_;
    const Variant& variant_;
    std::filesystem::path caseDir_, folder_;
};

}  // namespace isph
