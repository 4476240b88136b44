// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Schema.hpp"

#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace isph {

namespace {

std::string rangeOf(const Key& key)
{
    std::string text;
    if (key.least) text += fmt::format("{} {:g}", key.openLeast ? ">" : ">=", *key.least);
    if (key.most)
        text += fmt::format("{}{} {:g}", key.least ? " and " : "",
                            key.openMost ? "<" : "<=", *key.most);
    return text;
}

void checkRange(const Dictionary& dict, const Key& key, double value)
{
    const bool low = key.least && (key.openLeast ? !(value > *key.least) : !(value >= *key.least));
    const bool high = key.most && (key.openMost ? !(value < *key.most) : !(value <= *key.most));
    if (low || high)
        dict.fail(
            key.name,
            fmt::format("keyword {} in dictionary \"{}\" is {:g}, allowed: {} {}\n({})", key.name,
                        dict.name(), value, key.name, rangeOf(key), key.description));
}

/// The words of a list or of a single value, for the check against the allowed ones.
void checkWords(const Dictionary& dict, const Key& key)
{
    if (key.allowed.empty()) return;
    if (key.type != KeyType::list) {
        dict.getChoice(key.name, key.allowed);
        return;
    }
    for (const std::string& word : dict.get<std::vector<std::string>>(key.name))
        if (std::find(key.allowed.begin(), key.allowed.end(), word) == key.allowed.end())
            dict.fail(key.name,
                      fmt::format("keyword {} in dictionary \"{}\":\n{} is not in enumeration: {}",
                                  key.name, dict.name(), word, listOf(key.allowed)));
}

void checkList(const Dictionary& dict, const Key& key)
{
    checkDimensions(dict, key.name, key.dimensions);
    const std::vector<Token>& tokens = dict.tokens(key.name);
    const bool opens = std::any_of(tokens.begin(), tokens.end(), [](const Token& t) {
        return t.kind == Token::Kind::punctuation &&
               (t.text == "(" || t.text == "{" || t.text == "[");
    });
    if (!opens)
        dict.fail(key.name,
                  fmt::format(
                      "keyword {} in dictionary \"{}\" has the value '{}': expected a list (a b c)",
                      key.name, dict.name(), textOf(tokens)));
}

void checkValue(const Dictionary& dict, const Key& key)
{
    switch (key.type) {
        case KeyType::scalar:  // or one of the allowed words: "relaxationTime auto;"
            if (!key.allowed.empty() && dict.tokens(key.name).front().kind == Token::Kind::word)
                break;
            checkRange(dict, key, dict.get<Real>(key.name, key.dimensions));
            return;
        case KeyType::integer:
            checkRange(dict, key, dict.get<int>(key.name, key.dimensions));
            break;
        case KeyType::word:
        case KeyType::text:
            dict.get<std::string>(key.name);
            break;
        case KeyType::logical:
            dict.get<bool>(key.name);
            break;
        case KeyType::vector:
            dict.get<Vector3>(key.name, key.dimensions);
            break;
        case KeyType::list:
            checkList(dict, key);
            break;
        case KeyType::dictionary:
            dict.subDict(key.name);
            break;
    }
    if (key.type != KeyType::dictionary) checkWords(dict, key);
}

std::string typeName(KeyType type)
{
    switch (type) {
        case KeyType::scalar:
            return "scalar";
        case KeyType::integer:
            return "integer";
        case KeyType::word:
            return "word";
        case KeyType::text:
            return "string";
        case KeyType::logical:
            return "switch";
        case KeyType::vector:
            return "vector";
        case KeyType::list:
            return "list";
        case KeyType::dictionary:
            return "dictionary";
    }
    return "";
}

/// "scalar, [0 1 0 0 0 0 0], > 0, default 0.5: the sentence"
std::string explain(const Key& key)
{
    std::string text = typeName(key.type);
    if (!(key.dimensions == dims::none)) text += ", " + toString(key.dimensions);
    if (key.least || key.most) text += ", " + rangeOf(key);
    if (!key.allowed.empty()) text += fmt::format(", one of {}", fmt::join(key.allowed, " "));
    if (key.presence == KeyPresence::required)
        text += ", required";
    else if (key.preset.empty())
        text += ", may be absent";
    return text + ": " + key.description;
}

}  // namespace

void Schema::check(const Dictionary& dict) const
{
    std::vector<std::string> names;
    for (const Key& key : keys_) names.push_back(key.name);
    for (const DictionaryEntry& entry : DictionaryAccess::content(dict).entries) {
        const bool known = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
            return entry.pattern ? std::regex_match(name, *entry.pattern) : entry.key == name;
        });
        if (open_ || known || entry.usedByMacro || entry.key == "FoamFile") continue;
        const std::string near = nearestName(entry.key, names);
        throw FatalIOError(
            fmt::format("Unknown keyword {} in dictionary \"{}\"{}\n\nValid keywords are:\n\n{}",
                        entry.key, dict.name(),
                        near.empty() ? "" : "\nDid you mean '" + near + "'?", listOf(names)),
            entry.at.file, entry.at.line);
    }
    for (const Key& key : keys_) {
        if (dict.found(key.name))
            checkValue(dict, key);
        else if (key.presence == KeyPresence::required)
            dict.fail(key.name, fmt::format("keyword {} is undefined in dictionary \"{}\"\n({})",
                                            key.name, dict.name(), explain(key)));
    }
}

const Key& Schema::find(const std::string& key) const
{
    const auto it =
        std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
    if (it == keys_.end()) throw std::logic_error("the schema declares no key '" + key + "'");
    return *it;
}

std::string Schema::annotated(int indent) const
{
    const std::string margin(static_cast<std::size_t>(4 * indent), ' ');
    std::string text;
    for (const Key& key : keys_) {
        const std::string value =
            key.preset.empty() ? fmt::format("<{}>", typeName(key.type)) : key.preset;
        const std::string entry = fmt::format("{:<15} {};", key.name, value);
        text += fmt::format("{}{}{:<35} // {}\n", margin, key.preset.empty() ? "// " : "", entry,
                            explain(key));
    }
    return text;
}

}  // namespace isph
