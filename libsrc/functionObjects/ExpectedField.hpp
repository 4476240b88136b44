// SPDX-License-Identifier: GPL-3.0-or-later
// What a field should be: an expression of place and time, or reference data.
#pragma once
#include "dictionary/Expression.hpp"
#include "dictionary/Schema.hpp"
#include "functionObjects/CsvFile.hpp"

#include <map>
#include <optional>

namespace isph {

/// The constants { U 1; decay "8*pi^2/Re"; } of a dictionary: numbers in SI units, or expressions,
/// in quotes, of those before them. Those of sub-dictionaries count too, words and lists do not, so
/// that a file of the case can be included. Throws FatalIOError with muParser's message.
std::map<std::string, Real> readConstants(const Dictionary& dict);

/// The expression of an entry, with the constants. Throws FatalIOError with muParser's message.
FieldExpression readExpression(const Dictionary& dict, const std::string& key,
                               const std::string& text,
                               const std::map<std::string, Real>& constants);

/// The expected value of each component of a field, from one of
///   expression "sin(pi*x)";                  of a scalar or a component
///   expressions ("-y" "x");                  of a vector
///   reference { file; along x|y|z|t; coordinate <column>; value <column>; }
/// A reference along x, y or z is a profile, along t a time series; linear between its rows. A file
/// name is relative to the case.
class ExpectedField {
public:
    static std::vector<Key> keys();
    /// Throws FatalIOError or FatalError for anything that does not make sense.
    explicit ExpectedField(const Dictionary& dict);

    /// Of the expressions that were given; 1 for a reference.
    int components() const;
    /// Whether the data reach to this place and time; expressions always do.
    bool covers(const std::array<Real, 3>& place, Real time) const;
    Real value(int component, const std::array<Real, 3>& place, Real time) const;

    /// The places of a profile: `through` with its coordinate replaced by that of each row.
    std::vector<std::array<Real, 3>> profilePoints(const std::array<Real, 3>& through) const;
    bool isProfile() const { return curve_ && axis_ < 3; }

private:
    void readReference(const Dictionary& dict);
    void readExpressions(const Dictionary& dict);

    std::vector<FieldExpression> expressions_;
    std::optional<CsvCurve> curve_;
    int axis_ = 0;  ///< of the curve; 3: time
};

}  // namespace isph
