// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isph {

namespace {

struct Columns {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;
};

bool hasOrder(const Report& report)
{
    const VariedKey* along = report.alongKey();
    return along && along->numeric() && along->values.size() > 1;
}

const Line* lineOf(const std::vector<Line>& all, const Result& result)
{
    for (const Line& line : all)
        if (std::find(line.points.begin(), line.points.end(), &result) != line.points.end())
            return &line;
    return nullptr;
}

/// A table whose numbers have `digits` digits, "" where there is none.
Columns columnsOf(const Report& report, const std::vector<Result>& results, int digits)
{
    Columns table{{"variant"}, {}};
    for (const VariedKey& key : report.keys) table.names.push_back(key.name);
    for (const char* name : {"particles", "steps", "wall [s]", "CPU [s]", "memory [MB]"})
        table.names.emplace_back(name);
    const std::vector<std::string> errors = errorNames(results);
    for (const std::string& name : errors) {
        table.names.push_back(name);
        if (hasOrder(report)) table.names.push_back("order of " + name);
    }
    table.names.insert(table.names.end(), {"stable", "why"});
    const std::vector<Line> all = lines(report, results);
    for (const Result& result : results) {
        const Outcome& outcome = result.outcome;
        std::vector<std::string> row{result.variant->name};
        for (const Setting& setting : result.variant->settings) row.push_back(setting.value.label);
        row.push_back(fmt::format("{:g}", outcome.particles));
        row.push_back(fmt::format("{:g}", outcome.steps));
        for (const Real value : {outcome.wall, outcome.cpu, outcome.memory / 1e6})
            row.push_back(fmt::format("{:.4g}", value));
        for (const std::string& name : errors) {
            const auto error = outcome.errors.find(name);
            const bool known = error != outcome.errors.end();
            row.push_back(known ? fmt::format("{:.{}g}", error->second, digits) : "");
            if (!hasOrder(report)) continue;
            const Line* line = lineOf(all, result);
            const auto order = line ? observedOrder(report, *line, result, name) : std::nullopt;
            row.push_back(order ? fmt::format("{:.2f}", *order) : "");
        }
        row.emplace_back(describe(outcome.state));
        row.push_back(outcome.why);
        table.rows.push_back(row);
    }
    return table;
}

std::string csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + "\"";
}

std::string markdownCell(const std::string& text)
{
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
}

template <class Cell>
std::string joined(const std::vector<std::string>& cells, const std::string& separator, Cell&& cell)
{
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k) line += (k ? separator : "") + cell(cells[k]);
    return line;
}

}  // namespace

std::vector<std::string> errorNames(const std::vector<Result>& results)
{
    std::vector<std::string> names;
    for (const Result& result : results)
        for (const std::string& name : result.outcome.errorNames)
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

std::vector<Line> lines(const Report& report, const std::vector<Result>& results)
{
    std::vector<Line> all;
    const auto lineNamed = [&](const std::string& name) -> Line& {
        for (Line& line : all)
            if (line.name == name) return line;
        return all.emplace_back(Line{name, {}});
    };
    if (report.alongKey()) {
        for (const Result& result : results)
            lineNamed(result.variant->family).points.push_back(&result);
        for (Line& line : all)
            std::stable_sort(line.points.begin(), line.points.end(),
                             [&](const Result* a, const Result* b) {
                                 return a->variant->along(report).value_or(0) >
                                        b->variant->along(report).value_or(0);
                             });
        return all;
    }
    for (std::size_t k = 0; k < report.keys.size(); ++k)
        for (const Result& result : results) {
            const auto isBase = [](const Setting& one) { return one.isBase; };
            const auto& settings = result.variant->settings;
            const bool base = std::all_of(settings.begin(), settings.end(), isBase);
            if (base || !settings[k].isBase)
                lineNamed(report.keys[k].name).points.push_back(&result);
        }
    return all;
}

std::optional<Real> observedOrder(const Report& report, const Line& line, const Result& result,
                                  const std::string& error)
{
    const auto errorOf = [&](const Result& one) {
        const auto it = one.outcome.errors.find(error);
        return it == one.outcome.errors.end() ? 0 : it->second;
    };
    const Result* coarser = nullptr;
    for (const Result* point : line.points) {
        if (point == &result) break;
        if (errorOf(*point) > 0) coarser = point;
    }
    const Real fine = errorOf(result);
    if (!coarser || !(fine > 0)) return std::nullopt;
    const auto d1 = coarser->variant->along(report), d2 = result.variant->along(report);
    if (!d1 || !d2 || !(*d1 > 0 && *d2 > 0) || *d1 == *d2) return std::nullopt;
    return std::log(errorOf(*coarser) / fine) / std::log(*d1 / *d2);
}

std::string csvTable(const Report& report, const std::vector<Result>& results)
{
    constexpr int digits = 10;
    const Columns table = columnsOf(report, results, digits);
    std::string text = joined(table.names, ",", csvCell) + "\n";
    for (const auto& row : table.rows) text += joined(row, ",", csvCell) + "\n";
    return text;
}

std::string markdownTable(const Report& report, const std::vector<Result>& results)
{
    constexpr int digits = 3;
    const Columns table = columnsOf(report, results, digits);
    std::string text = "| " + joined(table.names, " | ", markdownCell) + " |\n|";
    for (std::size_t k = 0; k < table.names.size(); ++k) text += "---|";
    text += "\n";
    for (const auto& row : table.rows) text += "| " + joined(row, " | ", markdownCell) + " |\n";
    return text;
}

}  // namespace isph
