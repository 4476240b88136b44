// SPDX-License-Identifier: GPL-3.0-or-later
// $name in all its spellings: entries of this and the enclosing dictionaries, then the environment.
#include "core/Error.hpp"
#include "dictionary/DictionaryParser.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

namespace isph {

namespace {

using Scopes = std::vector<Dictionary*>;

/// Marks the entry so that schemas know it for a variable of the user's.
const DictionaryEntry* entryOf(const Dictionary& dict, std::string_view key)
{
    const DictionaryEntry* entry = DictionaryAccess::content(dict).findExact(key);
    if (entry) entry->usedByMacro = true;
    return entry;
}

const DictionaryEntry* findOutward(const Scopes& scopes, std::string_view key)
{
    for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope)
        if (const DictionaryEntry* entry = entryOf(**scope, key)) return entry;
    return nullptr;
}

/// "a/b/c" or "a.b.c" below a dictionary. Keywords may hold dots themselves, so the longest head is
/// tried first.
const DictionaryEntry* findBelow(const Dictionary& dict, std::string_view path, char separator)
{
    if (const DictionaryEntry* entry = entryOf(dict, path)) return entry;
    for (std::size_t k = path.rfind(separator); k != std::string_view::npos && k > 0;
         k = path.rfind(separator, k - 1)) {
        const DictionaryEntry* head = entryOf(dict, path.substr(0, k));
        if (!head || !head->dict) continue;
        if (const DictionaryEntry* entry = findBelow(*head->dict, path.substr(k + 1), separator))
            return entry;
    }
    return nullptr;
}

/// The head of the path is sought outward, the rest below it.
const DictionaryEntry* findScoped(const Scopes& scopes, std::string_view path, char separator)
{
    for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope)
        if (const DictionaryEntry* entry = findBelow(**scope, path, separator)) return entry;
    return nullptr;
}

const DictionaryEntry* findSlash(const Scopes& scopes, std::string_view name)
{
    if (name.starts_with('!')) {
        name.remove_prefix(name.starts_with("!/") ? 2 : 1);
        return findBelow(*scopes.front(), name, '/');
    }
    if (!name.starts_with("../") && !name.starts_with("./")) return findScoped(scopes, name, '/');
    std::size_t level = scopes.size() - 1;
    while (name.starts_with("../") || name.starts_with("./")) {
        if (name.starts_with("../") && level-- == 0) return nullptr;
        name.remove_prefix(name.find('/') + 1);
    }
    return findBelow(*scopes[level], name, '/');
}

const DictionaryEntry* findDot(const Scopes& scopes, std::string_view name)
{
    if (name.starts_with(':') || name.starts_with('^'))
        return findBelow(*scopes.front(), name.substr(1), '.');
    if (!name.starts_with('.')) return findScoped(scopes, name, '.');
    const std::size_t dots =
        std::min(name.find_first_not_of('.'), name.size());  // one: here, two: the parent
    return dots > scopes.size() ? nullptr
                                : findBelow(*scopes[scopes.size() - dots], name.substr(dots), '.');
}

bool isDotSpelling(std::string_view name)
{
    return name.starts_with(':') || name.starts_with('^') ||
           (name.starts_with('.') && !name.starts_with("./") && !name.starts_with("../"));
}

bool isNameCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("_./:!^").find(c) != std::string_view::npos;
}

/// The tokens of a dictionary's entries, for a dictionary that stands in a list.
void appendContents(std::vector<Token>& tokens, const Dictionary& dict, const Location& at)
{
    const auto mark = [&](const char* text) {
        tokens.push_back({Token::Kind::punctuation, text, 0, at});
    };
    for (const DictionaryEntry& entry : DictionaryAccess::content(dict).entries) {
        tokens.push_back(
            {entry.pattern ? Token::Kind::string : Token::Kind::word, entry.key, 0, at});
        if (entry.dict) {
            mark("{");
            appendContents(tokens, *entry.dict, at);
            mark("}");
        } else {
            tokens.insert(tokens.end(), entry.tokens.begin(), entry.tokens.end());
            mark(";");
        }
    }
}

}  // namespace

