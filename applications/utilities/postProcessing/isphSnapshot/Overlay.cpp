// SPDX-License-Identifier: GPL-3.0-or-later
#include "Overlay.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace isph {

namespace {

std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> found;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) {
        cell.erase(0, cell.find_first_not_of(" \t\r"));
        cell.erase(cell.find_last_not_of(" \t\r") + 1);
        found.push_back(cell);
    }
    return found;
}

/// Column of a quantity: named "t", "t_s", "t [s]", ...
std::size_t columnOf(const std::vector<std::string>& header, const std::string& letters)
{
    for (std::size_t c = 0; c < header.size(); ++c) {
        const std::string name = header[c].substr(0, header[c].find_first_of("_ [("));
        if (name.size() == 1 && letters.find(name) != std::string::npos) return c;
    }
    return header.size();
}

}  // namespace

Overlay::Overlay(const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in) throw FatalIOError("cannot read the file of -overlay", file.string(), 0);
    std::vector<std::string> header;
    std::size_t t = 0, x = 0, z = 0;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::vector<std::string> row = cells(line);
        if (header.empty()) {
            header = row;
            t = columnOf(header, "t"), x = columnOf(header, "x"), z = columnOf(header, "zy");
            if (std::max({t, x, z}) == header.size())
                throw FatalIOError("the header must name columns t, x and z (or y)", file.string(),
                                   number);
            continue;
        }
        try {
            profiles_[std::stod(row.at(t))].push_back(
                {{std::stod(row.at(x)), std::stod(row.at(z))}});
        } catch (const std::exception&) {
            throw FatalIOError(
                fmt::format("numbers are expected in columns {}, {} and {}", t + 1, x + 1, z + 1),
                file.string(), number);
        }
    }
    if (profiles_.empty())
        throw FatalIOError("the file of -overlay holds no data", file.string(), 0);
}

std::vector<Vec<2>> Overlay::at(Real time) const
{
    if (profiles_.empty()) return {};
    const Real tolerance =
        1e-3 * std::max(std::abs(profiles_.rbegin()->first), std::abs(profiles_.begin()->first));
    for (const auto& [t, profile] : profiles_)
        if (std::abs(t - time) <= tolerance) return profile;
    return {};
}

}  // namespace isph
