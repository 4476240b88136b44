// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dictionary.hpp"

#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/DictionaryParser.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace isph {

DictionaryEntry DictionaryEntry::clone() const
{
    DictionaryEntry copy{key, at, tokens, nullptr, pattern, usedByMacro};
    if (dict) copy.dict = std::make_unique<Dictionary>(*dict);
    return copy;
}

const DictionaryEntry* Dictionary::Content::findExact(std::string_view key) const
{
    const auto it = exact.find(key);
    return it == exact.end() ? nullptr : &entries[it->second];
}

DictionaryEntry* Dictionary::Content::findExact(std::string_view key)
{
    return const_cast<DictionaryEntry*>(std::as_const(*this).findExact(key));
}

const DictionaryEntry* Dictionary::Content::findPattern(const std::string& text) const
{
    const auto it = std::find_if(entries.begin(), entries.end(), [&](const DictionaryEntry& e) {
        return e.pattern && e.key == text;
    });
    return it == entries.end() ? nullptr : &*it;
}

const DictionaryEntry* Dictionary::Content::find(std::string_view key) const
{
    if (const DictionaryEntry* entry = findExact(key)) return entry;
    const auto it = std::find_if(entries.rbegin(), entries.rend(), [&](const DictionaryEntry& e) {
        return e.pattern && std::regex_match(key.begin(), key.end(), *e.pattern);
    });
    return it == entries.rend() ? nullptr : &*it;
}

void Dictionary::Content::erase(const DictionaryEntry* entry)
{
    entries.erase(entries.begin() + (entry - entries.data()));
    exact.clear();
    for (std::size_t k = 0; k < entries.size(); ++k)
        if (!entries[k].pattern) exact.emplace(entries[k].key, k);
}

DictionaryEntry& Dictionary::Content::put(DictionaryEntry entry)
{
    if (entry.pattern) {
        if (const DictionaryEntry* old = findPattern(entry.key)) erase(old);
    } else if (DictionaryEntry* old = findExact(entry.key)) {
        entry.usedByMacro = entry.usedByMacro || old->usedByMacro;
        *old = std::move(entry);
        return *old;
    } else {
        exact.emplace(entry.key, entries.size());
    }
    entries.push_back(std::move(entry));
    return entries.back();
}

std::regex patternOf(const std::string& text, const Location& at)
{
    try {
        return std::regex(text);
    } catch (const std::regex_error& error) {
        throw FatalIOError(
            fmt::format("The keyword \"{}\" is not a regular expression: {}", text, error.what()),
            at.file, at.line);
    }
}

void mergeInto(Dictionary& target, const Dictionary& source)
{
    auto& into = DictionaryAccess::content(target);
    for (const DictionaryEntry& entry : DictionaryAccess::content(source).entries) {
        const DictionaryEntry* old =
            entry.pattern ? into.findPattern(entry.key) : into.findExact(entry.key);
        if (old && old->dict && entry.dict) {
            mergeInto(*old->dict, *entry.dict);
            continue;
        }
        DictionaryEntry& placed = into.put(entry.clone());
        if (placed.dict) rename(*placed.dict, target.name() + "/" + placed.key);
    }
}

void rename(Dictionary& dict, const std::string& name)
{
    auto& content = DictionaryAccess::content(dict);
    content.name = name;
    for (DictionaryEntry& entry : content.entries)
        if (entry.dict) rename(*entry.dict, name + "/" + entry.key);
}

Dictionary::Dictionary() : content_(std::make_unique<Content>()) {}
Dictionary::Dictionary(Dictionary&&) noexcept = default;
Dictionary& Dictionary::operator=(Dictionary&&) noexcept = default;
Dictionary::~Dictionary() = default;

Dictionary::Dictionary(const Dictionary& other) : Dictionary()
{
    content_->name = other.content_->name;
    content_->at = other.content_->at;
    content_->exact = other.content_->exact;
    content_->entries.reserve(other.content_->entries.size());
    for (const DictionaryEntry& entry : other.content_->entries)
        content_->entries.push_back(entry.clone());
}

Dictionary& Dictionary::operator=(const Dictionary& other)
{
    if (this != &other) *this = Dictionary(other);
    return *this;
}

const std::string& Dictionary::name() const
{
    return content_->name;
}

std::string Dictionary::scopeName() const
{
    return content_->name.substr(content_->name.find_last_of('/') + 1);
}

Location Dictionary::location() const
{
    return content_->at;
}

Location Dictionary::location(std::string_view key) const
{
    const DictionaryEntry* entry = content_->find(key);
    return entry ? entry->at : content_->at;
}

std::vector<std::string> Dictionary::keywords() const
{
    std::vector<std::string> keys;
    for (const DictionaryEntry& entry : content_->entries)
        keys.push_back(entry.pattern ? '"' + entry.key + '"' : entry.key);
    return keys;
}

bool Dictionary::found(std::string_view key) const
{
    return content_->find(key) != nullptr;
}

bool Dictionary::isDict(std::string_view key) const
{
    const DictionaryEntry* entry = content_->find(key);
    return entry && entry->dict;
}

bool Dictionary::isUsedByMacro(std::string_view key) const
{
    const DictionaryEntry* entry = content_->find(key);
    return entry && entry->usedByMacro;
}

const Dictionary& Dictionary::subDict(std::string_view key) const
{
    const DictionaryEntry* entry = content_->find(key);
    if (!entry) failUndefined(*this, key);
    if (!entry->dict)
        fail(key, fmt::format("'{}' in dictionary \"{}\" is not a sub-dictionary: expected '{{ ... "
                              "}}', found '{}'",
                              key, name(), textOf(entry->tokens)));
    return *entry->dict;
}

const std::vector<Token>& Dictionary::tokens(std::string_view key) const
{
    const DictionaryEntry* entry = content_->find(key);
    if (!entry) failUndefined(*this, key);
    if (entry->dict)
        fail(key, fmt::format("'{}' in dictionary \"{}\" is a sub-dictionary: expected a value",
                              key, name()));
    return entry->tokens;
}

void Dictionary::fail(std::string_view key, const std::string& message) const
{
    const Location at = location(key);
    throw FatalIOError(message, at.file, at.line);
}

void failUndefined(const Dictionary& dict, std::string_view key)
{
    std::string message =
        fmt::format("keyword {} is undefined in dictionary \"{}\"", key, dict.name());
    const std::string near = nearestName(key, dict.keywords());
    if (!near.empty())
        message += fmt::format("\nDid you mean '{}' (line {})?", near, dict.location(near).line);
    dict.fail(key, message);
}

Dictionary Dictionary::read(const std::filesystem::path& file)
{
    return DictionaryParser::readFile(file);
}

Dictionary Dictionary::parse(std::string_view text, const std::string& name)
{
    return DictionaryParser::parseText(text, name);
}

}  // namespace isph
