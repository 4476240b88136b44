// SPDX-License-Identifier: GPL-3.0-or-later
// The OpenFOAM dictionary language: every entry knows the file and line it came from.
#pragma once
#include "core/Error.hpp"
#include "core/Types.hpp"
#include "dictionary/Dimensions.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isph {

using Vector3 = std::array<Real, 3>;

struct Location {
    std::string file;
    int line = 0;
};

/// One resolved token of an entry's value. Lists keep their parentheses as punctuation tokens.
struct Token {
    enum class Kind { word, string, number, punctuation, verbatim };
    Kind kind;
    std::string text;   ///< as written, strings without their quotes
    double number = 0;  ///< of kind number
    Location at;
};

class Dictionary {
public:
    /// Reads a file, resolving macros and directives. Throws FatalIOError (with file and line).
    static Dictionary read(const std::filesystem::path& file);
    /// Reads text; `name` stands for the file in error messages.
    static Dictionary parse(std::string_view text, const std::string& name = "text");

    Dictionary();
    Dictionary(const Dictionary&);
    Dictionary(Dictionary&&) noexcept;
    Dictionary& operator=(const Dictionary&);
    Dictionary& operator=(Dictionary&&) noexcept;
    ~Dictionary();

    /// The file and the scope: "case/constant/porousZones/rubble".
    const std::string& name() const;
    /// The last part of name(): "rubble".
    std::string scopeName() const;
    /// Where the dictionary begins.
    Location location() const;
    /// Where an entry stands; location() where there is none.
    Location location(std::string_view key) const;

    /// Keywords in the order of the file, patterns included (with their quotes).
    std::vector<std::string> keywords() const;
    bool found(std::string_view key) const;  ///< exact key, else a pattern that matches
    bool isDict(std::string_view key) const;
    /// A macro used this entry: a variable of the user's, not a misspelled keyword.
    bool isUsedByMacro(std::string_view key) const;
    const Dictionary& subDict(std::string_view key) const;  ///< throws if missing or no dictionary

    /// The tokens of an entry (macros resolved). Throws "keyword x is undefined in dictionary ...".
    const std::vector<Token>& tokens(std::string_view key) const;

    /// The value as it would be written, strings with their quotes.
    std::string valueText(std::string_view key) const;

    /// Typed look-up. T: Real, int, bool (a switch), std::string (word or string), Vector3,
    /// std::vector<Real>, std::vector<std::string>, std::vector<Vector3>, std::vector<int>.
    /// A value may carry its dimensions ("nu [0 2 -1 0 0 0 0] 1e-6;", "nu [m^2/s] 1e-6;", the old
    /// form with a leading name), which must then equal `expected`; units scale the value to SI.
    template <class T>
    T get(std::string_view key, const Dimensions& expected = dims::none) const;
    template <class T>
    T getOrDefault(std::string_view key, const T& otherwise,
                   const Dimensions& expected = dims::none) const
    {
        return found(key) ? get<T>(key, expected) : otherwise;
    }
    /// One of `allowed`, else "foo is not in enumeration: ..." with the nearest name.
    std::string getChoice(std::string_view key, const std::vector<std::string>& allowed) const;
    std::string getChoice(std::string_view key, const std::vector<std::string>& allowed,
                          const std::string& otherwise) const;

    /// Throws FatalIOError at the entry (or at the dictionary where the key is absent).
    [[noreturn]] void fail(std::string_view key, const std::string& message) const;

    /// Sets an entry from text in dictionary syntax ("1e-3", "(0 0 -9.81)", "{ type box; }");
    /// makes it where it is missing. Sub-dictionaries are reached as "a/b/c".
    void set(std::string_view path, const std::string& value);
    void remove(std::string_view path);

    /// Canonical form with everything resolved.
    std::string toString(int indent = 0) const;

private:
    friend struct DictionaryAccess;  // of the parser and the schemas, in this folder
    struct Content;
    std::unique_ptr<Content> content_;
};

extern template Real Dictionary::get<Real>(std::string_view, const Dimensions&) const;
extern template int Dictionary::get<int>(std::string_view, const Dimensions&) const;
extern template bool Dictionary::get<bool>(std::string_view, const Dimensions&) const;
extern template std::string Dictionary::get<std::string>(std::string_view, const Dimensions&) const;
extern template Vector3 Dictionary::get<Vector3>(std::string_view, const Dimensions&) const;
extern template std::vector<Real> Dictionary::get<std::vector<Real>>(std::string_view,
                                                                     const Dimensions&) const;
extern template std::vector<int> Dictionary::get<std::vector<int>>(std::string_view,
                                                                   const Dimensions&) const;
extern template std::vector<std::string> Dictionary::get<std::vector<std::string>>(
    std::string_view, const Dimensions&) const;
extern template std::vector<Vector3> Dictionary::get<std::vector<Vector3>>(std::string_view,
                                                                           const Dimensions&) const;

}  // namespace isph