const DictionaryEntry* DictionaryParser::findInFile(std::string_view file, std::string_view name)
{
    const std::filesystem::path path = relativeToThisFile(std::string(file));
    const auto known = state_.readForMacros.find(path);
    Dictionary& dict = known != state_.readForMacros.end()
                           ? known->second
                           : state_.readForMacros.emplace(path, readFile(path)).first->second;
    return findBelow(dict, name.substr(name.starts_with('/') ? 1 : 0), '/');
}

const DictionaryEntry* DictionaryParser::findMacro(std::string_view name)
{
    const Scopes& scopes = state_.scopes;
    if (const std::size_t mark = name.find('!'); mark != std::string_view::npos && mark > 0)
        return findInFile(name.substr(0, mark), name.substr(mark + 1));
    if (state_.syntax == InputSyntax::slash) return findSlash(scopes, name);
    if (state_.syntax == InputSyntax::dot) return findDot(scopes, name);
    if (isDotSpelling(name)) return findDot(scopes, name);
    if (const DictionaryEntry* entry = findOutward(scopes, name)) return entry;
    if (const DictionaryEntry* entry = findSlash(scopes, name)) return entry;
    return findDot(scopes, name);
}

void DictionaryParser::failUndefinedMacro(const std::string& name, int line)
{
    std::vector<std::string> names;
    for (const Dictionary* scope : state_.scopes)
        for (const std::string& key : scope->keywords()) names.push_back(key);
    const std::string near = nearestName(name, names);
    fail(fmt::format("Illegal dictionary entry or environment variable name \"{}\" in dictionary "
                     "\"{}\"{}\n\n"
                     "Valid dictionary entries are\n\n{}",
                     name, current().name(),
                     near.empty() ? "" : fmt::format("\nDid you mean '${}'?", near), listOf(names)),
         line);
}

/// Variables within the name, as in ${wall${n}}, are put in first.
std::string DictionaryParser::variableName(const Lexeme& variable)
{
    if (variable.text.empty()) fail("'$' without a name", variable.line);
    return variable.text.find('$') == std::string::npos
               ? variable.text
               : expandText(variable.text, variable.line, false);
}

void DictionaryParser::appendVariable(std::vector<Token>& tokens, const Lexeme& variable)
{
    const std::string name = variableName(variable);
    if (const DictionaryEntry* entry = findMacro(name)) {
        const std::size_t first = tokens.size();
        if (entry->dict) {  // "( a { $common; } )": the entries bring their own semicolons
            appendContents(tokens, *entry->dict, here(variable));
            if (lexer_.peek().is(';')) lexer_.next();
        } else {
            tokens.insert(tokens.end(), entry->tokens.begin(), entry->tokens.end());
        }
        for (std::size_t k = first; k < tokens.size(); ++k) tokens[k].at = here(variable);
        return;
    }
    const char* value = std::getenv(name.c_str());
    if (!value) failUndefinedMacro(name, variable.line);
    Lexer words(value, lexer_.file());
    const Lexeme only = words.next();
    const bool single = words.next().kind == Lexeme::Kind::end;
    Token token{Token::Kind::string, value, 0, here(variable)};
    if (single && only.kind == Lexeme::Kind::word) token.kind = Token::Kind::word;
    if (single && only.kind == Lexeme::Kind::number)
        token = {Token::Kind::number, only.text, only.number, here(variable)};
    tokens.push_back(std::move(token));
}

/// A dictionary can be a part of a value only within braces: in "a 1 $dict;" a semicolon is
/// missing.
void DictionaryParser::refuseDict(const Lexeme& lexeme, const Lexeme& key)
{
    if (lexeme.kind != Lexeme::Kind::variable) return;
    const DictionaryEntry* entry = findMacro(variableName(lexeme));
    if (entry && entry->dict)
        fail(fmt::format("'${}' in the value of '{}' is a dictionary. Is a ';' missing before it?",
                         lexeme.text, key.text),
             lexeme.line);
}

