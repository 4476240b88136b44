// SPDX-License-Identifier: GPL-3.0-or-later
#include "Variants.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace isph {

namespace {

bool sameValue(const KeyValue& a, const KeyValue& b)
{
    const std::optional<Real> x = a.number(), y = b.number();
    return x && y ? *x == *y : a.text == b.text;
}

Setting settingOf(const VariedKey& key, const KeyValue& value)
{
    return {&key, value, sameValue(value, key.base)};
}

Setting baseOf(const VariedKey& key)
{
    for (const KeyValue& value : key.values)
        if (sameValue(value, key.base)) return {&key, value, true};
    return {&key, key.base, true};
}

/// "kernel=cubicSpline, nu=0.1", of the settings that differ from the case and are not of `along`.
std::string text(const std::vector<Setting>& settings, const std::string& along,
                 const std::string& separator, bool bases)
{
    std::string all;
    for (const Setting& one : settings) {
        if (one.key->name == along || (one.isBase && !bases)) continue;
        all += (all.empty() ? "" : separator) + one.key->name + "=" + one.value.label;
    }
    return all;
}

std::string folderName(std::string name)
{
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && !std::strchr("=.+-_", c)) c = '_';
    return name;
}

void add(const Report& report, std::vector<Setting> settings, std::vector<Variant>& all)
{
    const auto same = [&](const Variant& other) {
        return std::equal(
            settings.begin(), settings.end(), other.settings.begin(),
            [](const Setting& a, const Setting& b) { return sameValue(a.value, b.value); });
    };
    if (std::any_of(all.begin(), all.end(), same)) return;
    Variant variant;
    variant.name = folderName(text(settings, "", "_", false));
    if (variant.name.empty()) variant.name = "base";
    const std::string name = variant.name;
    const auto taken = [&](const Variant& other) { return other.name == variant.name; };
    for (int k = 2; std::any_of(all.begin(), all.end(), taken); ++k)
        variant.name = name + "_" + std::to_string(k);
    const bool grid = report.mode == Report::Mode::grid;
    variant.family = text(settings, report.along, ", ", grid);
    if (variant.family.empty()) variant.family = "base";
    variant.settings = std::move(settings);
    all.push_back(std::move(variant));
}

void addGrid(const Report& report, std::vector<Setting>& settings, std::vector<Variant>& all)
{
    if (settings.size() == report.keys.size()) return add(report, settings, all);
    const VariedKey& key = report.keys[settings.size()];
    for (const KeyValue& value : key.values) {
        settings.push_back(settingOf(key, value));
        addGrid(report, settings, all);
        settings.pop_back();
    }
}

void addOneAtATime(const Report& report, std::vector<Variant>& all)
{
    std::vector<Setting> base;
    for (const VariedKey& key : report.keys) base.push_back(baseOf(key));
    const VariedKey* along = report.alongKey();
    const std::size_t a = along ? static_cast<std::size_t>(along - report.keys.data()) : 0;
    std::vector<Setting> steps{base[a]};
    if (along) {
        steps.clear();
        for (const KeyValue& value : along->values) steps.push_back(settingOf(*along, value));
    }
    const auto addFamily = [&](std::vector<Setting> settings) {
        for (const Setting& step : steps) {
            if (along) settings[a] = step;
            add(report, settings, all);
        }
    };
    addFamily(base);
    for (std::size_t k = 0; k < report.keys.size(); ++k) {
        if (&report.keys[k] == along) continue;
        for (const KeyValue& value : report.keys[k].values) {
            std::vector<Setting> settings = base;
            settings[k] = settingOf(report.keys[k], value);
            addFamily(settings);
        }
    }
}

}  // namespace

std::optional<Real> Variant::along(const Report& report) const
{
    for (const Setting& one : settings)
        if (one.key->name == report.along) return one.value.number();
    return std::nullopt;
}

std::vector<Variant> variantsOf(const Report& report)
{
    std::vector<Variant> all;
    std::vector<Setting> settings;
    if (report.mode == Report::Mode::grid)
        addGrid(report, settings, all);
    else
        addOneAtATime(report, all);
    return all;
}

}  // namespace isph
