// SPDX-License-Identifier: GPL-3.0-or-later
#include "VaryEntry.hpp"

#include "dictionary/DictionarySource.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace isph {

namespace fs = std::filesystem;

namespace {

struct KnownKey {
    const char* name;
    const char* file;
    std::vector<std::string> entries;
};

const std::vector<KnownKey>& known()
{
    static const std::vector<KnownKey> all{
        {"spacing", "system/particlesDict", {"spacing"}},
        {"kernel", "system/isphSchemes", {"kernel"}},
        {"smoothingRatio", "system/isphSchemes", {"smoothingRatio"}},
        {"projection", "system/isphSchemes", {"projection"}},
        {"stabilisation", "system/isphSchemes", {"stabilisation/type"}},
        {"shifting", "system/isphSchemes", {"shifting/coefficient"}},
        {"dissipation", "system/isphSchemes", {"dissipation/coefficient"}},
        {"solver", "system/isphSolution", {"pressure/solver"}},
        {"tolerance", "system/isphSolution", {"pressure/tolerance"}},
        {"deltaT", "system/controlDict", {"deltaT", "maxDeltaT"}},
        {"maxCo", "system/controlDict", {"maxCo"}},
        {"nu", "constant/transportProperties", {"nu"}}};
    return all;
}

Schema varyKeys()
{
    return {Key::text("file", "The dictionary, relative to the case.").mayBeAbsent(),
            Key::list("entries", "Entries of it that get the value, as (a/b/c).").mayBeAbsent(),
            Key::list("values", "Values, as the dictionary has them.").mayBeAbsent(),
            Key::list("labels", "What tables call them, where the values are long.").mayBeAbsent(),
            Key::dictionary("range", "Instead of values: from, to, n, scale linear|log.")
                .mayBeAbsent()};
}

Schema rangeKeys()
{
    return {Key::scalar("from", "First value."), Key::scalar("to", "Last value."),
            Key::integer("n", "How many, both ends included.").atLeast(2),
            Key::word("scale", "linear: equal steps; log: equal factors.")
                .oneOf({"linear", "log"})
                .byDefault("linear")};
}

std::vector<KeyValue> rangeValues(const Dictionary& dict)
{
    const Schema keys = rangeKeys();
    keys.check(dict);
    const Real from = keys.get<Real>(dict, "from"), to = keys.get<Real>(dict, "to");
    const int n = keys.get<int>(dict, "n");
    const bool factors = keys.get<std::string>(dict, "scale") == "log";
    if (factors && !(from > 0 && to > 0))
        dict.fail(
            "scale",
            fmt::format("a log scale needs from and to above 0; they are {:g} and {:g}", from, to));
    std::vector<KeyValue> values;
    for (int k = 0; k < n; ++k) {
        const Real s = static_cast<Real>(k) / (n - 1);
        const Real value = factors ? from * std::pow(to / from, s) : (1 - s) * from + s * to;
        values.push_back({fmt::format("{:.6g}", value), fmt::format("{:.6g}", value)});
    }
    return values;
}

/// Tables and folders want short names in one line.
std::string shortLabel(const std::string& text)
{
    constexpr std::size_t most = 32;
    std::string label;
    std::istringstream words(text);
    for (std::string word; words >> word;) label += (label.empty() ? "" : " ") + word;
    return label.size() <= most ? label : label.substr(0, most - 3) + "...";
}

std::vector<KeyValue> listedValues(const Dictionary& dict)
{
    const auto texts = dict.get<std::vector<std::string>>("values");
    const auto labels = dict.found("labels") ? dict.get<std::vector<std::string>>("labels") : texts;
    if (texts.empty()) dict.fail("values", "values holds no value");
    if (labels.size() != texts.size())
        dict.fail("labels", fmt::format("{} labels for {} values", labels.size(), texts.size()));
    std::vector<KeyValue> values;
    for (std::size_t k = 0; k < texts.size(); ++k) {
        for (std::size_t other = 0; other < k; ++other)
            if (texts[other] == texts[k])
                dict.fail("values", fmt::format("the value {} stands twice", texts[k]));
        values.push_back({texts[k], shortLabel(labels[k])});
    }
    return values;
}

/// File and entries of a key: its own, or those that its name stands for.
void readPlace(const Dictionary& dict, VariedKey& key)
{
    const auto it = std::find_if(known().begin(), known().end(),
                                 [&](const KnownKey& one) { return key.name == one.name; });
    const bool named = it != known().end();
    if (named && !dict.found("file")) {
        key.file = it->file;
        key.entries = it->entries;
    }
    if (dict.found("file")) key.file = dict.get<std::string>("file");
    if (dict.found("entries")) key.entries = dict.get<std::vector<std::string>>("entries");
    if (!key.file.empty() && !key.entries.empty()) return;
    const std::string near = nearestName(key.name, knownKeys());
    dict.fail("file",
              fmt::format("the key {} is not known by its name, and has no {}.{}\n\nKnown are "
                          "{}; any other needs file \"constant/...\"; entries (a/b ...);",
                          key.name, key.file.empty() ? "file" : "entries",
                          near.empty() ? "" : "\nDid you mean '" + near + "'?",
                          fmt::join(knownKeys(), ", ")));
}

/// What the case has now. Entries of known keys may be absent: they have defaults, of which
/// maxDeltaT is then left out.
void readBase(const Dictionary& dict, const fs::path& caseDir, VariedKey& key)
{
    if (!fs::exists(caseDir / key.file))
        dict.fail(dict.found("file") ? "file" : "values",
                  fmt::format("the case has no {}", key.file.string()));
    const DictionarySource source = DictionarySource::read(caseDir / key.file);
    const bool own = dict.found("entries");
    for (const std::string& entry : key.entries)
        if (own && !source.found(entry))
            dict.fail("entries", fmt::format("{} has no entry {}", key.file.string(), entry));
    if (!own && key.entries.size() > 1)
        std::erase_if(key.entries, [&](const std::string& entry) {
            return entry != key.entries.front() && !source.found(entry);
        });
    const std::string& first = key.entries.front();
    if (source.found(first)) key.base.text = source.valueText(first);
    key.base.label = key.base.text.empty() ? "default" : shortLabel(key.base.text);
}

}  // namespace

std::vector<std::string> knownKeys()
{
    std::vector<std::string> names;
    for (const KnownKey& key : known()) names.emplace_back(key.name);
    return names;
}

VariedKey readVariedKey(const Dictionary& dict, const fs::path& caseDir)
{
    varyKeys().check(dict);
    VariedKey key;
    key.name = dict.scopeName();
    readPlace(dict, key);
    if (dict.found("values") == dict.found("range"))
        dict.fail("values",
                  fmt::format("the key {} needs either values ( ... ) or range {{ from; to; "
                              "n; }}",
                              key.name));
    key.values = dict.found("values") ? listedValues(dict) : rangeValues(dict.subDict("range"));
    readBase(dict, caseDir, key);
    return key;
}

}  // namespace isph
