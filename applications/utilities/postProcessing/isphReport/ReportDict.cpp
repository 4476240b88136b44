// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportDict.hpp"

#include "VaryEntry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace isph {

namespace fs = std::filesystem;

namespace {

Schema quantityKeys(bool limit)
{
    Schema keys{Key::text("series", "postProcessing/<name>, or a file of a function object."),
                Key::text("column", "Column of it, or several: * and ? stand for any letters."),
                Key::word("measure", "last, mean, max, min or rms of the deviations, or range.")
                    .oneOf(measureNames())
                    .byDefault(limit ? "max" : "last"),
                Key::scalar("from", "Leaves out earlier rows [s].").mayBeAbsent(),
                Key::scalar("to", "Leaves out later rows [s].").mayBeAbsent(),
                Key::scalar("expect", "What is subtracted.").byDefault("0"),
                Key::text("reference", "Or a csv of t, value, relative to the case.").mayBeAbsent(),
                Key::scalar("scale", "Multiplies the values.").byDefault("1"),
                Key::logical("relative", "In per cent of what is expected.").byDefault("no")};
    if (limit) keys.add(Key::scalar("above", "Beyond it the run counts as unstable."));
    return keys;
}

Quantity readQuantity(const Dictionary& dict, bool limit)
{
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Schema keys = quantityKeys(limit);
    keys.check(dict);
    Quantity one;
    one.name = dict.scopeName();
    one.source.series = keys.get<std::string>(dict, "series");
    one.source.columns = keys.get<std::string>(dict, "column");
    one.source.from = dict.getOrDefault<Real>("from", -infinity);
    one.source.to = dict.getOrDefault<Real>("to", infinity);
    one.expectation.value = keys.get<Real>(dict, "expect");
    if (dict.found("reference")) one.expectation.reference = dict.get<std::string>("reference");
    one.measure = keys.get<std::string>(dict, "measure");
    one.scale = keys.get<Real>(dict, "scale");
    one.relative = keys.get<bool>(dict, "relative");
    if (limit) one.above = keys.get<Real>(dict, "above");
    return one;
}

std::vector<Quantity> readQuantities(const Dictionary& dict, const std::string& key)
{
    std::vector<Quantity> all;
    if (!dict.found(key)) return all;
    const Dictionary& entries = dict.subDict(key);
    for (const std::string& name : entries.keywords())
        all.push_back(readQuantity(entries.subDict(name), key == "limits"));
    return all;
}

void readAlong(const Dictionary& dict, Report& report)
{
    std::vector<std::string> names;
    for (const VariedKey& key : report.keys) names.push_back(key.name);
    if (dict.found("along")) {
        report.along = dict.getChoice("along", names);
    } else if (report.mode == Report::Mode::grid) {
        const bool spacing = std::find(names.begin(), names.end(), "spacing") != names.end();
        report.along = spacing ? "spacing" : names.front();
    }
}

/// createParticles and the program that the case names.
std::vector<std::string> usualCommands(const fs::path& caseDir)
{
    const Dictionary control = Dictionary::read(caseDir / "system" / "controlDict");
    return {"createParticles", control.get<std::string>("application")};
}

}  // namespace

std::optional<Real> KeyValue::number() const
{
    const std::size_t unit = text.starts_with("[") ? text.find(']') : std::string::npos;
    std::size_t begin = unit == std::string::npos ? 0 : unit + 1;
    while (begin < text.size() && text[begin] == ' ') ++begin;
    Real value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + begin, end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

bool VariedKey::numeric() const
{
    return std::all_of(values.begin(), values.end(),
                       [](const KeyValue& value) { return value.number().has_value(); });
}

Real Quantity::of(const fs::path& caseDir) const
{
    Source from = source;
    from.series = caseDir / source.series;
    Expectation against = expectation;
    if (!against.reference.empty()) against.reference = caseDir / against.reference;
    std::vector<Sample> all = samples(from, against);
    for (Sample& s : all) s = {s.time, scale * s.measured, scale * s.expected};
    return isph::measure(measure, relative ? inPerCent(std::move(all)) : all);
}

const VariedKey* Report::alongKey() const
{
    for (const VariedKey& key : keys)
        if (key.name == along) return &key;
    return nullptr;
}

Schema reportKeys()
{
    return {
        Key::word("mode", "oneAtATime: each key by itself; grid: every combination.")
            .oneOf({"oneAtATime", "grid"})
            .byDefault("oneAtATime"),
        Key::word("along",
                  "The key along which lines are drawn and orders observed; with oneAtATime every "
                  "other value is run at all of its values. With grid it is spacing, or the first.")
            .mayBeAbsent(),
        Key::integer("parallel", "Variants that run at a time.").byDefault("1").atLeast(1),
        Key::integer("threads", "Threads of each.").byDefault("1").atLeast(1),
        Key::scalar("timeLimit", "Wall time after which a variant is stopped [s].")
            .units(dims::time)
            .above(0)
            .mayBeAbsent(),
        Key::list("commands", "What is run for a variant; createParticles and the application.")
            .mayBeAbsent(),
        Key::text("check", "Command whose lines <name> <value> <unit> bound ... are errors too.")
            .mayBeAbsent(),
        Key::dictionary("vary", "The keys that vary, each with values or a range."),
        Key::dictionary("errors", "Errors by name: series, column, measure.").mayBeAbsent(),
        Key::dictionary("limits", "What is unstable although it ran: series, column, above.")
            .mayBeAbsent()};
}

Report readReport(const fs::path& caseDir)
{
    const Dictionary dict = Dictionary::read(caseDir / "system" / "reportDict");
    const Schema keys = reportKeys();
    keys.check(dict);
    Report report;
    report.mode = keys.get<std::string>(dict, "mode") == "grid" ? Report::Mode::grid
                                                                : Report::Mode::oneAtATime;
    const Dictionary& vary = dict.subDict("vary");
    for (const std::string& name : vary.keywords())
        report.keys.push_back(readVariedKey(vary.subDict(name), caseDir));
    if (report.keys.empty()) dict.fail("vary", "vary names no key: there is nothing to report on");
    readAlong(dict, report);
    report.parallel = keys.get<int>(dict, "parallel");
    report.threads = keys.get<int>(dict, "threads");
    if (dict.found("timeLimit")) report.timeLimit = dict.get<Real>("timeLimit", dims::time);
    report.commands = dict.found("commands") ? dict.get<std::vector<std::string>>("commands")
                                             : usualCommands(caseDir);
    if (report.commands.empty()) dict.fail("commands", "commands holds no command");
    if (dict.found("check")) report.check = dict.get<std::string>("check");
    report.errors = readQuantities(dict, "errors");
    report.limits = readQuantities(dict, "limits");
    if (report.errors.empty() && report.check.empty())
        dict.fail("errors", "\"" + dict.name() + "\" names no error: give errors { ... } or check");
    return report;
}

}  // namespace isph
