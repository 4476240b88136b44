// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Parallel.hpp"

#include <omp.h>

namespace isph {

int threadCount() { return omp_get_max_threads(); }
void setThreadCount(int threads) { omp_set_num_threads(threads); }

}  // namespace isph
