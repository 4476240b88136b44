// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/DictionaryParser.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <fstream>
#include <sstream>

namespace isph {

namespace {

Token tokenOf(const Lexeme& lexeme, const std::string& file)
{
    using From = Lexeme::Kind;
    Token::Kind kind = Token::Kind::word;
    if (lexeme.kind == From::string) kind = Token::Kind::string;
    if (lexeme.kind == From::number) kind = Token::Kind::number;
    if (lexeme.kind == From::punctuation) kind = Token::Kind::punctuation;
    if (lexeme.kind == From::verbatim) kind = Token::Kind::verbatim;
    return {kind, lexeme.text, lexeme.number, {file, lexeme.line}};
}

char closing(char open) { return open == '(' ? ')' : open == '[' ? ']' : '}'; }

}  // namespace

DictionaryParser::DictionaryParser(Lexer& lexer, Dictionary& top) : lexer_(lexer), scopes_{&top} {}

Dictionary DictionaryParser::readFile(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw FatalIOError("cannot open file", file.string(), 0);
    std::ostringstream text;
    text << stream.rdbuf();
    return parseText(text.str(), file.string());
}

Dictionary DictionaryParser::parseText(std::string_view text, const std::string& name)
{
    Dictionary top;
    DictionaryAccess::content(top).name = name;
    DictionaryAccess::content(top).at = {name, 1};
    Lexer lexer(text, name);
    DictionaryParser(lexer, top).parseBody();
    return top;
}

void DictionaryParser::fail(const std::string& message, int line) const
{
    throw FatalIOError(message, lexer_.file(), line);
}

void DictionaryParser::failUnclosed() const
{
    std::string message = fmt::format("The '{{' opened in line {} (dictionary \"{}\") is not closed: a '}}' is missing",
                                      open_.back().line, scopes_.back()->name());
    if (!indentHint_.empty()) message += "\n" + indentHint_;
    fail(message, open_.back().line);
}

void DictionaryParser::parseBody()
{
    for (;;) {
        Lexeme lexeme = lexer_.next();
        switch (lexeme.kind) {
        case Lexeme::Kind::end:
            if (!open_.empty()) failUnclosed();
            return;
        case Lexeme::Kind::word:
        case Lexeme::Kind::string:
            parseEntry(std::move(lexeme));
            break;
        default:
            if (lexeme.is(';')) break;
            if (lexeme.is('}') && !open_.empty()) closeBrace(lexeme);
            else fail(fmt::format("Expected a keyword, found '{}'", lexeme.text), lexeme.line);
        }
    }
}

void DictionaryParser::closeBrace(const Lexeme& brace)
{
    const OpenBrace opened = open_.back();
    if (indentHint_.empty() && brace.line != opened.line && lexer_.indentOf(brace.begin) != opened.indent)
        indentHint_ = fmt::format("By its indentation the '}}' in line {} does not belong to the '{{' in line {} that it closes",
                                  brace.line, opened.line);
    open_.pop_back();
    scopes_.pop_back();
}

void DictionaryParser::parseEntry(Lexeme key)
{
    DictionaryEntry entry{key.text, here(key)};
    if (key.kind == Lexeme::Kind::string) {
        try {
            entry.pattern.emplace(key.text);
        } catch (const std::regex_error& error) {
            fail(fmt::format("The keyword \"{}\" is not a regular expression: {}", key.text, error.what()), key.line);
        }
    }
    if (lexer_.peek().is('{')) {
        parseSubDict(std::move(entry), lexer_.next());
        return;
    }
    entry.tokens = parseValue(key);
    DictionaryAccess::content(current()).put(std::move(entry));
}

void DictionaryParser::parseSubDict(DictionaryEntry entry, const Lexeme& brace)
{
    auto& parent = DictionaryAccess::content(current());
    const DictionaryEntry* old = entry.pattern ? parent.findPattern(entry.key) : parent.findExact(entry.key);
    Dictionary* dict = old ? old->dict.get() : nullptr;
    if (!dict) {
        entry.dict = std::make_unique<Dictionary>();
        DictionaryAccess::content(*entry.dict).name = current().name() + "/" + entry.key;
        DictionaryAccess::content(*entry.dict).at = entry.at;
        dict = parent.put(std::move(entry)).dict.get();
    }
    scopes_.push_back(dict);
    open_.push_back({brace.line, lexer_.indentOf(brace.begin)});
}

std::vector<Token> DictionaryParser::parseValue(const Lexeme& key)
{
    std::vector<Token> tokens;
    std::vector<Lexeme> opened;
    for (;;) {
        const Lexeme lexeme = lexer_.next();
        const bool ended = lexeme.kind == Lexeme::Kind::end;
        if (ended && !opened.empty())
            fail(fmt::format("The '{}' opened in line {} (entry '{}') is not closed", opened.back().text,
                             opened.back().line, key.text), opened.back().line);
        if (opened.empty() && lexeme.is(';')) return tokens;
        if (opened.empty() && (ended || lexeme.is('}') || (lexeme.is('{') && !tokens.empty() && tokens.back().kind != Token::Kind::number)))
            fail(fmt::format("The entry '{}' does not end: a ';' is missing before line {}", key.text, lexeme.line), key.line);
        if (lexeme.is('(') || lexeme.is('[') || lexeme.is('{')) opened.push_back(lexeme);
        if (lexeme.is(')') || lexeme.is(']') || lexeme.is('}')) {
            if (opened.empty() || closing(opened.back().text[0]) != lexeme.text[0])
                fail(fmt::format("Unexpected '{}' in entry '{}'", lexeme.text, key.text), lexeme.line);
            opened.pop_back();
        }
        appendValue(tokens, lexeme);
    }
}

void DictionaryParser::appendValue(std::vector<Token>& tokens, const Lexeme& lexeme)
{
    if (lexeme.kind == Lexeme::Kind::variable) fail(fmt::format("Macro ${} is not understood", lexeme.text), lexeme.line);
    if (lexeme.kind == Lexeme::Kind::directive) fail(fmt::format("Directive #{} is not understood", lexeme.text), lexeme.line);
    tokens.push_back(tokenOf(lexeme, lexer_.file()));
}

}  // namespace isph
