// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/CsvFile.hpp"

#include "core/Error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <numeric>
#include <optional>

namespace isph {

namespace {

std::vector<std::string> cellsOf(const std::string& line)
{
    constexpr const char* blank = " \t\r";
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t comma = std::min(line.find(',', begin), line.size());
        const std::string cell = line.substr(begin, comma - begin);
        const std::size_t first = cell.find_first_not_of(blank);
        cells.push_back(first == std::string::npos
                            ? ""
                            : cell.substr(first, cell.find_last_not_of(blank) - first + 1));
        begin = comma + 1;
    }
    return cells;
}

std::optional<std::vector<Real>> numbersOf(const std::vector<std::string>& cells)
{
    std::vector<Real> row;
    for (const std::string& cell : cells) {
        Real value = 0;
        const char* end = cell.data() + cell.size();
        const auto [stop, error] = std::from_chars(cell.data(), end, value);
        if (error != std::errc() || stop != end) return std::nullopt;
        row.push_back(value);
    }
    return row;
}

}  // namespace

CsvTable readCsv(const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in) throw FatalError(fmt::format("Cannot read {}", file.string()));
    CsvTable table{file.string(), {}, {}};
    int lineNumber = 0;
    for (std::string line; std::getline(in, line);) {
        ++lineNumber;
        if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
        const std::vector<std::string> cells = cellsOf(line);
        std::optional<std::vector<Real>> row = numbersOf(cells);
        const bool first = table.rows.empty() && table.names.empty();
        if (!row && first) {
            table.names = cells;
            continue;
        }
        if (!row)
            throw FatalIOError(fmt::format("expected numbers between commas, found '{}'", line),
                               table.file, lineNumber);
        const std::size_t width = table.rows.empty() ? std::max(table.names.size(), std::size_t{1})
                                                     : table.rows[0].size();
        const bool fits = (table.rows.empty() && table.names.empty()) || row->size() == width;
        if (!fits)
            throw FatalIOError(
                fmt::format("{} numbers, where the lines before have {}", row->size(), width),
                table.file, lineNumber);
        table.rows.push_back(std::move(*row));
    }
    if (table.rows.empty()) throw FatalError(fmt::format("{} holds no row", table.file));
    return table;
}

std::size_t CsvTable::column(const std::string& name) const
{
    const auto it = std::find(names.begin(), names.end(), name);
    if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
    std::size_t number = 0;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, number);
    if (error == std::errc() && stop == end && number >= 1 && number <= rows[0].size())
        return number - 1;
    throw FatalError(fmt::format("{} has no column {}\n\nIt has {} columns, named:\n\n{}", file,
                                 name, rows[0].size(), listOf(names)));
}

CsvCurve::CsvCurve(const CsvTable& table, std::size_t xColumn, std::size_t yColumn)
{
    const std::size_t width = table.rows[0].size();
    if (std::max(xColumn, yColumn) >= width)
        throw FatalError(fmt::format("{} has {} columns only", table.file, width));
    std::vector<std::size_t> order(table.rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return table.rows[a][xColumn] < table.rows[b][xColumn];
    });
    for (const std::size_t k : order) {
        const Real at = table.rows[k][xColumn];
        if (!x.empty() && at == x.back())
            throw FatalError(fmt::format("{} has two rows for {}", table.file, at));
        x.push_back(at);
        y.push_back(table.rows[k][yColumn]);
    }
}

Real CsvCurve::operator()(Real at) const
{
    const auto above = std::upper_bound(x.begin(), x.end(), at);
    if (above == x.begin()) return y.front();
    if (above == x.end()) return y.back();
    const auto k = static_cast<std::size_t>(above - x.begin());
    const Real share = (at - x[k - 1]) / (x[k] - x[k - 1]);
    return (1 - share) * y[k - 1] + share * y[k];
}

}  // namespace isph
