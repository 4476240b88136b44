// SPDX-License-Identifier: GPL-3.0-or-later
// Dimension sets and unit names as they stand between [ and ] in a dictionary.
#pragma once
#include "dictionary/Dimensions.hpp"

#include <optional>
#include <string_view>

namespace isph {

/// What a value given in a unit is multiplied with, and the dimensions it then has (SI).
struct Unit {
    double scale = 1;
    Dimensions dimensions{};
};

/// "0 2 -1 0 0 0 0" (five numbers are enough), "m^2/s", "kg m^-3", "Pa s", "mm", "kg/(m s)", "-" or
/// "". A slash divides by the one name or parenthesis that follows. Names: base and derived SI
/// units with the prefixes n u m c d k M G, and min, h, deg, rad. Errors: empty where the text is
/// none of these.
std::optional<Unit> parseUnit(std::string_view text);

/// Equal but for the rounding of fractional exponents.
bool sameDimensions(const Dimensions& a, const Dimensions& b);

}  // namespace isph
