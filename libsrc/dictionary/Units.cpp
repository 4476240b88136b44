// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Units.hpp"

#include "dictionary/Lexer.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace isph {

namespace {

struct NamedUnit {
    Unit unit;
    bool takesPrefix;
};

const std::map<std::string, NamedUnit, std::less<>>& namedUnits()
{
    static const std::map<std::string, NamedUnit, std::less<>> units{
        {"kg", {{1, {{1, 0, 0, 0, 0, 0, 0}}}, false}},
        {"g", {{1e-3, {{1, 0, 0, 0, 0, 0, 0}}}, true}},
        {"m", {{1, {{0, 1, 0, 0, 0, 0, 0}}}, true}},
        {"s", {{1, {{0, 0, 1, 0, 0, 0, 0}}}, true}},
        {"min", {{60, {{0, 0, 1, 0, 0, 0, 0}}}, false}},
        {"h", {{3600, {{0, 0, 1, 0, 0, 0, 0}}}, false}},
        {"K", {{1, {{0, 0, 0, 1, 0, 0, 0}}}, true}},
        {"mol", {{1, {{0, 0, 0, 0, 1, 0, 0}}}, true}},
        {"A", {{1, {{0, 0, 0, 0, 0, 1, 0}}}, true}},
        {"cd", {{1, {{0, 0, 0, 0, 0, 0, 1}}}, true}},
        {"Hz", {{1, {{0, 0, -1, 0, 0, 0, 0}}}, true}},
        {"N", {{1, {{1, 1, -2, 0, 0, 0, 0}}}, true}},
        {"Pa", {{1, {{1, -1, -2, 0, 0, 0, 0}}}, true}},
        {"J", {{1, {{1, 2, -2, 0, 0, 0, 0}}}, true}},
        {"W", {{1, {{1, 2, -3, 0, 0, 0, 0}}}, true}},
        {"rad", {{1, {}}, false}},
        {"deg", {{std::numbers::pi / 180, {}}, false}},
    };
    return units;
}

std::optional<Unit> unitNamed(std::string_view name)
{
    if (const auto it = namedUnits().find(name); it != namedUnits().end()) return it->second.unit;
    static const std::map<char, double> prefixes{{'n', 1e-9}, {'u', 1e-6}, {'m', 1e-3}, {'c', 1e-2},
                                                 {'d', 1e-1}, {'k', 1e3},  {'M', 1e6},  {'G', 1e9}};
    const auto prefix = name.empty() ? prefixes.end() : prefixes.find(name[0]);
    if (prefix == prefixes.end()) return {};
    const auto it = namedUnits().find(name.substr(1));
    if (it == namedUnits().end() || !it->second.takesPrefix) return {};
    return Unit{prefix->second * it->second.unit.scale, it->second.unit.dimensions};
}

void multiply(Unit& product, const Unit& factor, double power)
{
    product.scale *= std::pow(factor.scale, power);
    for (std::size_t k = 0; k < 7; ++k)
        product.dimensions.exponent[k] += power * factor.dimensions.exponent[k];
}

/// Recursive descent over  product = factor { [*] factor | / factor },  factor = (name | 1 | "("
/// product ")") [^ number]
class UnitReader {
public:
    explicit UnitReader(std::string_view text) : text_(text) {}

    std::optional<Unit> whole()
    {
        const auto unit = product();
        skip();
        return unit && at_ == text_.size() ? unit : std::nullopt;
    }

private:
    std::optional<Unit> product()
    {
        Unit result;
        for (bool first = true;; first = false) {
            skip();
            if (at_ == text_.size() || text_[at_] == ')')
                return first ? std::nullopt : std::optional(result);
            double sign = 1;
            if (!first && (text_[at_] == '/' || text_[at_] == '*'))
                sign = text_[at_++] == '/' ? -1 : 1;
            const auto next = factor();
            if (!next) return {};
            multiply(result, *next, sign);
        }
    }

    std::optional<Unit> factor()
    {
        skip();
        std::optional<Unit> base;
        if (at_ < text_.size() && text_[at_] == '(') {
            ++at_;
            base = product();
            if (!base || at_ == text_.size() || text_[at_++] != ')') return {};
        } else if (at_ < text_.size() && text_[at_] == '1') {
            ++at_;
            base = Unit{};
        } else {
            const std::size_t begin = at_;
            while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])))
                ++at_;
            base = unitNamed(text_.substr(begin, at_ - begin));
        }
        if (!base || at_ == text_.size() || text_[at_] != '^') return base;
        const std::size_t begin = ++at_;
        while (at_ < text_.size() &&
               std::string_view("+-.0123456789").find(text_[at_]) != std::string_view::npos)
            ++at_;
        double power = 0;
        if (!spellsNumber(text_.substr(begin, at_ - begin), power)) return {};
        Unit result;
        multiply(result, *base, power);
        return result;
    }

    void skip()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// The exponents "0 2 -1 0 0 0 0"; empty where a word is no number or the count is neither 5 nor 7.
std::optional<Unit> exponents(std::string_view text)
{
    Unit unit;
    std::size_t count = 0;
    for (std::size_t k = text.find_first_not_of(' '); k != std::string_view::npos;) {
        const std::size_t end = std::min(text.find(' ', k), text.size());
        if (count == 7 || !spellsNumber(text.substr(k, end - k), unit.dimensions.exponent[count++]))
            return {};
        k = text.find_first_not_of(' ', end);
    }
    return count == 5 || count == 7 ? std::optional(unit) : std::nullopt;
}

}  // namespace

std::optional<Unit> parseUnit(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos || text.substr(first) == "-") return Unit{};
    if (const auto unit = exponents(text)) return unit;
    return UnitReader(text).whole();
}

bool sameDimensions(const Dimensions& a, const Dimensions& b)
{
    for (std::size_t k = 0; k < 7; ++k)
        if (std::abs(a.exponent[k] - b.exponent[k]) > 1e-9)
            return false;  // m^0.3333333333 counts as a third
    return true;
}

}  // namespace isph
