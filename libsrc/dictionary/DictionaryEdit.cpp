// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of a dictionary's text that leave the rest of it alone.
#include "core/Error.hpp"
#include "dictionary/DictionaryContent.hpp"
#include "dictionary/DictionarySource.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace isph {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kIndent = 4, kValueColumn = 16;

bool isDictText(const std::string& value)
{
    return !value.empty() && value[0] == '{';
}

std::string trimmed(std::string text)
{
    const auto blank = " \t\r\n";
    text.erase(0, std::min(text.find_first_not_of(blank), text.size()));
    while (!text.empty() &&
           std::string_view(" \t\r\n;").find(text.back()) != std::string_view::npos)
        text.pop_back();
    return text;
}

/// "key value;" or "key { ... }" in one line.
std::string inOneLine(const std::string& key, const std::string& value)
{
    if (isDictText(value)) return fmt::format("{} {}", key, value);
    return value.empty() ? key + ";" : fmt::format("{} {};", key, value);
}

/// The same with the value in its column, and a dictionary's brace in a line of its own.
std::string inLines(const std::string& key, const std::string& value, const std::string& indent)
{
    if (isDictText(value)) return fmt::format("{0}{1}\n{0}{2}", indent, key, value);
    if (value.empty()) return fmt::format("{}{};", indent, key);
    return fmt::format("{}{}{}{};", indent, key,
                       std::string(std::max(kValueColumn, key.size() + 1) - key.size(), ' '),
                       value);
}

/// The rest of a line after an entry belongs to it if it is blank or a comment to the line's end.
bool endsLine(const std::string& text, std::size_t position)
{
    const std::size_t next = text.find_first_not_of(" \t\r", position);
    return next == std::string::npos || text[next] == '\n' || text.compare(next, 2, "//") == 0;
}

/// The new value must be one value: "1; b 2" would bring a second entry.
void checkValue(const std::string& key, const std::string& value)
{
    const DictionarySource probe(inOneLine("x", value), fmt::format("the new value of {}", key));
    if (probe.keywords("").size() != 1 || probe.valueText("x") != value)
        throw FatalError(fmt::format("'{}' is not the value of one entry ({})", value, key));
}

}  // namespace

std::string DictionarySource::lineIndent(std::size_t position) const
{
    const std::size_t start =
        position == 0 ? 0 : text_.rfind('\n', position - 1) + 1;  // npos + 1 is 0
    const std::size_t end = std::min(text_.find_first_not_of(" \t", start), text_.size());
    return text_.substr(start, end - start);
}

void DictionarySource::set(std::string_view path, const std::string& value)
{
    const Path parts = partsOf(path);
    if (parts.empty()) throw FatalError("An entry to set needs a keyword");
    const std::string plain = trimmed(value);
    checkValue(parts.back(), plain);
    const std::vector<const Item*> found = occurrences(parts);
    if (found.empty())
        insert(parts, plain);
    else
        replaceValue(effective(found, parts), plain);
    parse();
}

void DictionarySource::add(std::string_view path, const std::string& value)
{
    const Path parts = partsOf(path);
    if (const auto there = occurrences(parts); !parts.empty() && !there.empty())
        throw FatalIOError(
            fmt::format("Cannot add entry {}: it is there already, with the value\n{}", path,
                        valueText(path)),
            name_, there.front()->line);
    set(path, value);
}

void DictionarySource::replaceValue(const Item& item, const std::string& value)
{
    if (item.isDict != isDictText(value)) {  // "key { ... }" has no semicolon
        const std::string indent = lineIndent(item.begin);
        text_.replace(item.begin, item.end - item.begin,
                      inLines(item.key, value, indent).substr(indent.size()));
    } else if (item.valueBegin == item.valueEnd) {
        text_.insert(item.valueEnd, " " + value);
    } else {
        text_.replace(item.valueBegin, item.valueEnd - item.valueBegin, value);
    }
}

