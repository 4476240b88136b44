// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Lexer.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace isph {

namespace {

bool isSpace(char c)
{
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
bool isMark(char c)
{
    return std::string_view(";{}()[],").find(c) != std::string_view::npos;
}

/// Characters that end a word wherever they stand.
bool endsWord(char c)
{
    return c == '\0' || isSpace(c) || c == '"' || c == ';' || c == '{' || c == '}';
}

}  // namespace

bool spellsNumber(std::string_view text, double& value)
{
    std::string_view digits = text;
    if (!digits.empty() && digits[0] == '+') digits.remove_prefix(1);
    const std::size_t first = !digits.empty() && digits[0] == '-' ? 1 : 0;
    if (digits.size() <= first) return false;
    const bool leads =
        isDigit(digits[first]) ||
        (digits[first] == '.' && digits.size() > first + 1 && isDigit(digits[first + 1]));
    if (!leads) return false;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && stop == digits.data() + digits.size();
}

Lexer::Lexer(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

void Lexer::fail(const std::string& message, int line) const
{
    throw FatalIOError(message, file_, line);
}

bool Lexer::commentAt(std::size_t position) const
{
    return at(position) == '/' && (at(position + 1) == '/' || at(position + 1) == '*');
}

void Lexer::skipComment()
{
    if (at(position_ + 1) == '/') {
        position_ = std::min(text_.find('\n', position_), text_.size());
        return;
    }
    const std::size_t end = text_.find("*/", position_ + 2);
    if (end == std::string_view::npos)
        fail("The comment '/*' opened in line " + std::to_string(line_) + " is not closed", line_);
    line_ += static_cast<int>(std::count(text_.begin() + position_, text_.begin() + end, '\n'));
    position_ = end + 2;
}

void Lexer::skipBlank()
{
    while (position_ < text_.size()) {
        if (isSpace(text_[position_])) {
            if (text_[position_] == '\n') ++line_;
            ++position_;
        } else if (commentAt(position_)) {
            skipComment();
        } else {
            return;
        }
    }
}

Lexeme Lexer::take(Lexeme::Kind kind, std::size_t end, std::string text)
{
    Lexeme lexeme{kind, std::move(text), 0, line_, position_, end};
    line_ += static_cast<int>(std::count(text_.begin() + position_, text_.begin() + end, '\n'));
    position_ = end;
    return lexeme;
}

Lexeme Lexer::next()
{
    if (peeked_) {
        peeked_ = false;
        return std::move(ahead_);
    }
    return scan();
}

const Lexeme& Lexer::peek()
{
    if (!peeked_) {
        ahead_ = scan();
        peeked_ = true;
    }
    return ahead_;
}

Lexeme Lexer::scan()
{
    skipBlank();
    const char c = at(position_);
    if (position_ >= text_.size()) return take(Lexeme::Kind::end, position_, "");
    if (c == '"') return scanString();
    if (c == '#' && at(position_ + 1) == '{') return scanVerbatim();
    if (c == '#') {
        std::size_t end = position_ + 1;
        while (std::isalnum(static_cast<unsigned char>(at(end))) || at(end) == '_') ++end;
        return take(Lexeme::Kind::directive, end,
                    std::string(text_.substr(position_ + 1, end - position_ - 1)));
    }
    if (c == '$') return scanVariable();
    if (isMark(c)) {
        if (c == '[') ++squareDepth_;
        if (c == ']' && squareDepth_ > 0) --squareDepth_;
        return take(Lexeme::Kind::punctuation, position_ + 1, std::string(1, c));
    }
    return scanWord();
}

Lexeme Lexer::scanString()
{
    std::string text;
    std::size_t k = position_ + 1;
    for (;; ++k) {
        const char c = at(k);
        if (k >= text_.size() || c == '\n')
            fail("The string opened in line " + std::to_string(line_) +
                     " is not closed in this line",
                 line_);
        if (c == '"') break;
        if (c != '\\') {
            text += c;
            continue;
        }
        const char escaped =
            at(++k);  // \" is a quote, \newline nothing, all else stays for regular expressions
        if (escaped == '\n') continue;
        if (escaped != '"') text += c;
        text += escaped;
    }
    return take(Lexeme::Kind::string, k + 1, std::move(text));
}

Lexeme Lexer::scanVerbatim()
{
    const std::size_t end = text_.find("#}", position_ + 2);
    if (end == std::string_view::npos)
        fail("The verbatim block '#{' opened in line " + std::to_string(line_) + " is not closed",
             line_);
    return take(Lexeme::Kind::verbatim, end + 2,
                std::string(text_.substr(position_ + 2, end - position_ - 2)));
}

/// Where a word that begins at `from` ends: balanced parentheses without spaces belong to it.
std::size_t Lexer::wordEnd(std::size_t from) const
{
    int depth = 0;
    std::size_t k = from, unbalanced = from;
    for (; !endsWord(at(k)) && !commentAt(k); ++k) {
        const char c = at(k);
        if (c == '[' || c == ']' || (c == ',' && depth == 0)) break;
        if ((c == '(' || c == ')') && squareDepth_ > 0) break;  // units: kg/(m s)
        double ignored = 0;
        if (c == '(' && depth == 0 && spellsNumber(text_.substr(from, k - from), ignored))
            break;  // 3(a b c)
        if (c == '(' && depth++ == 0) unbalanced = k;
        if (c == ')' && --depth < 0) break;
    }
    return depth > 0 ? unbalanced : k;
}

Lexeme Lexer::scanVariable()
{
    if (at(position_ + 1) != '{') {
        const std::size_t end = wordEnd(position_ + 1);
        return take(Lexeme::Kind::variable, end,
                    std::string(text_.substr(position_ + 1, end - position_ - 1)));
    }
    int depth = 0;
    std::size_t k = position_ + 1;
    for (; k < text_.size(); ++k) {
        if (text_[k] == '{') ++depth;
        if (text_[k] == '}' && --depth == 0) break;
        if (text_[k] == '\n') break;
    }
    if (at(k) != '}')
        fail("The variable '${' opened in line " + std::to_string(line_) + " is not closed", line_);
    return take(Lexeme::Kind::variable, k + 1,
                std::string(text_.substr(position_ + 2, k - position_ - 2)));
}

Lexeme Lexer::scanWord()
{
    const std::size_t end = std::max(wordEnd(position_), position_ + 1);
    Lexeme lexeme =
        take(Lexeme::Kind::word, end, std::string(text_.substr(position_, end - position_)));
    if (spellsNumber(lexeme.text, lexeme.number)) lexeme.kind = Lexeme::Kind::number;
    return lexeme;
}

Lexeme Lexer::bracedText()
{
    const Lexeme open = next();
    if (!open.is('{')) fail("Expected '{' and an expression, found '" + open.text + "'", open.line);
    int depth = 1;
    std::size_t k = position_;
    for (; k < text_.size(); ++k) {
        if (text_[k] == '{') ++depth;
        if (text_[k] == '}' && --depth == 0) break;
    }
    if (k >= text_.size())
        fail("The '{' opened in line " + std::to_string(open.line) + " is not closed", open.line);
    Lexeme body =
        take(Lexeme::Kind::verbatim, k + 1, std::string(text_.substr(position_, k - position_)));
    body.line = open.line;
    return body;
}

std::size_t Lexer::indentOf(std::size_t position) const
{
    const std::size_t newline =
        position == 0 ? std::string_view::npos : text_.rfind('\n', position - 1);
    const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
    std::size_t k = start;
    while (at(k) == ' ' || at(k) == '\t') ++k;
    return k - start;
}

}  // namespace isph
