// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a dictionary, declared once: read, checked, listed and documented from here.
#pragma once
#include "dictionary/Dictionary.hpp"

#include <optional>
#include <string>
#include <vector>

namespace isph {

/// One key. `preset` empty = required; a value in dictionary syntax = the default; optional keys
/// that have no value of their own use KeyPresence::optional.
enum class KeyType { scalar, integer, word, text, logical, vector, list, dictionary };
enum class KeyPresence { required, optional };

struct Key {
    std::string name;
    KeyType type = KeyType::scalar;
    std::string description;              ///< one sentence
    Dimensions dimensions{};
    std::string preset{};                 ///< default in dictionary syntax; empty: none
    KeyPresence presence = KeyPresence::required;
    std::optional<double> least{};        ///< inclusive, unless openLeast
    std::optional<double> most{};
    bool openLeast = false;
    bool openMost = false;
    std::vector<std::string> allowed{};   ///< words that may stand here; empty: any

    // Builders, so that a declaration reads as a sentence: scalar("D50", "...").units(...).above(0)
    Key& units(const Dimensions& d) { dimensions = d; return *this; }
    Key& byDefault(std::string value)
    {
        preset = std::move(value);
        presence = KeyPresence::optional;
        return *this;
    }
    Key& mayBeAbsent() { presence = KeyPresence::optional; return *this; }
    Key& atLeast(double v) { least = v; return *this; }
    Key& atMost(double v) { most = v; return *this; }
    Key& above(double v) { least = v; openLeast = true; return *this; }
    Key& below(double v) { most = v; openMost = true; return *this; }
    Key& oneOf(std::vector<std::string> words) { allowed = std::move(words); return *this; }

    static Key scalar(std::string name, std::string description)
    {
        return {std::move(name), KeyType::scalar, std::move(description)};
    }
    static Key integer(std::string name, std::string description)
    {
        return {std::move(name), KeyType::integer, std::move(description)};
    }
    static Key word(std::string name, std::string description)
    {
        return {std::move(name), KeyType::word, std::move(description)};
    }
    static Key text(std::string name, std::string description)
    {
        return {std::move(name), KeyType::text, std::move(description)};
    }
    static Key logical(std::string name, std::string description)
    {
        return {std::move(name), KeyType::logical, std::move(description)};
    }
    static Key vector(std::string name, std::string description)
    {
        return {std::move(name), KeyType::vector, std::move(description)};
    }
    static Key list(std::string name, std::string description)
    {
        return {std::move(name), KeyType::list, std::move(description)};
    }
    static Key dictionary(std::string name, std::string description)
    {
        return {std::move(name), KeyType::dictionary, std::move(description)};
    }
};

class Schema {
public:
    Schema() = default;
    Schema(std::initializer_list<Key> keys) : keys_(keys) {}

    const std::vector<Key>& keys() const { return keys_; }
    Schema& add(Key key) { keys_.push_back(std::move(key)); return *this; }
    /// Keys not declared are accepted (dictionaries whose keywords are the user's names).
    Schema& open() { open_ = true; return *this; }

    /// Throws FatalIOError at the first unknown key (with the nearest valid one), missing key,
    /// wrong type, wrong dimensions, value out of range or word that is not allowed.
    void check(const Dictionary& dict) const;

    /// The value of a declared key, or its default. T as for Dictionary::get.
    template <class T>
    T get(const Dictionary& dict, const std::string& key) const;

    /// An annotated dictionary body: each key with its default, dimensions, range and sentence.
    std::string annotated(int indent = 0) const;

private:
    const Key& find(const std::string& key) const;
    std::vector<Key> keys_;
    bool open_ = false;
};

template <class T>
T Schema::get(const Dictionary& dict, const std::string& key) const
{
    const Key& declared = find(key);
    if (dict.found(key)) return dict.get<T>(key, declared.dimensions);
    if (declared.preset.empty())
        dict.fail(key, "keyword " + key + " is undefined in dictionary \"" + dict.name() + "\"");
    return Dictionary::parse(key + " " + declared.preset + ";", "default of " + key)
        .get<T>(key, declared.dimensions);
}

}  // namespace isph
