// SPDX-License-Identifier: GPL-3.0-or-later
// Turns dictionary text into a Dictionary; of use inside this folder only.
#pragma once
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/Lexer.hpp"

#include <filesystem>
#include <map>

namespace isph {

/// What becomes of an entry whose keyword is there already; the words of #inputMode.
enum class InputMode { merge, overwrite, protect, warn, error };

/// How macros name entries of other scopes: "../a/b" and "!a/b" (slash), "..a.b" and ":a.b" (dot).
enum class InputSyntax { both, slash, dot };

/// What a file shares with the files that it includes.
struct ParserState {
    std::vector<Dictionary*> scopes{};  ///< the open dictionaries, the top one first
    std::vector<std::filesystem::path> files{};
    InputMode mode = InputMode::merge;
    InputSyntax syntax = InputSyntax::both;
    std::map<std::filesystem::path, Dictionary> readForMacros{};  ///< of ${file!entry}
};

/// One per file. Grammar in DictionaryParser.cpp, macros in Macros.cpp, directives in
/// Directives.cpp and Includes.cpp.
class DictionaryParser {
public:
    static Dictionary readFile(const std::filesystem::path& file);
    static Dictionary parseText(std::string_view text, const std::string& name);

private:
    using Directive = void (DictionaryParser::*)(const Lexeme&);

    struct OpenBrace {
        int line;
        std::size_t indent;
        std::unique_ptr<Dictionary> discarded{};  ///< what #inputMode protect does not take
    };
    struct OpenBranch {
        int line;
        bool elseSeen;
    };

    DictionaryParser(Lexer& lexer, ParserState& state) : lexer_(lexer), state_(state) {}

    void parseBody();
    void parseEntry(Lexeme key);
    void parseSubDict(DictionaryEntry entry, const Lexeme& brace);
    void closeBrace(const Lexeme& brace);
    void parseValue(std::vector<Token>& tokens, const Lexeme& key);
    void checkBrackets(const std::vector<Token>& tokens, const Lexeme& key) const;
    void appendValue(std::vector<Token>& tokens, const Lexeme& lexeme);
    const DictionaryEntry* existing(const DictionaryEntry& entry);
    bool admits(const DictionaryEntry& entry);
    void place(DictionaryEntry entry);

    const DictionaryEntry* findMacro(std::string_view name);
    const DictionaryEntry* findInFile(std::string_view file, std::string_view name);
    void appendVariable(std::vector<Token>& tokens, const Lexeme& variable);
    void refuseDict(const Lexeme& lexeme, const Lexeme& key);
    std::string variableName(const Lexeme& variable);
    bool mergeVariable(const Lexeme& variable);
    Lexeme keyFromVariable(const Lexeme& variable);
    bool copyDict(DictionaryEntry& entry, const Lexeme& variable);
    std::optional<std::string> macroText(const std::string& name, bool expression);
    std::string expandText(const std::string& text, int line, bool expression);
    [[noreturn]] void failUndefinedMacro(const std::string& name, int line);

    void directive(const Lexeme& name);
    void valueDirective(std::vector<Token>& tokens, const Lexeme& name);
    std::string textArgument(const Lexeme& name);
    [[noreturn]] void failDirective(const Lexeme& name);
    void include(const Lexeme& name);
    void includeFile(const std::filesystem::path& file, const Lexeme& name,
                     std::vector<Token>* tokens);
    void includeAny(const Lexeme& name, std::vector<Token>* tokens);
    void includeFunction(const Lexeme& name);
    void setInputMode(const Lexeme& name);
    void setInputSyntax(const Lexeme& name);
    void removeEntries(const Lexeme& name);
    void beginBranch(const Lexeme& name);
    void elseBranch(const Lexeme& name);
    void endBranch(const Lexeme& name);
    bool condition(const Lexeme& name);
    void skipBranch();
    void calculate(std::vector<Token>& tokens, const Lexeme& name);
    void negate(std::vector<Token>& tokens, const Lexeme& name);
    std::filesystem::path functionFile(const std::string& function, const Lexeme& name) const;
    std::filesystem::path relativeToThisFile(const std::string& file) const;

    Dictionary& current() { return *state_.scopes.back(); }
    Location here(const Lexeme& lexeme) const { return {lexer_.file(), lexeme.line}; }
    [[noreturn]] void fail(const std::string& message, int line) const;
    [[noreturn]] void failUnclosed() const;

    Lexer& lexer_;
    ParserState& state_;
    std::vector<OpenBrace> open_;
    std::vector<OpenBranch> branches_;
    /// A closing brace that stands at another indent than its opening one
    std::string indentHint_;
};

}  // namespace isph
