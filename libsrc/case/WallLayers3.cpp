// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WallLayers.hpp"

namespace isph {

WallParticles detail::layWalls3(const CaseGeometry&, Real)
{
    throw FatalError("createParticles cannot lay walls in three dimensions yet");
}

}  // namespace isph
