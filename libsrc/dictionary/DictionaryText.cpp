// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical form of a dictionary, and changes that are given as text.
#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"

#include <fmt/core.h>

namespace isph {

namespace {

constexpr std::size_t kValueColumn = 16;  ///< where OpenFOAM's writers put the values

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '\\' && k + 1 < text.size()) {
            out += text[k++];
        } else if (text[k] == '"') {
            out += '\\';
        }
        out += text[k];
    }
    return out + '"';
}

bool opens(const Token& token)
{
    return token.kind == Token::Kind::punctuation && (token.text == "(" || token.text == "[");
}
bool closes(const Token& token)
{
    return token.kind == Token::Kind::punctuation &&
           (token.text == ")" || token.text == "]" || token.text == ";" || token.text == ",");
}
/// No space between these two: inside brackets and in the count of 3(a b c) and 2{0.5}.
bool joined(const std::vector<Token>& tokens, std::size_t k)
{
    const bool uniform = tokens.size() == 4 && tokens[1].text == "{";
    const bool counted =
        k == 1 && tokens[0].kind == Token::Kind::number && (uniform || opens(tokens[1]));
    return counted || uniform || opens(tokens[k - 1]) || closes(tokens[k]);
}

}  // namespace

std::vector<std::string> partsOf(std::string_view path)
{
    std::vector<std::string> parts;
    while (!path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        if (slash > 0) parts.emplace_back(path.substr(0, slash));
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return parts;
}

std::string textOf(const Token& token)
{
    if (token.kind == Token::Kind::string) return quoted(token.text);
    if (token.kind == Token::Kind::verbatim) return "#{" + token.text + "#}";
    return token.text;
}

std::string textOf(const std::vector<Token>& tokens)
{
    std::string text;
    for (std::size_t k = 0; k < tokens.size(); ++k) {
        if (k > 0 && !joined(tokens, k)) text += ' ';
        text += textOf(tokens[k]);
    }
    return text;
}

std::string Dictionary::valueText(std::string_view key) const
{
    return isDict(key) ? "{\n" + subDict(key).toString(1) + "}" : textOf(tokens(key));
}

std::string Dictionary::toString(int indent) const
{
    const std::string margin(static_cast<std::size_t>(4 * indent), ' ');
    std::string text;
    for (const DictionaryEntry& entry : content_->entries) {
        const std::string key = entry.pattern ? quoted(entry.key) : entry.key;
        if (entry.dict) {
            text += margin + key + "\n" + margin + "{\n" + entry.dict->toString(indent + 1) +
                    margin + "}\n";
        } else {
            const std::size_t pad = std::max(kValueColumn, key.size() + 1) - key.size();
            text += margin + key +
                    (entry.tokens.empty() ? "" : std::string(pad, ' ') + textOf(entry.tokens)) +
                    ";\n";
        }
    }
    return text;
}

void Dictionary::set(std::string_view path, const std::string& value)
{
    const std::vector<std::string> parts = partsOf(path);
    if (parts.empty()) throw FatalError("A dictionary entry needs a keyword");
    std::string text = parts.back() + " " + value;
    if (value.find_first_not_of(" \t\n") == std::string::npos ||
        value[value.find_first_not_of(" \t\n")] != '{')
        text += ";";
    for (std::size_t k = parts.size() - 1; k-- > 0;) text = parts[k] + " { " + text + " }";
    const Dictionary change = Dictionary::parse(text, name());
    const Dictionary* from = &change;
    Dictionary* into = this;
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {  // walk down as far as both agree
        DictionaryEntry* next = into->content_->findExact(parts[k]);
        if (!next || !next->dict) break;
        into = next->dict.get();
        from = &from->subDict(parts[k]);
    }
    DictionaryEntry entry = from->content_->entries.front().clone();
    if (const DictionaryEntry* old = into->content_->find(entry.key))
        entry.at = old->at;
    else
        entry.at = into->content_->at;
    into->content_->put(std::move(entry));
}

void Dictionary::remove(std::string_view path)
{
    const std::vector<std::string> parts = partsOf(path);
    Dictionary* from = this;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        DictionaryEntry* entry = from->content_->findExact(parts[k]);
        if (!entry || (k + 1 < parts.size() && !entry->dict)) failUndefined(*from, parts[k]);
        if (k + 1 == parts.size())
            from->content_->erase(entry);
        else
            from = entry->dict.get();
    }
}

}  // namespace isph
