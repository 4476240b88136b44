// SPDX-License-Identifier: GPL-3.0-or-later
// Measured free surfaces that are drawn over a picture.
#pragma once
#include "core/Vec.hpp"

#include <filesystem>
#include <map>
#include <vector>

namespace isph {

/// Profiles by time: points in the order of the file.
class Overlay {
public:
    Overlay() = default;
    /// Reads a table with comma-separated columns whose header names begin with t, x and z (or y),
    /// as "t_s,x_m,z_m"; lines that begin with # are comments. Throws FatalIOError with the line.
    explicit Overlay(const std::filesystem::path& file);

    /// The profile of a time: that of the file within 0.1 % of the time span of the file, else
    /// none.
    std::vector<Vec<2>> at(Real time) const;

private:
    std::map<Real, std::vector<Vec<2>>> profiles_;
};

}  // namespace isph
