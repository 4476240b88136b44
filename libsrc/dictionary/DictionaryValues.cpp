// SPDX-License-Identifier: GPL-3.0-or-later
// Typed look-up: from the tokens of an entry to numbers, vectors, words and lists.
#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/Units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace isph {

namespace {

using Tokens = std::span<const Token>;

bool isMark(const Token& token, char mark)
{
    return token.kind == Token::Kind::punctuation && token.text[0] == mark;
}

/// Why a value is not of the type asked for.
struct Mismatch {
    std::string reason;
};

[[noreturn]] void expected(const std::string& what, Tokens found)
{
    throw Mismatch{"expected " + what + (found.empty() ? ", found nothing" : "")};
}

/// Takes one value of type T from the front of the tokens.
template <class T>
T take(Tokens& tokens, double scale);

template <>
Real take<Real>(Tokens& tokens, double scale)
{
    if (tokens.empty() || tokens[0].kind != Token::Kind::number) expected("a number", tokens);
    const Real value = tokens[0].number * scale;
    tokens = tokens.subspan(1);
    return value;
}

template <>
int take<int>(Tokens& tokens, double scale)
{
    if (tokens.empty() || tokens[0].kind != Token::Kind::number) expected("a whole number", tokens);
    const Real value = tokens[0].number * scale;
    if (value != std::floor(value) || std::abs(value) > 2147483647.0)
        expected("a whole number", tokens);
    tokens = tokens.subspan(1);
    return static_cast<int>(value);
}

template <>
bool take<bool>(Tokens& tokens, double)
{
    const std::string text = tokens.empty() ? "" : tokens[0].text;
    const bool yes = text == "yes" || text == "on" || text == "true";
    if (!yes && text != "no" && text != "off" && text != "false")
        expected("a switch: yes, no, on, off, true or false", tokens);
    tokens = tokens.subspan(1);
    return yes;
}

/// Numbers pass as their text, so that ("sin(x)" 0 0) is a list of three expressions.
template <>
std::string take<std::string>(Tokens& tokens, double)
{
    if (tokens.empty() || tokens[0].kind == Token::Kind::punctuation)
        expected("a word or a string", tokens);
    const std::string text = tokens[0].text;
    tokens = tokens.subspan(1);
    return text;
}

/// (x y z), and (x y) with z = 0 where `flat` allows it.
Vector3 takeVector(Tokens& tokens, double scale, bool flat)
{
    const Tokens all = tokens;
    const std::string form = flat ? "a vector (x y z) or (x y)" : "a vector (x y z)";
    Vector3 value{};
    if (tokens.empty() || !isMark(tokens[0], '(')) expected(form, all);
    tokens = tokens.subspan(1);
    std::size_t count = 0;
    while (!tokens.empty() && tokens[0].kind == Token::Kind::number && count < 3)
        value[count++] = take<Real>(tokens, scale);
    if (tokens.empty() || !isMark(tokens[0], ')') || count < (flat ? 2u : 3u)) expected(form, all);
    tokens = tokens.subspan(1);
    return value;
}

template <>
Vector3 take<Vector3>(Tokens& tokens, double scale)
{
    return takeVector(tokens, scale, false);
}

template <class T>
T takeElement(Tokens& tokens, double scale)
{
    if constexpr (std::is_same_v<T, Vector3>)
        return takeVector(tokens, scale, true);
    else
        return take<T>(tokens, scale);
}

/// (a b c), 3(a b c) or 3{a}, with or without "List<scalar>" before it.
template <class T>
std::vector<T> takeList(Tokens& tokens, double scale)
{
    const Tokens all = tokens;
    const std::string form = "a list: (a b c), 3(a b c) or 3{a}";
    if (!tokens.empty() && tokens[0].kind == Token::Kind::word &&
        tokens[0].text.starts_with("List<"))
        tokens = tokens.subspan(1);
    int count = -1;
    if (!tokens.empty() && tokens[0].kind == Token::Kind::number) count = take<int>(tokens, 1);
    if (tokens.empty()) expected(form, all);
    std::vector<T> values;
    const bool uniform = count >= 0 && isMark(tokens[0], '{');
    if (!uniform && !isMark(tokens[0], '(')) expected(form, all);
    const char end = uniform ? '}' : ')';
    tokens = tokens.subspan(1);
    while (!tokens.empty() && !isMark(tokens[0], end))
        values.push_back(takeElement<T>(tokens, scale));
    if (tokens.empty() || (uniform && values.size() != 1)) expected(form, all);
    tokens = tokens.subspan(1);
    if (uniform) values.assign(static_cast<std::size_t>(count), T(values[0]));
    if (count >= 0 && values.size() != static_cast<std::size_t>(count))
        throw Mismatch{fmt::format("the list has {} elements, not the {} that it announces",
                                   values.size(), count)};
    return values;
}

template <>
std::vector<Real> take(Tokens& tokens, double scale)
{
    return takeList<Real>(tokens, scale);
}
template <>
std::vector<int> take(Tokens& tokens, double scale)
{
    return takeList<int>(tokens, scale);
}
template <>
std::vector<std::string> take(Tokens& tokens, double scale)
{
    return takeList<std::string>(tokens, scale);
}
template <>
std::vector<Vector3> take(Tokens& tokens, double scale)
{
    return takeList<Vector3>(tokens, scale);
}

/// Takes "[m^2/s]", with the name of the old form before it, from the front; returns the scale to
/// SI.
double takeDimensions(Tokens& tokens, std::string_view key, const Dimensions& required)
{
    const bool oldForm =
        tokens.size() > 2 && tokens[0].kind == Token::Kind::word && isMark(tokens[1], '[');
    const Tokens rest = oldForm ? tokens.subspan(1) : tokens;
    if (rest.empty() || !isMark(rest[0], '[')) return 1;
    std::string text;
    std::size_t k = 1;
    for (; k < rest.size() && !isMark(rest[k], ']'); ++k) text += rest[k].text + ' ';
    if (!text.empty()) text.pop_back();
    const auto unit = parseUnit(text);
    if (!unit)
        throw Mismatch{fmt::format(
            "'[{}]' is neither a dimension set like [0 2 -1 0 0 0 0] nor units like [m^2/s], "
            "[kg m^-3], [mm] (names: kg g m s min h K mol A cd Hz N Pa J W rad deg)",
            text)};
    if (!sameDimensions(unit->dimensions, required))
        throw Mismatch{fmt::format(
            "The dimensions {} provided do not match the required dimensions {} of '{}'",
            toString(unit->dimensions), toString(required), key)};
    tokens = rest.subspan(k + 1);
    return unit->scale;
}

/// "; is a ';' missing after line 3?" where the value goes on in a later line than the keyword's.
std::string semicolonHint(Tokens left, const Location& at)
{
    if (left.empty() || left[0].at.file != at.file || left[0].at.line <= at.line) return "";
    return fmt::format("\nIs a ';' missing before '{}' in line {}?", left[0].text, left[0].at.line);
}

[[noreturn]] void failValue(const Dictionary& dict, std::string_view key, const std::string& reason)
{
    dict.fail(key, fmt::format("keyword {} in dictionary \"{}\" has the value '{}': {}", key,
                               dict.name(), textOf(dict.tokens(key)), reason));
}

}  // namespace

