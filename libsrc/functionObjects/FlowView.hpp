// SPDX-License-Identifier: GPL-3.0-or-later
// What function objects see of the flow: plain arrays, made only in steps in which one of them runs.
#pragma once
#include "core/Types.hpp"
#include "dictionary/Dictionary.hpp"
#include "kernels/Kernel.hpp"

#include <map>
#include <string>
#include <vector>

namespace isph {

struct FlowView {
    int dimension = 2;
    Real time = 0;
    Real spacing = 0;              ///< d0 [m]
    Real density = 0;              ///< rho0 [kg/m3]
    Vector3 gravity{};             ///< g + body force [m/s2]
    const Kernel* kernel = nullptr;
    Real smoothingRatio = 0;       ///< h/d0

    // Water particles, one entry each. 2-D: z = 0.
    std::vector<Vector3> position;
    std::vector<Real> porosity;                          ///< 1 in clear water
    std::map<std::string, std::vector<Real>> scalars;    ///< "p" [Pa], "porosity", ...
    std::map<std::string, std::vector<Vector3>> vectors; ///< "U" pore velocity, "UDarcy" [m/s], ...

    // Wall particles: their volume closes kernel sums beside walls.
    std::vector<Vector3> wallPosition;
    std::vector<Real> wallVolume;

    /// h of a particle, h0/eps^(1/D).
    Real smoothingLength(std::size_t i) const;
    /// m/(eps rho0), the volume a particle occupies with its share of soil.
    Real occupiedVolume(std::size_t i) const;
};

}  // namespace isph
