// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/DictionaryParser.hpp"

#include "core/Error.hpp"
#include "core/Log.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
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

char closing(char open)
{
    return open == '(' ? ')' : open == '[' ? ']' : '}';
}

}  // namespace

std::string textOfFile(const std::filesystem::path& file)
{
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::error_code ignored;
    const int cause = std::filesystem::is_directory(file, ignored) ? EISDIR : errno;
    if (!stream || cause == EISDIR)
        throw FatalIOError(fmt::format("cannot open file: {}", std::strerror(cause)), file.string(),
                           0);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

namespace {

/// FoamFile names format, class and object where it is there at all.
void checkHeader(const Dictionary& top)
{
    if (!top.found("FoamFile")) return;
    const Dictionary& header = top.subDict("FoamFile");
    header.getChoice("format", {"ascii", "binary"});
    header.get<std::string>("class");
    header.get<std::string>("object");
}

}  // namespace

Dictionary DictionaryParser::readFile(const std::filesystem::path& file)
{
    Dictionary top = parseText(textOfFile(file), file.string());
    checkHeader(top);
    return top;
}

Dictionary DictionaryParser::parseText(std::string_view text, const std::string& name)
{
    Dictionary top;
    DictionaryAccess::content(top).name = name;
    DictionaryAccess::content(top).at = {name, 1};
    ParserState state;
    state.scopes = {&top};
    state.files = {std::filesystem::weakly_canonical(name)};
    Lexer lexer(text, name);
    DictionaryParser(lexer, state).parseBody();
    return top;
}

void DictionaryParser::fail(const std::string& message, int line) const
{
    throw FatalIOError(message, lexer_.file(), line);
}

void DictionaryParser::failUnclosed() const
{
    std::string message = fmt::format(
        "The '{{' opened in line {} (dictionary \"{}\") is not closed: a '}}' is missing",
        open_.back().line, state_.scopes.back()->name());
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
                if (!branches_.empty())
                    fail("The #if is not ended: an #endif is missing", branches_.back().line);
                return;
            case Lexeme::Kind::word:
            case Lexeme::Kind::string:
                parseEntry(std::move(lexeme));
                break;
            case Lexeme::Kind::variable:
                if (!mergeVariable(lexeme)) parseEntry(keyFromVariable(lexeme));
                break;
            case Lexeme::Kind::directive:
                directive(lexeme);
                break;
            default:
                if (lexeme.is(';')) break;
                if (lexeme.is('}') && !open_.empty())
                    closeBrace(lexeme);
                else
                    fail(fmt::format("Expected a keyword, found '{}'", lexeme.text), lexeme.line);
        }
    }
}

void DictionaryParser::closeBrace(const Lexeme& brace)
{
    const OpenBrace& opened = open_.back();
    if (indentHint_.empty() && brace.line != opened.line &&
        lexer_.indentOf(brace.begin) != opened.indent)
        indentHint_ = fmt::format(
            "By its indentation the '}}' in line {} does not belong to the '{{' in line {} that it "
            "closes",
            brace.line, opened.line);
    open_.pop_back();
    state_.scopes.pop_back();
}

void DictionaryParser::parseEntry(Lexeme key)
{
    DictionaryEntry entry{key.text, here(key)};
    if (key.kind == Lexeme::Kind::string) {
        entry.key = expandText(key.text, key.line, false);
        entry.pattern = patternOf(entry.key, entry.at);
    }
    if (lexer_.peek().is('{')) {
        parseSubDict(std::move(entry), lexer_.next());
        return;
    }
    if (lexer_.peek().kind == Lexeme::Kind::variable) {
        const Lexeme variable = lexer_.next();
        if (copyDict(entry, variable)) return;
        refuseDict(variable, key);
        appendVariable(entry.tokens, variable);
    }
    parseValue(entry.tokens, key);
    place(std::move(entry));
}

const DictionaryEntry* DictionaryParser::existing(const DictionaryEntry& entry)
{
    auto& content = DictionaryAccess::content(current());
    return entry.pattern ? content.findPattern(entry.key) : content.findExact(entry.key);
}

/// What #inputMode says to an entry whose keyword is there already.
bool DictionaryParser::admits(const DictionaryEntry& entry)
{
    const DictionaryEntry* old = existing(entry);
    if (!old || state_.mode == InputMode::merge || state_.mode == InputMode::overwrite) return true;
    const std::string twice =
        fmt::format("keyword {} of dictionary \"{}\" is set again; it was set in {} at line {}",
                    entry.key, current().name(), old->at.file, old->at.line);
    if (state_.mode == InputMode::error) fail(twice + " (#inputMode error)", entry.at.line);
    if (state_.mode == InputMode::warn)
        warning("{}: the first one is kept (#inputMode warn)\nfile: {} at line {}.", twice,
                entry.at.file, entry.at.line);
    return false;
}

