// SPDX-License-Identifier: GPL-3.0-or-later
// Where the entries of a text stand; changes of the text are in DictionaryEdit.cpp.
#include "dictionary/DictionarySource.hpp"

#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/Lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace isph {

namespace {

/// A brace within a value: 2{0.5}, #eval{ 1 + 2 }, or ${n}{0.5}.
bool mayPrecedeBrace(const Lexeme& lexeme)
{
    return lexeme.kind == Lexeme::Kind::number || lexeme.kind == Lexeme::Kind::directive ||
           lexeme.kind == Lexeme::Kind::variable;
}

}  // namespace

DictionarySource::DictionarySource(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name))
{
    parse();
}

DictionarySource DictionarySource::read(const std::filesystem::path& file)
{
    return {textOfFile(file), file.string()};
}

void DictionarySource::parse()
{
    Lexer lexer(text_, name_);
    top_ = Item{};
    top_.isDict = true;
    top_.end = text_.size();
    parseItems(lexer, top_, false);
}

/// Returns the offset behind the closing brace.
std::size_t DictionarySource::parseItems(Lexer& lexer, Item& into, bool nested)
{
    for (;;) {
        const Lexeme lexeme = lexer.next();
        if (lexeme.kind == Lexeme::Kind::end) {
            if (nested)
                throw FatalIOError(
                    fmt::format("The '{{' of '{}' is not closed: a '}}' is missing", into.key),
                    name_, into.line);
            return lexeme.end;
        }
        if (lexeme.is('}') && nested) return lexeme.end;
        if (lexeme.is(';')) continue;
        if (lexeme.kind == Lexeme::Kind::punctuation || lexeme.kind == Lexeme::Kind::number ||
            lexeme.kind == Lexeme::Kind::verbatim)
            throw FatalIOError(fmt::format("Expected a keyword, found '{}'", lexeme.text), name_,
                               lexeme.line);
        into.items.push_back(parseItem(lexer, lexeme));
    }
}

DictionarySource::Item DictionarySource::parseItem(Lexer& lexer, const Lexeme& first)
{
    Item item;
    item.key = text_.substr(first.begin, first.end - first.begin);
    item.line = first.line;
    item.begin = first.begin;
    item.end = item.valueBegin = item.valueEnd = first.end;
    item.isDirective =
        first.kind == Lexeme::Kind::directive || first.kind == Lexeme::Kind::variable;
    if (first.kind == Lexeme::Kind::directive) {
        skipDirective(lexer, first, item);
        if (lexer.peek().is(';')) item.end = lexer.next().end;
        return item;
    }
    if (lexer.peek().is('{')) {
        item.isDict = true;
        item.valueBegin = lexer.next().begin;
        item.end = item.valueEnd = parseItems(lexer, item, true);
        return item;
    }
    int depth = 0;
    Lexeme before = first;
    for (Lexeme lexeme = lexer.next();; lexeme = lexer.next()) {
        if (depth == 0 && lexeme.is(';')) {
            item.end = lexeme.end;
            return item;
        }
        const bool strayBrace = depth == 0 && lexeme.is('{') && !mayPrecedeBrace(before);
        if (lexeme.is('(') || lexeme.is('[') || lexeme.is('{')) ++depth;
        if (lexeme.is(')') || lexeme.is(']') || lexeme.is('}')) --depth;
        if (lexeme.kind == Lexeme::Kind::end || depth < 0 || strayBrace)
            throw FatalIOError(
                fmt::format("The entry '{}' does not end: a ';' is missing before line {}",
                            item.key, lexeme.line),
                name_, item.line);
        if (item.valueEnd == first.end) item.valueBegin = lexeme.begin;
        item.valueEnd = lexeme.end;
        before = lexeme;
    }
}

