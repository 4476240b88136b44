// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a report in rows and columns.
#pragma once
#include "VariantCase.hpp"

#include <functional>

namespace isph {

struct Result {
    const Variant* variant;
    Outcome outcome;
};

/// Names of all errors, in the order in which they first appear.
std::vector<std::string> errorNames(const std::vector<Result>& results);

/// The variants of one line, in descending order along it. Where no key makes lines, the family of
/// a variant is the key that it varies, and the case itself belongs to each.
struct Line {
    std::string name;
    std::vector<const Result*> points;
};
std::vector<Line> lines(const Report& report, const std::vector<Result>& results);

/// Observed order of an error between a result and the next coarser one of its line that has it:
/// ln(e1/e2)/ln(d1/d2); none without such a one.
std::optional<Real> observedOrder(const Report& report, const Line& line, const Result& result,
                                  const std::string& error);

/// One row a variant: variant, keys, particles, steps, wall and CPU seconds, memory in MB, each
/// error, its order, stable, why.
std::string csvTable(const Report& report, const std::vector<Result>& results);
/// The same for people.
std::string markdownTable(const Report& report, const std::vector<Result>& results);

}  // namespace isph
