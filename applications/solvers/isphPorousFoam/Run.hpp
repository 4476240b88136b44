// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "ReadScene.hpp"

namespace isph {

struct RunOptions {
    bool functionObjects = true;
    bool dryRun = false;   ///< read and check everything, say what is active, and end
};

/// Runs the case to its end; returns the exit code (0, or 130/143 after a signal).
template <int Dim>
int runCase(const CaseFiles& files, const Dictionary& controlDict, const RunOptions& options);

}  // namespace isph