/// "$name;" where a keyword could stand: the entries of that dictionary come in here.
bool DictionaryParser::mergeVariable(const Lexeme& variable)
{
    if (!lexer_.peek().is(';')) return false;
    const std::string name = variableName(variable);
    const DictionaryEntry* entry = findMacro(name);
    if (!entry) failUndefinedMacro(name, variable.line);
    if (!entry->dict)
        fail(fmt::format("'${};' takes in a dictionary, but '{}' is none", name, name),
             variable.line);
    const Dictionary source = *entry->dict;  // a copy: the target may be its parent
    for (const DictionaryEntry& one : DictionaryAccess::content(source).entries)
        if (admits(one)) {
            Dictionary part;
            DictionaryAccess::content(part).put(one.clone());
            mergeInto(current(), part);
        }
    return true;
}

Lexeme DictionaryParser::keyFromVariable(const Lexeme& variable)
{
    std::vector<Token> tokens;
    appendVariable(tokens, variable);
    const bool isKey = tokens.size() == 1 && (tokens[0].kind == Token::Kind::word ||
                                              tokens[0].kind == Token::Kind::string);
    if (!isKey)
        fail(fmt::format("'${}' stands for '{}': a keyword is one word", variable.text,
                         textOf(tokens)),
             variable.line);
    Lexeme key = variable;
    key.kind = tokens[0].kind == Token::Kind::word ? Lexeme::Kind::word : Lexeme::Kind::string;
    key.text = tokens[0].text;
    return key;
}

/// "key $dict;": a copy of that dictionary under the new keyword.
bool DictionaryParser::copyDict(DictionaryEntry& entry, const Lexeme& variable)
{
    const DictionaryEntry* source = findMacro(variableName(variable));
    if (!source || !source->dict || !lexer_.peek().is(';')) return false;
    lexer_.next();
    entry.dict = std::make_unique<Dictionary>(*source->dict);
    DictionaryAccess::content(*entry.dict).at = entry.at;
    if (!admits(entry)) return true;
    Dictionary part;
    DictionaryAccess::content(part).put(std::move(entry));
    if (state_.mode == InputMode::overwrite)
        place(DictionaryAccess::content(part).entries.front().clone());
    else
        mergeInto(current(), part);
    return true;
}

/// What stands for $name in a string or an expression; empty where nothing is called so.
std::optional<std::string> DictionaryParser::macroText(const std::string& name, bool expression)
{
    const DictionaryEntry* entry = findMacro(name);
    const char* variable = entry ? nullptr : std::getenv(name.c_str());
    if (entry ? entry->dict != nullptr : variable == nullptr) return {};
    const bool single = entry && entry->tokens.size() == 1;
    const std::string text = single  ? entry->tokens[0].text
                             : entry ? textOf(entry->tokens)
                                     : variable;
    double value = 0;
    const bool negative =
        expression && spellsNumber(text, value) && value < 0;  // (-2)^2 is not -2^2
    return negative ? fmt::format("({})", text) : text;
}

/// Puts in the variables of a string. "$a/2" means $a where no entry is called "a/2". What names
/// nothing stays in strings (it may be a regular expression) and is an error in expressions.
std::string DictionaryParser::expandText(const std::string& text, int line, bool expression)
{
    std::string out;
    for (std::size_t k = 0; k < text.size();) {
        if (text[k] != '$' || (k > 0 && text[k - 1] == '\\')) {
            out += text[k++];
            continue;
        }
        const bool braces = k + 1 < text.size() && text[k + 1] == '{';
        const std::size_t begin = k + (braces ? 2 : 1);
        std::size_t end = begin;
        while (end < text.size() && (braces ? text[end] != '}' : isNameCharacter(text[end]))) ++end;
        std::optional<std::string> value;
        std::size_t used = end;
        while (!value && used > begin) {
            value = macroText(text.substr(begin, used - begin), expression);
            if (value || braces) break;
            const std::size_t cut = text.find_last_of("./:!^", used - 1);
            used = cut == std::string::npos || cut < begin ? begin : cut;
        }
        if (!value && expression) failUndefinedMacro(text.substr(begin, end - begin), line);
        if (!value) used = begin;
        out += value ? *value : text.substr(k, begin - k);
        k = used + (value && braces ? 1 : 0);
    }
    return out;
}

}  // namespace isph
