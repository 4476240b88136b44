// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/DataFile.hpp"

#include "case/TimeList.hpp"
#include "core/Error.hpp"

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <sstream>

namespace isph {

namespace fs = std::filesystem;

namespace {

/// Moves a file out of the way of a new one: nothing that was measured is overwritten.
void keepOld(const fs::path& file)
{
    if (!fs::exists(file)) return;
    int k = 1;
    const auto kept = [&] { return fs::path(fmt::format("{}.{}", file.string(), k)); };
    while (fs::exists(kept())) ++k;
    fs::rename(file, kept());
}

std::optional<Real> number(const std::string& word)
{
    Real value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

std::vector<std::string> words(const std::string& line)
{
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string word; in >> word;) all.push_back(word);
    return all;
}

/// "# Time a b" names the columns, "# x 0.1 0.2" is a list of numbers, anything else is for people.
void readComment(const std::vector<std::string>& line, DataTable& table)
{
    if (line.size() < 2) return;
    if (line[1] == "Time") {
        table.columns.assign(line.begin() + 1, line.end());
        return;
    }
    std::vector<Real> values;
    for (std::size_t k = 2; k < line.size(); ++k) {
        const std::optional<Real> value = number(line[k]);
        if (!value) return;
        values.push_back(*value);
    }
    table.header[line[1]] = values;
}

std::vector<Real> readRow(const std::vector<std::string>& line, const DataTable& table,
                          const std::string& file, int lineNumber)
{
    std::vector<Real> row;
    for (const std::string& word : line) {
        const std::optional<Real> value = number(word);
        if (!value) throw FatalIOError(fmt::format("'{}' is no number", word), file, lineNumber);
        row.push_back(*value);
    }
    if (row.size() != table.columns.size())
        throw FatalIOError(
            fmt::format("{} values, but the line that begins with # Time names {} columns",
                        row.size(), table.columns.size()),
            file, lineNumber);
    return row;
}

}  // namespace

DataWriter::DataWriter(const fs::path& file, const std::vector<std::string>& header,
                       const std::vector<std::string>& columns)
    : file_(file)
{
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        throw FatalError(fmt::format("Cannot make the folder {}: {}", file.parent_path().string(),
                                     error.message()));
    keepOld(file);
    out_.open(file);
    for (const std::string& line : header) out_ << "# " << line << '\n';
    out_ << fmt::format("{:<24}", "# Time");
    for (const std::string& column : columns) out_ << fmt::format(" {:>23}", column);
    out_ << '\n' << std::flush;
    if (!out_) throw FatalError(fmt::format("Cannot write {}", file.string()));
}

void DataWriter::write(Real time, const std::vector<Real>& values)
{
    std::string line = fmt::format("{:<24}", fmt::format("{}", time));
    for (const Real value : values) line += fmt::format(" {:>23}", fmt::format("{}", value));
    out_ << line << '\n' << std::flush;
    if (!out_)
        throw FatalError(fmt::format("Cannot write to {} (is the disk full?)", file_.string()));
}

DataTable readDataTable(const fs::path& file)
{
    std::ifstream in(file);
    if (!in) throw FatalError(fmt::format("Cannot read {}", file.string()));
    DataTable table;
    int lineNumber = 0;
    for (std::string line; std::getline(in, line);) {
        ++lineNumber;
        if (in.eof()) break;  // no end of line: cut off
        const std::vector<std::string> parts = words(line);
        if (parts.empty()) continue;
        if (parts[0] == "#")
            readComment(parts, table);
        else
            table.rows.push_back(readRow(parts, table, file.string(), lineNumber));
    }
    if (table.columns.empty())
        throw FatalIOError("no line \"# Time ...\" names the columns", file.string(), 0);
    return table;
}

DataTable readAllStarts(const fs::path& folder)
{
    DataTable all;
    const std::string name = (folder / "").parent_path().filename().string() + ".dat";
    for (const TimeFolder& start : timeFolders(folder)) {
        const fs::path file = start.path / name;
        if (!fs::exists(file)) continue;
        DataTable part = readDataTable(file);
        if (!all.columns.empty() && part.columns != all.columns)
            throw FatalIOError(
                fmt::format("other columns than the start before has; give one of the files of {}",
                            folder.string()),
                file.string(), 0);
        while (!all.rows.empty() && !part.rows.empty() &&
               all.rows.back()[0] >= part.rows.front()[0])
            all.rows.pop_back();
        part.rows.insert(part.rows.begin(), all.rows.begin(), all.rows.end());
        all = std::move(part);
    }
    if (all.columns.empty())
        throw FatalError(fmt::format("{} holds no <startTime>/{}", folder.string(), name));
    return all;
}

}  // namespace isph
