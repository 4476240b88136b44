// SPDX-License-Identifier: GPL-3.0-or-later
// What system/reportDict asks for.
#pragma once
#include "Comparison.hpp"
#include "dictionary/Schema.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isph {

/// One value of a key: what is written into the dictionary, and what tables call it.
struct KeyValue {
    std::string text, label;

    /// The value as a number, for axes; none for words.
    std::optional<Real> number() const;
};

/// A key that varies, with the entries of one dictionary that it stands for.
struct VariedKey {
    std::string name;
    std::filesystem::path file;  ///< relative to the case
    std::vector<std::string> entries;
    std::vector<KeyValue> values;
    KeyValue base;  ///< as the case has it

    bool numeric() const;
};

/// One number that is taken from what function objects of a run wrote.
struct Quantity {
    std::string name;
    Source source;  ///< with paths relative to the case
    Expectation expectation;
    std::string measure;
    Real scale = 1;
    bool relative = false;
    Real above = 0;  ///< of limits: what a sound run does not exceed

    /// Throws FatalError where it cannot be had.
    Real of(const std::filesystem::path& caseDir) const;
};

struct Report {
    enum class Mode { oneAtATime, grid };
    Mode mode = Mode::oneAtATime;
    std::string along;  ///< the key along which lines are drawn, empty: none
    int parallel = 1, threads = 1;
    std::optional<Real> timeLimit;  ///< [s]
    std::vector<std::string> commands;
    std::string check;  ///< command whose lines "<name> <value> <unit> bound ..." are errors too
    std::vector<VariedKey> keys;
    std::vector<Quantity> errors, limits;

    const VariedKey* alongKey() const;
};

Schema reportKeys();

/// Reads <case>/system/reportDict and what it refers to in the case. Throws FatalIOError with file
/// and line, or FatalError.
Report readReport(const std::filesystem::path& caseDir);

}  // namespace isph
