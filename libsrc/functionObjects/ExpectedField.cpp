// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/ExpectedField.hpp"

#include "dictionary/Units.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace isph {

namespace fs = std::filesystem;

namespace {

Schema referenceKeys()
{
    return {Key::text("file", "Numbers between commas, relative to the case."),
            Key::word("along", "What the first column is: a coordinate (profile) or t (series).")
                .oneOf({"x", "y", "z", "t"}),
            Key::text("coordinate", "Name or number of the column of places or times.")
                .byDefault("\"1\""),
            Key::text("value", "Name or number of the column of values.").byDefault("\"2\"")};
}

/// A relative name begins at the case ($FOAM_CASE, which every program sets), else where one is.
fs::path inCase(const fs::path& name)
{
    const char* folder = std::getenv("FOAM_CASE");
    return folder && name.is_relative() ? fs::path(folder) / name : name;
}

/// The text of an entry that may be a number or a word, as columns of a file are.
std::string textOf(const Dictionary& dict, const Schema& keys, const std::string& key)
{
    return dict.found(key) ? dict.tokens(key).front().text : keys.get<std::string>(dict, key);
}

/// A number in SI units, whatever its dimensions are; none for lists and words.
std::optional<Real> numberOf(const Dictionary& dict, const std::string& key)
{
    const std::vector<Token>& tokens = dict.tokens(key);
    if (tokens.empty() || tokens.back().kind != Token::Kind::number) return std::nullopt;
    std::string text;
    bool inside = false;
    for (const Token& token : tokens) {
        if (token.text == "]") inside = false;
        if (inside) text += (text.empty() ? "" : " ") + token.text;
        if (token.text == "[") inside = true;
    }
    const std::optional<Unit> unit = parseUnit(text);
    return dict.get<Real>(key, unit ? unit->dimensions : dims::none);
}

void addConstants(const Dictionary& entries, std::map<std::string, Real>& constants)
{
    for (const std::string& name : entries.keywords()) {
        if (name == "FoamFile") continue;
        if (entries.isDict(name)) {
            addConstants(entries.subDict(name), constants);
            continue;
        }
        const std::vector<Token>& tokens = entries.tokens(name);
        if (const std::optional<Real> number = numberOf(entries, name))
            constants[name] = *number;
        else if (tokens.size() == 1 && tokens[0].kind == Token::Kind::string)
            constants[name] =
                readExpression(entries, name, tokens[0].text, constants)({0, 0, 0}, 0);
    }
}

}  // namespace

std::map<std::string, Real> readConstants(const Dictionary& dict)
{
    std::map<std::string, Real> constants;
    if (dict.found("constants")) addConstants(dict.subDict("constants"), constants);
    return constants;
}

FieldExpression readExpression(const Dictionary& dict, const std::string& key,
                               const std::string& text,
                               const std::map<std::string, Real>& constants)
{
    try {
        return {text, constants};
    } catch (const std::runtime_error& error) {
        dict.fail(key, fmt::format("the expression \"{}\" of {}: {}", text, key, error.what()));
    }
}

std::vector<Key> ExpectedField::keys()
{
    return {
        Key::text("expression", "What a scalar field should be, an expression of x, y, z and t.")
            .mayBeAbsent(),
        Key::list("expressions", "What a vector should be, one expression for each component.")
            .mayBeAbsent(),
        Key::dictionary("constants",
                        "Names for expressions: numbers, or expressions of those above.")
            .mayBeAbsent(),
        Key::dictionary(
            "reference",
            "Instead of expression: file <csv>; along x|y|z|t; coordinate, value: columns.")
            .mayBeAbsent()};
}

ExpectedField::ExpectedField(const Dictionary& dict)
{
    if (dict.found("expression") + dict.found("expressions") + dict.found("reference") != 1)
        dict.fail("expression", fmt::format("\"{}\" needs one of expression \"...\", expressions "
                                            "(\"...\" \"...\") and reference {{ file; along; }}",
                                            dict.name()));
    if (dict.found("reference"))
        readReference(dict.subDict("reference"));
    else
        readExpressions(dict);
}

void ExpectedField::readReference(const Dictionary& dict)
{
    const Schema keys = referenceKeys();
    keys.check(dict);
    const std::string along = keys.get<std::string>(dict, "along");
    axis_ = along == "t" ? 3 : along[0] - 'x';
    const std::string file = keys.get<std::string>(dict, "file");
    try {
        const CsvTable table = readCsv(inCase(file));
        curve_.emplace(table, table.column(textOf(dict, keys, "coordinate")),
                       table.column(textOf(dict, keys, "value")));
    } catch (const FatalIOError&) {
        throw;
    } catch (const FatalError& error) {
        dict.fail("file", error.what());
    }
}

void ExpectedField::readExpressions(const Dictionary& dict)
{
    const std::map<std::string, Real> constants = readConstants(dict);
    const std::string key = dict.found("expression") ? "expression" : "expressions";
    for (const Token& token : dict.tokens(key))
        if (token.kind != Token::Kind::punctuation)
            expressions_.push_back(readExpression(dict, key, token.text, constants));
    if (expressions_.empty()) dict.fail(key, key + " is empty");
}

int ExpectedField::components() const
{
    return curve_ ? 1 : static_cast<int>(expressions_.size());
}

bool ExpectedField::covers(const std::array<Real, 3>& place, Real time) const
{
    constexpr Real rounding = 1e-9;  // of the data's length: times are sums of steps
    if (!curve_) return true;
    const Real at = axis_ == 3 ? time : place[static_cast<std::size_t>(axis_)];
    const Real slack = rounding * (curve_->x.back() - curve_->x.front());
    return at >= curve_->x.front() - slack && at <= curve_->x.back() + slack;
}

Real ExpectedField::value(int component, const std::array<Real, 3>& place, Real time) const
{
    if (!curve_) return expressions_[static_cast<std::size_t>(component)](place, time);
    return (*curve_)(axis_ == 3 ? time : place[static_cast<std::size_t>(axis_)]);
}

std::vector<std::array<Real, 3>> ExpectedField::profilePoints(
    const std::array<Real, 3>& through) const
{
    std::vector<std::array<Real, 3>> points;
    for (const Real at : curve_->x) {
        points.push_back(through);
        points.back()[static_cast<std::size_t>(axis_)] = at;
    }
    return points;
}

}  // namespace isph
