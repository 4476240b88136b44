// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TimeList.hpp"

#include "case/Time.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace isph {

namespace {

std::optional<Real> asNumber(std::string_view text)
{
    Real value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

std::string namesOf(const std::vector<TimeFolder>& folders)
{
    std::string text = fmt::format("{}\n(\n", folders.size());
    for (const TimeFolder& folder : folders) text += "    " + folder.name + "\n";
    return text + ")\n";
}

const TimeFolder& nearest(const std::vector<TimeFolder>& folders, Real value)
{
    return *std::min_element(folders.begin(), folders.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.value - value) < std::abs(b.value - value);
    });
}

/// Folders of one item of a selection, between commas.
std::vector<TimeFolder> selectItem(const std::vector<TimeFolder>& folders, const std::string& item)
{
    if (item == "latestTime") return {folders.back()};
    if (item == "firstTime") return {folders.front()};
    const auto colon = item.find(':');
    const std::string low = item.substr(0, colon);
    if (colon == std::string::npos) {
        if (const auto value = asNumber(low)) return {nearest(folders, *value)};
        throw FatalError(fmt::format(
            "'{}' is no time; a number, a range a:b, firstTime or latestTime is expected", item));
    }
    const std::string high = item.substr(colon + 1);
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const auto from = low.empty() ? std::optional(-infinity) : asNumber(low);
    const auto to = high.empty() ? std::optional(infinity) : asNumber(high);
    if (!from || !to) throw FatalError(fmt::format("'{}' is no range of times a:b", item));
    std::vector<TimeFolder> found;
    for (const TimeFolder& folder : folders)
        if (folder.value >= *from && folder.value <= *to) found.push_back(folder);
    if (found.empty())
        throw FatalError(fmt::format("no time folder lies in the range '{}'; there are {}", item,
                                     namesOf(folders)));
    return found;
}

}  // namespace

std::vector<TimeFolder> timeFolders(const std::filesystem::path& caseDir)
{
    std::vector<TimeFolder> found;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(caseDir, failed)) {
        const std::string name = entry.path().filename().string();
        const auto value = asNumber(name);
        if (value && entry.is_directory()) found.push_back({*value, name, entry.path()});
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.value < b.value; });
    return found;
}

std::vector<TimeFolder> selectTimes(const std::vector<TimeFolder>& folders,
                                    const std::string& selection)
{
    if (folders.empty()) throw FatalError("the case has no time folders");
    std::vector<TimeFolder> selected;
    std::istringstream items(selection);
    for (std::string item; std::getline(items, item, ',');) {
        item.erase(0, item.find_first_not_of(' '));
        item.erase(item.find_last_not_of(' ') + 1);
        for (TimeFolder& folder : selectItem(folders, item)) {
            const bool known = std::any_of(selected.begin(), selected.end(),
                                           [&](const auto& s) { return s.name == folder.name; });
            if (!known) selected.push_back(std::move(folder));
        }
    }
    if (selected.empty())
        throw FatalError(
            "no time is given; a number, a range a:b, firstTime or latestTime is expected");
    return selected;
}

std::string timeStateText(const TimeState& state)
{
    std::string parts;
    for (const std::string& part : state.parts) parts += (parts.empty() ? "" : " ") + part;
    return fmt::format(
        "FoamFile\n{{\n    format      ascii;\n    class       dictionary;\n"
        "    location    \"{0}/uniform\";\n    object      time;\n}}\n\n"
        "value           {1:.17g};\nname            \"{0}\";\nindex           {2};\n"
        "deltaT          {3:.17g};\ndeltaT0         {4:.17g};\nparts           ({5});\n",
        state.name, state.value, state.index, state.deltaT, state.deltaT0, parts);
}

namespace {

/// Whether a time folder of this name may hold this time, in any format and precision.
bool isNameOf(const std::string& name, Real value)
{
    constexpr int most = 17;
    for (const TimeFormat format : {TimeFormat::general, TimeFormat::fixed, TimeFormat::scientific})
        for (int precision = 1; precision <= most; ++precision)
            if (timeName(value, format, precision) == name) return true;
    return false;
}

/// uniform/time speaks of this folder, and of a state that can be.
void requireSound(const Dictionary& dict, const TimeState& state, const TimeFolder& folder)
{
    if (state.name != folder.name || !isNameOf(state.name, state.value))
        dict.fail(
            state.name != folder.name ? "name" : "value",
            fmt::format("The time folder {} holds the state of time {} ({} s): was it "
                        "renamed?\nRename it back; or, "
                        "to start anew from its particles, call it 0 and remove its uniform/time.",
                        folder.name, state.name, state.value));
    const auto notNegative = [&](const std::string& key, Real value) {
        if (value < 0) dict.fail(key, fmt::format("{} is {}, allowed: {} >= 0", key, value, key));
    };
    notNegative("index", state.index);
    notNegative("deltaT", state.deltaT);
    notNegative("deltaT0", state.deltaT0);
}

}  // namespace

TimeState readTimeState(const TimeFolder& folder)
{
    const std::filesystem::path file = folder.path / "uniform" / "time";
    const auto cutOff = [&](const std::string& missing) {
        throw FatalIOError(
            fmt::format("time folder {} is incomplete, {} is missing: it was cut off while it was "
                        "written or copied; remove it and start from an earlier time",
                        folder.name, missing),
            folder.path.string(), 0);
    };
    TimeState state;
    if (!std::filesystem::exists(file)) {
        if (folder.value != 0) cutOff("uniform/time");
        return state;
    }
    const Dictionary dict = Dictionary::read(file);
    state.value = dict.get<Real>("value");
    state.name = dict.get<std::string>("name");
    state.index = dict.get<int>("index");
    state.deltaT = dict.get<Real>("deltaT");
    state.deltaT0 = dict.get<Real>("deltaT0");
    state.parts = dict.getOrDefault<std::vector<std::string>>("parts", {});
    requireSound(dict, state, folder);
    for (const std::string& part : state.parts)
        if (!std::filesystem::exists(folder.path / (part + ".vtp"))) cutOff(part + ".vtp");
    return state;
}

TimeFolder startFolder(const Dictionary& controlDict, const std::filesystem::path& caseDir)
{
    const std::vector<TimeFolder> folders = timeFolders(caseDir);
    const std::string from =
        controlDict.getChoice("startFrom", {"firstTime", "latestTime", "startTime"}, "latestTime");
    if (folders.empty())
        throw FatalIOError(
            "the case has no time folder to start from; createParticles makes the folder 0",
            caseDir.string(), 0);
    if (from == "firstTime") return folders.front();
    if (from == "latestTime") return folders.back();
    const Real wanted = controlDict.get<Real>("startTime", dims::time);
    const TimeFolder& found = nearest(folders, wanted);
    const Real rounding =
        1e-6 * std::max(std::abs(wanted), std::abs(found.value));  // names carry 6 digits
    if (std::abs(found.value - wanted) > rounding)
        controlDict.fail("startTime", fmt::format("the case has no time folder {}; there are {}",
                                                  wanted, namesOf(folders)));
    return found;
}

}  // namespace isph
