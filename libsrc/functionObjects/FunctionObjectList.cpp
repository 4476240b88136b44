// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObjectList.hpp"

#include "core/Log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph {

namespace fs = std::filesystem;

namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kTimeTolerance = 1e-9;  // times are sums of steps and carry their rounding

fs::path outputFolder(const MeasureStart& start, const std::string& name)
{
    return start.caseDir / "postProcessing" / name;
}

/// The line that `log yes;` adds to the log of the run.
void logRow(const std::string& type, const std::string& name,
            const std::vector<std::string>& columns, const std::vector<Real>& values)
{
    constexpr std::size_t most = 8;  // a line of the log stays a line
    std::string text = type + " " + name + ":";
    for (std::size_t k = 0; k < std::min(most, values.size()); ++k)
        text += fmt::format(" {} = {:.6g}", columns[k], values[k]);
    if (values.size() > most) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        text += fmt::format(" ... ({} values, min {:.6g}, max {:.6g})", values.size(), *low, *high);
    }
    writeInfo(text);
}

/// <purpose>Control and <purpose>Interval, started.
TimeControl readControl(const Dictionary& dict, const std::string& purpose,
                        TimeControl::Kind otherwise, const StepInstant& start)
{
    using Kind = TimeControl::Kind;
    const std::string key = purpose + "Interval";
    const bool steps = !dict.found(purpose + "Control") ||
                       dict.get<std::string>(purpose + "Control") == "timeStep";
    TimeControl control = TimeControl::read(dict, purpose, otherwise, steps ? 1 : 0);
    const bool counts = control.kind() != Kind::writeTime && control.kind() != Kind::none;
    if (!counts && dict.found(key) && dict.get<Real>(key) != 1)
        dict.fail(key,
                  fmt::format("{} has no meaning for {}Control {}: leave it out", key, purpose,
                              TimeControl::kindNames()[static_cast<std::size_t>(control.kind())]));
    control.startAt(start);
    return control;
}

void requireFinite(const std::string& name, const std::vector<std::string>& columns,
                   const std::vector<Real>& values, Real time)
{
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isfinite(values[k]))
            throw FatalError(fmt::format("Function object {}: {} is {} at time {}", name,
                                         columns[k], values[k], time));
}

}  // namespace

FunctionObjectList::FunctionObjectList(const Dictionary& controlDict, const MeasureStart& start)
{
    reread(controlDict, start);
}

FunctionObjectList::Entry FunctionObjectList::makeEntry(const Dictionary& dict,
                                                        const MeasureStart& start)
{
    for (const std::string& library : dict.getOrDefault("libs", std::vector<std::string>{}))
        loadLibrary(library);
    const std::string type = dict.get<std::string>("type");
    Entry entry{dict.scopeName(),
                type,
                dict.toString(),
                FunctionObject::table().make(type, dict, dict, "type"),
                readControl(dict, "write", TimeControl::Kind::timeStep, start.instant),
                readControl(dict, "execute", TimeControl::Kind::none, start.instant),
                dict.getOrDefault("startTime", -kInfinity, dims::time),
                dict.getOrDefault("endTime", kInfinity, dims::time),
                dict.getOrDefault("enabled", true),
                dict.getOrDefault("log", false),
                start};
    if (entry.startTime > entry.endTime)
        dict.fail("endTime", fmt::format("endTime {} lies before startTime {}", entry.endTime,
                                         entry.startTime));
    resume(entry);
    return entry;
}

/// Gives the first row of the earliest start to a model that measures against it.
void FunctionObjectList::resume(Entry& entry)
{
    if (entry.start.instant.index == 0) return;
    for (const TimeFolder& folder : timeFolders(outputFolder(entry.start, entry.name))) {
        const fs::path file = folder.path / (entry.name + ".dat");
        if (folder.name == entry.start.timeName || !fs::exists(file)) continue;
        const DataTable table = readDataTable(file);
        if (table.rows.empty()) continue;
        entry.object->resume(Span<const Real>(table.rows.front()).subspan(1));
        return;
    }
}

