// SPDX-License-Identifier: GPL-3.0-or-later
#include "Checklist.hpp"

#include "core/Error.hpp"
#include "core/Log.hpp"

namespace isph {

namespace {

std::string indented(const std::string& text)
{
    std::string result = "        ";
    for (char c : text) {
        result += c;
        if (c == '\n') result += "        ";
    }
    return result;
}

}  // namespace

bool Checklist::check(const std::string& what, const std::function<std::string()>& work)
{
    std::string place;
    try {
        const std::string found = work();
        info("    {:<34} ok{}{}", what, found.empty() ? "" : "  ", found);
        return true;
    } catch (const FatalIOError& error) {
        place = error.line() > 0 ? fmt::format("\nfile: {} at line {}.", error.file(), error.line())
                                 : fmt::format("\nfile: {}.", error.file());
        info("    {:<34} FAILED\n{}", what, indented(error.what() + place));
    } catch (const std::exception& error) {
        info("    {:<34} FAILED\n{}", what, indented(error.what()));
    }
    ++failures_;
    return false;
}

void Checklist::note(const std::string& text)
{
    info("    Note: {}", text);
}

}  // namespace isph
