// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts dictionary text into words, numbers, strings, punctuation, variables and directives.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace isph {

struct Lexeme {
    enum class Kind { word, string, number, punctuation, verbatim, variable, directive, end };
    Kind kind = Kind::end;
    /// Strings without quotes, variables without $ and ${ }, directives without #
    std::string text;
    double number = 0;      ///< of kind number
    int line = 0;           ///< where it begins, from 1
    std::size_t begin = 0;  ///< offsets of its characters in the text, [begin, end)
    std::size_t end = 0;

    bool is(char mark) const { return kind == Kind::punctuation && text[0] == mark; }
};

/// Comments are skipped. Words follow OpenFOAM: "div(phi,U)" is one word, "3(a b)" is not; a slash
/// may stand in a word. Errors: FatalIOError for a comment, string or block that does not end.
class Lexer {
public:
    Lexer(std::string_view text, std::string file);

    Lexeme next();
    const Lexeme& peek();
    /// The text between the braces that come next ("{ ... }"), of directives that take an
    /// expression.
    Lexeme bracedText();
    const std::string& file() const { return file_; }
    /// Spaces before the first mark of a line.
    std::size_t indentOf(std::size_t position) const;

private:
    Lexeme scan();
    Lexeme scanString();
    Lexeme scanVerbatim();
    Lexeme scanVariable();
    Lexeme scanWord();
    void skipBlank();
    void skipComment();
    std::size_t wordEnd(std::size_t from) const;
    bool commentAt(std::size_t position) const;
    char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }
    Lexeme take(Lexeme::Kind kind, std::size_t end, std::string text);
    [[noreturn]] void fail(const std::string& message, int line) const;

    std::string_view text_;
    std::string file_;
    std::size_t position_ = 0;
    int line_ = 1;
    int squareDepth_ = 0;
    bool peeked_ = false;
    Lexeme ahead_;
};

/// The number that the whole text spells, in C notation; false where it spells none.
bool spellsNumber(std::string_view text, double& value);

}  // namespace isph
