// SPDX-License-Identifier: GPL-3.0-or-later
// A dictionary file as its author wrote it: entries can be read unresolved and changed where they
// stand, and all else (comments, layout, macros, directives) stays as it is.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isph {

class Lexer;
struct Lexeme;

class DictionarySource {
public:
    /// Throws FatalIOError for text that is no dictionary. Macros and directives are not followed.
    DictionarySource(std::string text, std::string name);
    static DictionarySource read(const std::filesystem::path& file);

    const std::string& text() const { return text_; }

    /// Keywords of the dictionary at a path "a/b" ("": the whole file), patterns with their quotes.
    std::vector<std::string> keywords(std::string_view path) const;
    bool found(std::string_view path) const;
    /// The entry as written, from its keyword to its ';' or '}'. A key that only a pattern matches
    /// gives that pattern's.
    std::string entryText(std::string_view path) const;
    /// As entryText(), without keyword and ';'.
    std::string valueText(std::string_view path) const;

    /// Changes the value of an entry where it stands, or adds it at the end of its dictionary.
    /// `value` is dictionary syntax: "1e-3", "(0 0 1)", "{ a 1; }". Where a keyword stands more
    /// than once, the one that counts is changed.
    void set(std::string_view path, const std::string& value);
    /// As set(), but the entry must not be there yet.
    void add(std::string_view path, const std::string& value);
    /// Takes an entry away wherever it stands, with the comment that follows in its line.
    void remove(std::string_view path);

    /// Written to a temporary name beside the file and renamed, with the permissions of the file
    /// that was there.
    void write(const std::filesystem::path& file) const;

private:
    struct Item {
        std::string key;  ///< patterns with their quotes
        int line = 0;
        bool isDict = false;
        bool isDirective = false;  ///< or a macro in the place of a keyword
        std::size_t begin = 0, end = 0;
        std::size_t valueBegin = 0, valueEnd = 0;  ///< of dictionaries from '{' to '}'
        std::vector<Item> items{};
    };
    using Path = std::vector<std::string>;

    void parse();
    std::size_t parseItems(Lexer& lexer, Item& into, bool nested);
    Item parseItem(Lexer& lexer, const Lexeme& first);
    void skipDirective(Lexer& lexer, const Lexeme& name, Item& item);
    std::vector<const Item*> occurrences(const Path& path) const;
    const Item& dictionaryAt(const Path& path) const;
    const Item& itemAt(std::string_view path) const;
    const Item& effective(const std::vector<const Item*>& found, const Path& path) const;
    void replaceValue(const Item& item, const std::string& value);
    void insert(const Path& path, const std::string& value);
    void insertInLine(const Item& dict, const Path& path, const std::string& value);
    void insertLines(const Item& dict, const Path& path, const std::string& value);
    std::string lineIndent(std::size_t position) const;
    [[noreturn]] void failAbsent(const Path& path) const;

    std::string text_, name_;
    Item top_;
};

}  // namespace isph
