// SPDX-License-Identifier: GPL-3.0-or-later
// Directives: which there are, conditions, modes, removal and arithmetic. Files: Includes.cpp.
#include "core/Error.hpp"
#include "dictionary/DictionaryParser.hpp"
#include "dictionary/Expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace isph {

void DictionaryParser::directive(const Lexeme& name)
{
    static const std::map<std::string, Directive> directives{
        {"include", &DictionaryParser::include},
        {"includeIfPresent", &DictionaryParser::include},
        {"sinclude", &DictionaryParser::include},
        {"includeEtc", &DictionaryParser::include},
        {"includeFunc", &DictionaryParser::includeFunction},
        {"inputMode", &DictionaryParser::setInputMode},
        {"inputSyntax", &DictionaryParser::setInputSyntax},
        {"remove", &DictionaryParser::removeEntries},
        {"if", &DictionaryParser::beginBranch},
        {"ifeq", &DictionaryParser::beginBranch},
        {"else", &DictionaryParser::elseBranch},
        {"endif", &DictionaryParser::endBranch},
    };
    const auto found = directives.find(name.text);
    if (found != directives.end()) return (this->*found->second)(name);
    if (name.text == "calc" || name.text == "eval" || name.text == "neg")
        fail(fmt::format("#{} gives a value: it stands after a keyword", name.text), name.line);
    failDirective(name);
}

void DictionaryParser::valueDirective(std::vector<Token>& tokens, const Lexeme& name)
{
    if (name.text == "calc" || name.text == "eval") return calculate(tokens, name);
    if (name.text == "neg") return negate(tokens, name);
    if (name.text == "include" || name.text == "includeIfPresent" || name.text == "sinclude" ||
        name.text == "includeEtc")
        return includeAny(name, &tokens);
    failDirective(name);
}

void DictionaryParser::failDirective(const Lexeme& name)
{
    if (name.text == "codeStream")
        fail(
            "#codeStream is refused: isphPorousFoam compiles no code out of dictionaries. "
            "Numbers can be computed by #calc \"...\" or #eval \"...\"",
            name.line);
    if (name.text.empty())
        fail("'#' begins a directive, as in #include. Comments begin with //", name.line);
    const std::vector<std::string> known{"include",     "includeIfPresent",
                                         "sinclude",    "includeEtc",
                                         "includeFunc", "inputMode",
                                         "inputSyntax", "calc",
                                         "eval",        "if",
                                         "ifeq",        "else",
                                         "endif",       "remove",
                                         "neg"};
    const std::string near = nearestName(name.text, known);
    fail(fmt::format("Unknown directive #{}{}\n\nDirectives here are:\n\n{}", name.text,
                     near.empty() ? "" : fmt::format("\nDid you mean #{}?", near), listOf(known)),
         name.line);
}

/// One word, string or variable that stands for one.
std::string DictionaryParser::textArgument(const Lexeme& name)
{
    std::vector<Token> tokens;
    appendValue(tokens, lexer_.next());
    if (tokens.size() != 1 ||
        (tokens[0].kind != Token::Kind::word && tokens[0].kind != Token::Kind::string))
        fail(fmt::format("#{} is followed by '{}': expected a word or a string", name.text,
                         textOf(tokens)),
             name.line);
    return tokens[0].text;
}

void DictionaryParser::setInputMode(const Lexeme& name)
{
    static const std::map<std::string, InputMode> modes{
        {"merge", InputMode::merge},     {"overwrite", InputMode::overwrite},
        {"protect", InputMode::protect}, {"warn", InputMode::warn},
        {"error", InputMode::error},     {"default", InputMode::merge}};
    const std::string word = textArgument(name);
    const auto mode = modes.find(word);
    if (mode == modes.end())
        fail(fmt::format("#inputMode {0}:\n{0} is not in enumeration: {1}", word,
                         listOf({"merge", "overwrite", "protect", "warn", "error", "default"})),
             name.line);
    state_.mode = mode->second;
}

void DictionaryParser::setInputSyntax(const Lexeme& name)
{
    static const std::map<std::string, InputSyntax> all{
        {"slash", InputSyntax::slash}, {"dot", InputSyntax::dot}, {"default", InputSyntax::both}};
    const std::string word = textArgument(name);
    const auto syntax = all.find(word);
    if (syntax == all.end())
        fail(fmt::format("#inputSyntax {0}:\n{0} is not in enumeration: {1}", word,
                         listOf({"slash", "dot", "default"})),
             name.line);
    state_.syntax = syntax->second;
}

/// "#remove a", "#remove (a b)", "#remove "wall.*"": strings are regular expressions. What is not
/// there needs no removal.
void DictionaryParser::removeEntries(const Lexeme& name)
{
    auto& content = DictionaryAccess::content(current());
    const auto removeOne = [&](const Lexeme& what) {
        if (what.kind != Lexeme::Kind::word && what.kind != Lexeme::Kind::string)
            fail(fmt::format("#remove is followed by '{}': expected keywords", what.text),
                 name.line);
        const bool pattern = what.kind == Lexeme::Kind::string;
        const std::regex expression = patternOf(pattern ? what.text : "", here(name));
        const auto matches = [&](const DictionaryEntry& entry) {
            return pattern ? entry.key == what.text || std::regex_match(entry.key, expression)
                           : entry.key == what.text;
        };
        for (std::size_t k = content.entries.size(); k-- > 0;)
            if (matches(content.entries[k])) content.erase(&content.entries[k]);
    };
    Lexeme what = lexer_.next();
    if (!what.is('(')) return removeOne(what);
    for (what = lexer_.next(); !what.is(')'); what = lexer_.next()) removeOne(what);
}

