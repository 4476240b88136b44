// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "ReadScene.hpp"

namespace isph {

/// -postProcess: the function objects of controlDict on time folders that were written, in order,
/// each of them at each time, whatever their controls say. Nothing is solved. Returns the exit
/// code.
/// times  as selectTimes reads them
template <int Dim>
int postProcess(const CaseFiles& files, const Dictionary& controlDict, const std::string& times);

}  // namespace isph
