// SPDX-License-Identifier: GPL-3.0-or-later
// Runs variants, some at a time, and shows how far they are.
#pragma once
#include "VariantCase.hpp"

namespace isph {

/// Runs those that are not finished, `parallel` at a time, all of them with `again`. Shows a bar on
/// a terminal, else a line for each that ends. False after a stop signal. Throws what a run throws.
bool runVariants(const std::vector<VariantCase>& all, int parallel, bool again);

}  // namespace isph
