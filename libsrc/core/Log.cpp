// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Log.hpp"

#include <cstdio>

namespace isph {

void writeInfo(const std::string& text)
{
    std::fputs(text.c_str(), stdout);
    std::fputc('\n', stdout);
}

void writeWarning(const std::string& text) { writeInfo("--> FOAM Warning : " + text); }

}  // namespace isph
