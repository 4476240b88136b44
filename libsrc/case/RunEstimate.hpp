// SPDX-License-Identifier: GPL-3.0-or-later
// What a run will need, from its numbers of particles: for reports, good to a factor of two.
#pragma once
#include "core/Types.hpp"

#include <cstddef>

namespace isph {

struct ParticleNumbers {
    std::size_t water = 0, walls = 0, soil = 0;
};

/// Particles within a support of `radius` in clear water.
Real neighbourNumber(Real radius, Real spacing, int dimension);

/// Memory of a run [bytes]: fields, pairs and matrix of the water, walls, soil, and the program
/// itself.
Real runMemory(const ParticleNumbers& numbers, Real neighbours);

/// Wall time of a step [s] with so many threads.
Real stepTime(const ParticleNumbers& numbers, Real neighbours, int threads);

}  // namespace isph
