// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of a field's values.
#pragma once
#include "core/Types.hpp"

#include <string>
#include <vector>

namespace isph {

struct Colour {
    Real red = 0, green = 0, blue = 0;  ///< 0 to 1
};

Colour mix(const Colour& a, const Colour& b, Real shareOfB);

/// The colour map viridis (van der Walt and Smith, matplotlib, CC0) at 0 <= share <= 1: equal steps
/// of the value look equal, in grey print and to the colour-blind too. Beyond 0 and 1: its ends.
Colour viridis(Real share);

struct Range {
    Real low = 0, high = 1;
    /// Where a value lies, 0 at low and 1 at high.
    Real share(Real value) const { return (value - low) / (high - low); }
};

/// A range whose ends are round numbers and that holds all but a share `outliers` of the values at
/// either end; from 0 where all are positive and the least is small. Of equal values: of the
/// value's size.
Range roundRange(std::vector<Real> values, Real outliers);

/// Round numbers in a range, about `count` of them.
std::vector<Real> roundTicks(const Range& range, int count);
/// A tick as text, with as many digits as the distance of ticks needs.
std::string tickText(Real tick, Real distance);

}  // namespace isph
