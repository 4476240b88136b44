// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a report, made by gnuplot as SVG and PNG.
#pragma once
#include "Tables.hpp"

namespace isph {

/// Writes <name>.gnuplot into `folder` and runs it, for each error:
///   <error>-wallTime     error against wall time, both logarithmic, a line a family
///   <error>-<along>      error against the key along which lines are drawn, with the fitted slope
///                        of each and lines of slope 1 and 2
/// and for a grid of two keys <error>-map, where runs are stable, coloured by the error.
/// Returns the names of the plots. Throws FatalError where gnuplot is missing or fails.
std::vector<std::string> makePlots(const Report& report, const std::vector<Result>& results,
                                   const std::filesystem::path& folder);

}  // namespace isph
