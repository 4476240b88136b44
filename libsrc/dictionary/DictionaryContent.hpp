// SPDX-License-Identifier: GPL-3.0-or-later
// What a Dictionary holds; of use inside this folder only.
#pragma once
#include "dictionary/Dictionary.hpp"

#include <map>
#include <optional>
#include <regex>

namespace isph {

struct DictionaryEntry {
    std::string key;  ///< patterns without their quotes
    Location at{};
    std::vector<Token> tokens{};
    std::unique_ptr<Dictionary> dict{};  ///< set where the entry is a sub-dictionary
    std::optional<std::regex> pattern{};
    mutable bool usedByMacro = false;

    DictionaryEntry clone() const;
};

struct Dictionary::Content {
    std::string name;
    Location at;
    std::vector<DictionaryEntry> entries;
    std::map<std::string, std::size_t, std::less<>> exact;  ///< of the entries that are no patterns

    const DictionaryEntry* findExact(std::string_view key) const;
    DictionaryEntry* findExact(std::string_view key);
    /// The entry written as this pattern
    const DictionaryEntry* findPattern(const std::string& text) const;
    /// Exact, else the last pattern that matches
    const DictionaryEntry* find(std::string_view key) const;
    /// Replaces an entry of the same key in its place (a pattern goes to the end), else appends.
    DictionaryEntry& put(DictionaryEntry entry);
    void erase(const DictionaryEntry* entry);
};

struct DictionaryAccess {
    static Dictionary::Content& content(Dictionary& dict) { return *dict.content_; }
    static const Dictionary::Content& content(const Dictionary& dict) { return *dict.content_; }
};

/// Adds or overrides entry by entry; sub-dictionaries are merged.
void mergeInto(Dictionary& target, const Dictionary& source);

/// Names a dictionary, and its sub-dictionaries after it.
void rename(Dictionary& dict, const std::string& name);

/// "keyword x is undefined in dictionary ..." with the nearest keyword that is there.
[[noreturn]] void failUndefined(const Dictionary& dict, std::string_view key);

/// Throws where the value carries dimensions that are not the required ones.
void checkDimensions(const Dictionary& dict, std::string_view key, const Dimensions& required);

/// The regular expression of a quoted keyword. Throws FatalIOError where it is none.
std::regex patternOf(const std::string& text, const Location& at);

/// "a/b/c" in its parts.
std::vector<std::string> partsOf(std::string_view path);

/// The text of a file. Throws FatalIOError where it cannot be read.
std::string textOfFile(const std::filesystem::path& file);

/// The tokens as they would be written.
std::string textOf(const std::vector<Token>& tokens);
std::string textOf(const Token& token);

}  // namespace isph
