// SPDX-License-Identifier: GPL-3.0-or-later
// What a program tells its user: information on stdout, warnings in OpenFOAM's words.
#pragma once
#include <fmt/core.h>

#include <string>
#include <utility>

namespace isph {

void writeInfo(const std::string& text);
void writeWarning(const std::string& text);

/// One line of the log.
template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args)
{
    writeInfo(fmt::format(format, std::forward<Args>(args)...));
}

/// "--> FOAM Warning : ..." on stdout, where the log keeps it beside the step that caused it.
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args)
{
    writeWarning(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace isph