bool DictionaryParser::condition(const Lexeme& name)
{
    std::vector<Token> tokens;
    appendValue(tokens, lexer_.next());
    if (name.text == "ifeq") {
        std::vector<Token> other;
        appendValue(other, lexer_.next());
        const bool numbers = tokens.size() == 1 && other.size() == 1 &&
                             tokens[0].kind == Token::Kind::number &&
                             other[0].kind == Token::Kind::number;
        if (numbers) return tokens[0].number == other[0].number;
        return std::equal(tokens.begin(), tokens.end(), other.begin(), other.end(),
                          [](const Token& a, const Token& b) { return a.text == b.text; });
    }
    const std::string text = textOf(tokens);
    if (tokens.size() == 1 && tokens[0].kind == Token::Kind::number) return tokens[0].number != 0;
    if (text == "yes" || text == "on" || text == "true") return true;
    if (text == "no" || text == "off" || text == "false") return false;
    fail(fmt::format("#if {}: expected a switch (yes, no, on, off, true, false) or a number", text),
         name.line);
}

void DictionaryParser::beginBranch(const Lexeme& name)
{
    branches_.push_back({name.line, false});
    if (!condition(name)) skipBranch();
}

/// Reached at the end of a branch that was read: the other one is skipped.
void DictionaryParser::elseBranch(const Lexeme& name)
{
    if (branches_.empty() || branches_.back().elseSeen)
        fail("#else without an #if before it", name.line);
    branches_.back().elseSeen = true;
    skipBranch();
}

void DictionaryParser::endBranch(const Lexeme& name)
{
    if (branches_.empty()) fail("#endif without an #if before it", name.line);
    branches_.pop_back();
}

/// Goes on after the #else or #endif that belongs to the innermost #if.
void DictionaryParser::skipBranch()
{
    for (int depth = 0;;) {
        const Lexeme lexeme = lexer_.next();
        if (lexeme.kind == Lexeme::Kind::end)
            fail("The #if is not ended: an #endif is missing", branches_.back().line);
        if (lexeme.kind != Lexeme::Kind::directive) continue;
        if (lexeme.text == "if" || lexeme.text == "ifeq") ++depth;
        if (lexeme.text == "else" && depth == 0) {
            if (branches_.back().elseSeen) fail("A second #else of one #if", lexeme.line);
            branches_.back().elseSeen = true;
            return;
        }
        if (lexeme.text == "endif" && depth-- == 0) {
            branches_.pop_back();
            return;
        }
    }
}

void DictionaryParser::calculate(std::vector<Token>& tokens, const Lexeme& name)
{
    const bool braces = lexer_.peek().is('{');
    const Lexeme lexeme = braces ? lexer_.bracedText() : lexer_.next();
    if (lexeme.kind != Lexeme::Kind::string && lexeme.kind != Lexeme::Kind::verbatim)
        fail(
            fmt::format("#{0} is followed by '{1}': expected an expression in quotes, #{0} \"...\"",
                        name.text, lexeme.text),
            name.line);
    const std::string expression = expandText(lexeme.text, lexeme.line, true);
    try {
        const double value = evaluate(expression);
        tokens.push_back({Token::Kind::number, fmt::format("{}", value), value, here(name)});
    } catch (const std::runtime_error& error) {
        fail(fmt::format("#{} \"{}\" cannot be evaluated: {}\n(with the variables put in: {})",
                         name.text, lexeme.text, error.what(), expression),
             name.line);
    }
}

void DictionaryParser::negate(std::vector<Token>& tokens, const Lexeme& name)
{
    const std::size_t first = tokens.size();
    int depth = 0;
    do {
        const Lexeme lexeme = lexer_.next();
        if (lexeme.kind == Lexeme::Kind::end)
            fail("#neg is followed by a list that does not end", name.line);
        depth += (lexeme.is('(') ? 1 : 0) - (lexeme.is(')') ? 1 : 0);
        appendValue(tokens, lexeme);
    } while (depth > 0);
    bool numbers = false;
    for (std::size_t k = first; k < tokens.size(); ++k) {
        if (tokens[k].kind == Token::Kind::number) {
            numbers = true;
            tokens[k].number = -tokens[k].number;
            const std::string& text = tokens[k].text;
            tokens[k].text =
                text[0] == '-' ? text.substr(1) : "-" + text.substr(text[0] == '+' ? 1 : 0);
        } else if (tokens[k].text != "(" && tokens[k].text != ")") {
            fail(fmt::format("#neg is followed by '{}': expected numbers", tokens[k].text),
                 name.line);
        }
    }
    if (!numbers) fail("#neg is followed by no number", name.line);
}

}  // namespace isph