/// Takes the arguments of a directive that stands where a keyword could.
void DictionarySource::skipDirective(Lexer& lexer, const Lexeme& name, Item& item)
{
    int arguments = 1;
    if (name.text == "else" || name.text == "endif") arguments = 0;
    if (name.text == "ifeq") arguments = 2;
    for (; arguments > 0; --arguments) {
        Lexeme lexeme = lexer.next();
        if (lexeme.kind == Lexeme::Kind::directive) {  // #if #calc "..."
            const bool braces = lexer.peek().is('{');
            lexeme = braces ? lexer.bracedText() : lexer.next();
        }
        item.end = lexeme.end;
        for (int depth = lexeme.is('(') ? 1 : 0; depth > 0 && lexeme.kind != Lexeme::Kind::end;
             item.end = lexeme.end) {
            lexeme = lexer.next();
            depth += (lexeme.is('(') ? 1 : 0) - (lexeme.is(')') ? 1 : 0);
        }
    }
    if (name.text != "includeFunc" || !lexer.peek().is('(')) return;
    for (int depth = 0; depth > 0 || lexer.peek().is('(');) {  // #includeFunc probes (U, p)
        const Lexeme lexeme = lexer.next();
        if (lexeme.kind == Lexeme::Kind::end) return;
        depth += (lexeme.is('(') ? 1 : 0) - (lexeme.is(')') ? 1 : 0);
        item.end = lexeme.end;
    }
}

/// Every place where the path stands: dictionaries may be written in several parts.
std::vector<const DictionarySource::Item*> DictionarySource::occurrences(const Path& path) const
{
    std::vector<const Item*> found{&top_};
    for (const std::string& key : path) {
        std::vector<const Item*> next;
        for (const Item* dict : found)
            for (const Item& item : dict->items)
                if (!item.isDirective && item.key == key) next.push_back(&item);
        found = std::move(next);
    }
    return found;
}

const DictionarySource::Item& DictionarySource::itemAt(std::string_view path) const
{
    const Path parts = partsOf(path);
    const std::vector<const Item*> found = occurrences(parts);
    if (!found.empty()) return effective(found, parts);
    const Path scope(parts.begin(), parts.end() - 1);
    const Item* match = nullptr;
    for (const Item* dict : occurrences(scope))
        for (const Item& item : dict->items)
            if (item.key[0] == '"' &&
                std::regex_match(parts.back(), patternOf(item.key.substr(1, item.key.size() - 2),
                                                         {name_, item.line})))
                match = &item;
    if (!match) failAbsent(parts);
    return *match;
}

/// Of several occurrences the one that the resolved dictionary takes (branches of #if); the last
/// where it takes none.
const DictionarySource::Item& DictionarySource::effective(const std::vector<const Item*>& found,
                                                          const Path& path) const
{
    if (found.size() == 1) return *found.front();
    try {
        const Dictionary whole = Dictionary::parse(text_, name_);
        const Dictionary* dict = &whole;
        for (std::size_t k = 0; k + 1 < path.size(); ++k) dict = &dict->subDict(path[k]);
        const Location at = dict->location(path.back());
        for (auto item = found.rbegin(); item != found.rend(); ++item)
            if (at.file == name_ && (*item)->line == at.line) return **item;
    } catch (const FatalError&) {
        // What does not resolve can still be mended: the last one it is.
    }
    return *found.back();
}

void DictionarySource::failAbsent(const Path& path) const
{
    const Path scope(path.begin(), path.end() - 1);
    std::vector<std::string> keys;
    for (const Item* dict : occurrences(scope))
        for (const Item& item : dict->items)
            if (!item.isDirective) keys.push_back(item.key);
    const std::string near = nearestName(path.back(), keys);
    throw FatalIOError(
        fmt::format(
            "Cannot find entry {}{}\n(What macros and #include bring is seen with -expand.)",
            fmt::join(path, "/"), near.empty() ? "" : fmt::format("\nDid you mean '{}'?", near)),
        name_, 0);
}

std::vector<std::string> DictionarySource::keywords(std::string_view path) const
{
    const Path parts = partsOf(path);
    const std::vector<const Item*> found = occurrences(parts);
    if (found.empty()) failAbsent(parts);
    std::vector<std::string> keys;
    for (const Item* dict : found) {
        if (!dict->isDict)
            throw FatalIOError(fmt::format("'{}' is not a dictionary", dict->key), name_,
                               dict->line);
        for (const Item& item : dict->items)
            if (!item.isDirective && std::find(keys.begin(), keys.end(), item.key) == keys.end())
                keys.push_back(item.key);
    }
    return keys;
}

bool DictionarySource::found(std::string_view path) const
{
    return !occurrences(partsOf(path)).empty();
}

std::string DictionarySource::entryText(std::string_view path) const
{
    const Item& item = itemAt(path);
    return text_.substr(item.begin, item.end - item.begin);
}

std::string DictionarySource::valueText(std::string_view path) const
{
    const Item& item = itemAt(path);
    return text_.substr(item.valueBegin, item.valueEnd - item.valueBegin);
}

}  // namespace isph
