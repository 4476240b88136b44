// SPDX-License-Identifier: GPL-3.0-or-later
#include "selection/ModelTable.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {
std::map<std::string, const AnyModelTable*>& tables()
{
    static std::map<std::string, const AnyModelTable*> all;
    return all;
}
}  // namespace

int coreAbi()
{
    return kAbi;
}

AnyModelTable::AnyModelTable(const char* family)
{
    tables().emplace(family, this);
}
AnyModelTable::~AnyModelTable() = default;

const std::map<std::string, const AnyModelTable*>& modelFamilies()
{
    return tables();
}

Dictionary modelCoefficients(const Dictionary& dict, const std::string& name, const Schema& keys)
{
    const std::string entry = name + "Coeffs";
    if (dict.found(entry)) return dict.subDict(entry);
    for (const Key& key : keys.keys())
        if (key.presence == KeyPresence::required)
            dict.fail(entry, fmt::format("keyword {} is undefined in dictionary \"{}\"\n"
                                         "{} needs at least its key {}: {}",
                                         entry, dict.name(), name, key.name, key.description));
    return Dictionary::parse("", dict.name() + "/" + entry);
}

void failUnknownModel(const std::string& family, const std::string& name,
                      const std::vector<std::string>& valid, const Dictionary& where,
                      std::string_view key)
{
    std::string text = fmt::format("Unknown {} type {}", family, name);
    if (const std::string near = nearestName(name, valid); !near.empty())
        text += fmt::format(", did you mean {}?", near);
    where.fail(key, fmt::format("{}\n\nValid {} types are:\n\n{}", text, family, listOf(valid)));
}

}  // namespace isph
