// SPDX-License-Identifier: GPL-3.0-or-later
// Turns dictionary text into a Dictionary; of use inside this folder only.
#pragma once
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/Lexer.hpp"

#include <filesystem>

namespace isph {

class DictionaryParser {
public:
    static Dictionary readFile(const std::filesystem::path& file);
    static Dictionary parseText(std::string_view text, const std::string& name);

private:
    struct OpenBrace {
        int line;
        std::size_t indent;
    };

    DictionaryParser(Lexer& lexer, Dictionary& top);

    void parseBody();
    void parseEntry(Lexeme key);
    void parseSubDict(DictionaryEntry entry, const Lexeme& brace);
    void closeBrace(const Lexeme& brace);
    std::vector<Token> parseValue(const Lexeme& key);
    void appendValue(std::vector<Token>& tokens, const Lexeme& lexeme);
    Dictionary& current() { return *scopes_.back(); }
    Location here(const Lexeme& lexeme) const { return {lexer_.file(), lexeme.line}; }
    [[noreturn]] void fail(const std::string& message, int line) const;
    [[noreturn]] void failUnclosed() const;

    Lexer& lexer_;
    std::vector<Dictionary*> scopes_;
    std::vector<OpenBrace> open_;
    std::string indentHint_;   ///< a closing brace that stands at another indent than its opening one
};

}  // namespace isph
