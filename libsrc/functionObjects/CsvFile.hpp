// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of reference data: numbers between commas.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// Lines that begin with # are for people; a first line of words names the columns.
struct CsvTable {
    std::string file;
    std::vector<std::string> names;  ///< empty where the file names none
    std::vector<std::vector<Real>> rows;

    /// Number of a column by its name, or by its number from 1. Throws FatalError that lists them.
    std::size_t column(const std::string& name) const;
};

/// Throws FatalError for a file that cannot be read or has no row, FatalIOError with its line at
/// what is no number and at rows of another length.
CsvTable readCsv(const std::filesystem::path& file);

/// One column over another, in ascending order of the first; linear in between.
struct CsvCurve {
    std::vector<Real> x, y;

    /// Throws FatalError where a column is not there, or a value of x stands twice.
    CsvCurve(const CsvTable& table, std::size_t xColumn, std::size_t yColumn);
    bool contains(Real at) const { return at >= x.front() && at <= x.back(); }
    /// The end's value outside.
    Real operator()(Real at) const;
};

}  // namespace isph
