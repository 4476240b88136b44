// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WallLayers.hpp"

namespace isph {

int layerCount(Real spacing, Real thickness)
{
    return static_cast<int>(std::ceil(thickness / spacing - 1e-6));
}

WallParticles layWalls(const CaseGeometry& geometry, Real thickness)
{
    if (geometry.walls.empty()) return {};
    return geometry.dimension == 2 ? detail::layWalls2(geometry, thickness)
                                   : detail::layWalls3(geometry, thickness);
}

}  // namespace isph