/// At the end of the deepest dictionary of the path that is there; the others are made.
void DictionarySource::insert(const Path& path, const std::string& value)
{
    Path scope(path.begin(), path.end() - 1);
    while (occurrences(scope).empty()) scope.pop_back();
    const Item& dict = *occurrences(scope).back();
    if (!dict.isDict)
        throw FatalIOError(fmt::format("'{}' is not a dictionary in this file: '{}' cannot be "
                                       "added to it",
                                       dict.key, fmt::join(path, "/")),
                           name_, dict.line);
    const Path rest(path.begin() + static_cast<std::ptrdiff_t>(scope.size()), path.end());
    const bool top = &dict == &top_;
    const std::size_t newline = text_.find('\n', dict.valueBegin);
    if (!top && newline >= dict.valueEnd) return insertInLine(dict, rest, value);
    insertLines(dict, rest, value);
}

/// "{ a 1; }" becomes "{ a 1; b 2; }".
void DictionarySource::insertInLine(const Item& dict, const Path& path, const std::string& value)
{
    std::string text = inOneLine(path.back(), value);
    for (std::size_t k = path.size() - 1; k-- > 0;)
        text = fmt::format("{} {{ {} }}", path[k], text);
    const std::size_t at = dict.items.empty() ? dict.valueBegin + 1 : dict.items.back().end;
    text_.insert(at, fmt::format(" {}{}", text, text_[at] == '}' ? " " : ""));
}

void DictionarySource::insertLines(const Item& dict, const Path& path, const std::string& value)
{
    const bool top = &dict == &top_, hasItems = !dict.items.empty();
    const std::string step(kIndent, ' ');
    std::string indent = hasItems ? lineIndent(dict.items.back().begin)
                         : top    ? ""
                                  : lineIndent(dict.begin) + step;
    std::string text, ends;
    for (std::size_t k = 0; k + 1 < path.size(); ++k, indent += step) {
        text += fmt::format("\n{0}{1}\n{0}{{", indent, path[k]);
        ends.insert(0, fmt::format("\n{}}}", indent));
    }
    text += "\n" + inLines(path.back(), value, indent) + ends;

    std::size_t at = top ? text_.size() : text_.rfind('\n', dict.valueEnd - 1);
    if (hasItems) at = dict.items.back().end;
    if (hasItems && endsLine(text_, at)) at = std::min(text_.find('\n', at), text_.size());
    const bool fileEnd = at == text_.size();
    if (fileEnd && (text_.empty() || text_.back() == '\n')) text.erase(0, 1);
    text_.insert(at, text + (fileEnd ? "\n" : ""));
}

void DictionarySource::remove(std::string_view path)
{
    const Path parts = partsOf(path);
    if (parts.empty()) throw FatalError("An entry to remove needs a keyword");
    std::vector<const Item*> found = occurrences(parts);
    if (found.empty()) failAbsent(parts);
    std::sort(found.begin(), found.end(),
              [](const Item* a, const Item* b) { return a->begin > b->begin; });
    for (const Item* item : found) {
        const std::size_t start = item->begin - lineIndent(item->begin).size();
        const bool beginsLine = start == 0 || text_[start - 1] == '\n';
        if (beginsLine && endsLine(text_, item->end)) {
            const std::size_t newline = text_.find('\n', item->end);
            text_.erase(start, newline == std::string::npos ? newline : newline + 1 - start);
        } else {
            const std::size_t next =
                std::min(text_.find_first_not_of(" \t", item->end), text_.size());
            text_.erase(item->begin, next - item->begin);
        }
    }
    parse();
}

void DictionarySource::write(const fs::path& file) const
{
    const fs::path target =
        fs::exists(file) ? fs::canonical(file) : file;  // through a link, the link stays
    const fs::path temporary = fmt::format("{}.tmp{}", target.string(), getpid());
    std::ofstream stream(temporary, std::ios::binary);
    stream << text_;
    stream.close();
    std::error_code error;
    if (stream && fs::exists(target))
        fs::permissions(temporary, fs::status(target).permissions(), error);
    if (stream && !error) fs::rename(temporary, target, error);
    if (!stream || error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw FatalIOError("cannot write file", target.string(), 0);
    }
}

}  // namespace isph
