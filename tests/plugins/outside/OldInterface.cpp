// SPDX-License-Identifier: GPL-3.0-or-later
// What a library built for an earlier interface does when it is loaded.
#include "porous/PorousModel.hpp"

namespace {
const bool added = [] {
    isph::PorousModel::table().add("oldDrag", {nullptr, nullptr}, isph::kAbi - 1);
    return true;
}();
}  // namespace
