// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/Kernel.hpp"

namespace isph {

Kernel::Table& Kernel::table()
{
    static Table one;
    return one;
}

std::unique_ptr<Kernel> Kernel::select(const Dictionary& dict, std::string_view key)
{
    return table().select(dict, key);
}

}  // namespace isph
