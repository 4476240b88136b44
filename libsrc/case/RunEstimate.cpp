// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/RunEstimate.hpp"

#include <cmath>
#include <numbers>

namespace isph {

namespace {

// Measured on the dam break through crushed rock (4384 water particles, 28 neighbours, PCG) and a
// tank in three dimensions (113 neighbours), processor of 2020.
constexpr Real programBytes = 40e6, waterBytes = 800, pairBytes = 65, wallBytes = 250,
               soilBytes = 250;
constexpr Real pairsPerSecond = 3e6;  // pairs of a step that one thread gets through in a second

}  // namespace

Real neighbourNumber(Real radius, Real spacing, int dimension)
{
    const Real r = radius / spacing;
    return dimension == 2 ? std::numbers::pi * sqr(r) : 4 * std::numbers::pi / 3 * cube(r);
}

Real runMemory(const ParticleNumbers& n, Real neighbours)
{
    return programBytes + static_cast<Real>(n.water) * (waterBytes + pairBytes * neighbours) +
           static_cast<Real>(n.walls) * wallBytes + static_cast<Real>(n.soil) * soilBytes;
}

Real stepTime(const ParticleNumbers& n, Real neighbours, int threads)
{
    return static_cast<Real>(n.water) * neighbours / (pairsPerSecond * threads);
}

}  // namespace isph
