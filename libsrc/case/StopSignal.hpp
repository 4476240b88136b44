// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT and SIGTERM as a wish to stop: the run writes its state and ends with 130 or 143.
#pragma once

namespace isph {

/// From here on the first SIGINT or SIGTERM is remembered; a second one of its kind kills at once.
void catchStopSignals();

/// The signal that came, 0 if none.
int stopSignal();

}  // namespace isph
