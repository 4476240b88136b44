// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dimensions.hpp"

#include <fmt/core.h>

namespace isph {

std::string toString(const Dimensions& dimensions)
{
    std::string text = "[";
    for (std::size_t k = 0; k < dimensions.exponent.size(); ++k)
        text += fmt::format("{}{:g}", k == 0 ? "" : " ", dimensions.exponent[k]);
    return text + "]";
}

}  // namespace isph