void DictionaryParser::place(DictionaryEntry entry)
{
    if (admits(entry)) DictionaryAccess::content(current()).put(std::move(entry));
}

void DictionaryParser::parseSubDict(DictionaryEntry entry, const Lexeme& brace)
{
    constexpr std::size_t most = 200;  // far above any case's, far below what recursion bears
    if (state_.scopes.size() > most)
        fail(fmt::format("Dictionaries are nested more than {} deep: is a '}}' missing?", most),
             brace.line);
    OpenBrace opened{brace.line, lexer_.indentOf(brace.begin)};
    const DictionaryEntry* old = existing(entry);
    Dictionary* dict = old && state_.mode == InputMode::merge ? old->dict.get() : nullptr;
    if (!dict) {
        entry.dict = std::make_unique<Dictionary>();
        DictionaryAccess::content(*entry.dict).name = current().name() + "/" + entry.key;
        DictionaryAccess::content(*entry.dict).at = entry.at;
        dict = entry.dict.get();
        if (admits(entry))
            DictionaryAccess::content(current()).put(std::move(entry));
        else
            opened.discarded = std::move(entry.dict);
    }
    state_.scopes.push_back(dict);
    open_.push_back(std::move(opened));
}

void DictionaryParser::parseValue(std::vector<Token>& tokens, const Lexeme& key)
{
    std::vector<Lexeme> opened;
    for (;;) {
        const Lexeme lexeme = lexer_.next();
        const bool ended = lexeme.kind == Lexeme::Kind::end;
        if (ended && !opened.empty())
            fail(fmt::format("The '{}' opened in line {} (entry '{}') is not closed",
                             opened.back().text, opened.back().line, key.text),
                 opened.back().line);
        if (opened.empty() && lexeme.is(';')) return checkBrackets(tokens, key);
        if (opened.empty() &&
            (ended || lexeme.is('}') ||
             (lexeme.is('{') && !tokens.empty() && tokens.back().kind != Token::Kind::number)))
            fail(fmt::format("The entry '{}' does not end: a ';' is missing before line {}",
                             key.text, lexeme.line),
                 key.line);
        if (opened.empty() || !opened.back().is('{')) refuseDict(lexeme, key);
        if (lexeme.is('(') || lexeme.is('[') || lexeme.is('{')) opened.push_back(lexeme);
        if (lexeme.is(')') || lexeme.is(']') || lexeme.is('}')) {
            if (opened.empty() || closing(opened.back().text[0]) != lexeme.text[0])
                fail(fmt::format("Unexpected '{}' in entry '{}'", lexeme.text, key.text),
                     lexeme.line);
            opened.pop_back();
        }
        appendValue(tokens, lexeme);
    }
}

/// What #include brought into a value may have brackets of its own.
void DictionaryParser::checkBrackets(const std::vector<Token>& tokens, const Lexeme& key) const
{
    std::string awaited;
    for (const Token& token : tokens) {
        if (token.kind != Token::Kind::punctuation) continue;
        const char mark = token.text[0];
        if (mark == '(' || mark == '[' || mark == '{') awaited += closing(mark);
        if (mark != ')' && mark != ']' && mark != '}') continue;
        if (awaited.empty() || awaited.back() != mark)
            throw FatalIOError(fmt::format("Unexpected '{}' in entry '{}'", mark, key.text),
                               token.at.file, token.at.line);
        awaited.pop_back();
    }
    if (!awaited.empty())
        fail(fmt::format("A '{}' is missing in entry '{}'", awaited.back(), key.text), key.line);
}

void DictionaryParser::appendValue(std::vector<Token>& tokens, const Lexeme& lexeme)
{
    if (lexeme.kind == Lexeme::Kind::variable) return appendVariable(tokens, lexeme);
    if (lexeme.kind == Lexeme::Kind::directive) return valueDirective(tokens, lexeme);
    tokens.push_back(tokenOf(lexeme, lexer_.file()));
    if (lexeme.kind == Lexeme::Kind::string)
        tokens.back().text = expandText(lexeme.text, lexeme.line, false);
}

}  // namespace isph
