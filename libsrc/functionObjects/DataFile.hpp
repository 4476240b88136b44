// SPDX-License-Identifier: GPL-3.0-or-later
// The files of function objects: lines that begin with #, the last of which names the columns, then
// rows.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace isph {

/// Writes row by row; what is written can be read at once by others. Numbers have the fewest digits
/// that give the same bits when read.
class DataWriter {
public:
    /// Makes the folders. A file that stands there already is kept as <file>.1, <file>.2, ...
    /// Throws FatalError where the file cannot be made.
    DataWriter(const std::filesystem::path& file, const std::vector<std::string>& header,
               const std::vector<std::string>& columns);
    /// Throws FatalError where the row could not be written (a full disk).
    void write(Real time, const std::vector<Real>& values);

private:
    std::filesystem::path file_;
    std::ofstream out_;
};

struct DataTable {
    std::vector<std::string> columns;                 ///< the first is Time
    std::map<std::string, std::vector<Real>> header;  ///< "# x 0.1 0.2": numbers behind a word
    std::vector<std::vector<Real>> rows;
};

/// Reads a file. Throws FatalIOError, with its line, at what is no number and at rows of another
/// length than the line of columns. A last line without its end (the run was killed while writing)
/// is left out.
DataTable readDataTable(const std::filesystem::path& file);

/// The whole measurement of a function object from postProcessing/<name>: the rows of all its start
/// times in order; where a restart measured again what an earlier run had, the later start counts.
DataTable readAllStarts(const std::filesystem::path& folder);

}  // namespace isph
