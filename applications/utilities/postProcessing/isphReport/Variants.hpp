// SPDX-License-Identifier: GPL-3.0-or-later
// The variants of a case that a report runs.
#pragma once
#include "ReportDict.hpp"

namespace isph {

/// The value of one key in a variant.
struct Setting {
    const VariedKey* key;
    KeyValue value;
    bool isBase;  ///< as the case has it: nothing is changed
};

struct Variant {
    std::string name;               ///< of its folder: "spacing=0.02_kernel=cubicSpline", "base"
    std::string family;             ///< its settings but the one along which lines are drawn
    std::vector<Setting> settings;  ///< one for each key of the report, in its order

    /// The number on the axis of lines; none without such an axis, or for words.
    std::optional<Real> along(const Report& report) const;
};

/// All variants, none twice. The report must outlive them.
///   grid        every combination of the keys' values
///   oneAtATime  the case itself, and every value of every key by itself; where lines are drawn
///   along
///               a key, all of this at every value of that key
std::vector<Variant> variantsOf(const Report& report);

}  // namespace isph