void checkDimensions(const Dictionary& dict, std::string_view key, const Dimensions& required)
{
    Tokens tokens(dict.tokens(key));
    try {
        takeDimensions(tokens, key, required);
    } catch (const Mismatch& mismatch) {
        failValue(dict, key, mismatch.reason);
    }
}

template <class T>
T Dictionary::get(std::string_view key, const Dimensions& required) const
{
    Tokens left(tokens(key));
    try {
        const double scale = takeDimensions(left, key, required);
        T value = take<T>(left, scale);
        if (left.empty()) return value;
    } catch (const Mismatch& mismatch) {
        failValue(*this, key, mismatch.reason);
    }
    failValue(
        *this, key,
        fmt::format("'{}' follows the value{}", left[0].text, semicolonHint(left, location(key))));
}

template Real Dictionary::get<Real>(std::string_view, const Dimensions&) const;
template int Dictionary::get<int>(std::string_view, const Dimensions&) const;
template bool Dictionary::get<bool>(std::string_view, const Dimensions&) const;
template std::string Dictionary::get<std::string>(std::string_view, const Dimensions&) const;
template Vector3 Dictionary::get<Vector3>(std::string_view, const Dimensions&) const;
template std::vector<Real> Dictionary::get<std::vector<Real>>(std::string_view,
                                                              const Dimensions&) const;
template std::vector<int> Dictionary::get<std::vector<int>>(std::string_view,
                                                            const Dimensions&) const;
template std::vector<std::string> Dictionary::get<std::vector<std::string>>(
    std::string_view, const Dimensions&) const;
template std::vector<Vector3> Dictionary::get<std::vector<Vector3>>(std::string_view,
                                                                    const Dimensions&) const;

std::string Dictionary::getChoice(std::string_view key,
                                  const std::vector<std::string>& allowed) const
{
    const std::string value = get<std::string>(key);
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
    const std::string near = nearestName(value, allowed);
    fail(key, fmt::format("keyword {} in dictionary \"{}\":\n{} is not in enumeration: {}{}", key,
                          name(), value, listOf(allowed),
                          near.empty() ? "" : "Did you mean '" + near + "'?"));
}

std::string Dictionary::getChoice(std::string_view key, const std::vector<std::string>& allowed,
                                  const std::string& otherwise) const
{
    return found(key) ? getChoice(key, allowed) : otherwise;
}

}  // namespace isph