void FunctionObjectList::reread(const Dictionary& controlDict, const MeasureStart& start)
{
    std::vector<std::optional<Entry>> fresh;  // none: goes on
    std::vector<std::size_t> kept;
    const Dictionary none;
    const Dictionary& functions =
        controlDict.found("functions") ? controlDict.subDict("functions") : none;
    for (const std::string& name : functions.keywords()) {
        const Dictionary& dict = functions.subDict(name);
        const auto old = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
            return entry.name == name && entry.text == dict.toString();
        });
        kept.push_back(static_cast<std::size_t>(old - entries_.begin()));
        fresh.push_back(old == entries_.end() ? std::optional(makeEntry(dict, start))
                                              : std::nullopt);
    }
    std::vector<Entry> all;
    for (std::size_t k = 0; k < fresh.size(); ++k)
        all.push_back(fresh[k] ? std::move(*fresh[k]) : std::move(entries_[kept[k]]));
    entries_ = std::move(all);
}

std::vector<std::string> FunctionObjectList::names() const
{
    std::vector<std::string> all;
    for (const Entry& entry : entries_) all.push_back(entry.name);
    return all;
}

void FunctionObjectList::meet(Time& time)
{
    for (Entry& entry : entries_) {
        if (!entry.met && entry.enabled)
            for (const TimeControl* control : {&entry.writing, &entry.executing})
                time.alsoMeet(*control);
        entry.met = true;
    }
}

void FunctionObjectList::Entry::ask(const StepInstant& now)
{
    const bool initial = now.index == 0;
    const auto asked = [&](TimeControl& control) {
        return control.due(now) || (initial && control.kind() != TimeControl::Kind::none);
    };
    write = asked(writing);
    run = asked(executing);
    const bool measuredBefore = !initial && now.index <= start.instant.index;
    if (!enabled || !inside(now) || measuredBefore) write = run = false;
}

bool FunctionObjectList::Entry::inside(const StepInstant& now) const
{
    const Real slack = kTimeTolerance * std::max(Real(1), std::abs(now.value));
    return now.value >= startTime - slack && now.value <= endTime + slack;
}

bool FunctionObjectList::due(const StepInstant& now)
{
    time_ = now.value;
    index_ = now.index;
    bool any = false;
    for (Entry& entry : entries_) {
        entry.ask(now);
        any = any || entry.write || entry.run;
    }
    return any;
}

bool FunctionObjectList::dueAtEnd(const StepInstant& now)
{
    time_ = now.value;
    index_ = now.index;
    bool any = false;
    for (Entry& entry : entries_) {
        const bool wanted = entry.enabled && entry.object->measuresAtEnd() &&
                            entry.writing.kind() != TimeControl::Kind::none;
        const bool missing =
            entry.written != now.index && now.index > entry.start.instant.index;
        entry.run = false;
        entry.write = wanted && missing && entry.inside(now);
        any = any || entry.write;
    }
    return any;
}

bool FunctionObjectList::dueAll(const StepInstant& now)
{
    time_ = now.value;
    index_ = now.index;
    bool any = false;
    for (Entry& entry : entries_) {
        entry.run = false;
        entry.write = entry.enabled && entry.inside(now);
        any = any || entry.write;
    }
    return any;
}

void FunctionObjectList::openFile(Entry& entry)
{
    std::vector<std::string> header{entry.type + " " + entry.name};
    for (const std::string& line : entry.object->header()) header.push_back(line);
    entry.file.emplace(
        outputFolder(entry.start, entry.name) / entry.start.timeName / (entry.name + ".dat"),
        header, entry.object->columns());
}

void FunctionObjectList::execute(const FlowView& flow)
{
    for (Entry& entry : entries_) {
        if (!entry.write && !entry.run) continue;
        const std::vector<Real> values = entry.object->measure(flow);
        const std::vector<std::string> columns = entry.object->columns();
        requireFinite(entry.name, columns, values, time_);
        if (entry.log) logRow(entry.type, entry.name, columns, values);
        if (entry.write) {
            if (!entry.file) openFile(entry);
            entry.file->write(time_, values);
            entry.written = index_;
        }
        entry.write = entry.run = false;
    }
}

}  // namespace isph
