// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the user's input and of the run, worded as OpenFOAM words them.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace isph {

/// An error that no single place of a file caused: prints "--> FOAM FATAL ERROR:".
class FatalError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// An error at a place of a file: prints "--> FOAM FATAL IO ERROR:" with file and line.
class FatalIOError : public FatalError {
public:
    /// line <= 0: the file as a whole.
    FatalIOError(const std::string& message, std::string file, int line);
    const std::string& file() const { return file_; }
    int line() const { return line_; }

private:
    std::string file_;
    int line_;
};

/// Prints the error as OpenFOAM does to stderr and returns the exit code 1.
int reportFatal(const std::exception& error);

/// The candidate closest to `word` by edit distance, empty when none is near (more than half
/// differs).
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);

/// OpenFOAM's list form, one per line and sorted: "3\n(\n    a\n    b\n    c\n)\n"
std::string listOf(std::vector<std::string> names);

}  // namespace isph
