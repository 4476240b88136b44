// SPDX-License-Identifier: GPL-3.0-or-later
// What function objects see of the flow: plain arrays, made only in steps in which one of them
// runs.
#pragma once
#include "core/Types.hpp"
#include "dictionary/Dictionary.hpp"
#include "kernels/Kernel.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace isph {

struct FlowView {
    int dimension = 2;
    Real time = 0;
    Real spacing = 0;   ///< d0 [m]
    Real density = 0;   ///< rho0 [kg/m3]
    Vector3 gravity{};  ///< g + body force [m/s2]
    const Kernel* kernel = nullptr;
    Real smoothingRatio = 0;  ///< h/d0

    // Water particles, one entry each. 2-D: z = 0.
    std::vector<Vector3> position;
    std::vector<std::int64_t> id;  ///< of a particle, the same in all steps
    std::vector<Real> porosity;  ///< 1 in clear water
    /// That at any place, from the soil itself and with sharp faces; empty without soil.
    std::function<Real(const Vector3&)> porosityAt;
    std::vector<Index> zone;                        ///< of soil; empty without soil
    std::function<Index(const Vector3&)> zoneAt;    ///< at any place; empty without soil
    std::map<std::string, std::vector<Real>> scalars;  ///< "p" [Pa], "porosity", ...
    /// "U" pore velocity, "UDarcy" [m/s], ...
    std::map<std::string, std::vector<Vector3>> vectors;

    // Wall particles: their volume closes kernel sums beside walls.
    std::vector<Vector3> wallPosition;
    std::vector<Real> wallVolume;

    // Directions in which the flow repeats itself, with the ends of one period. The particles above
    // are those of one period; whoever sums over neighbours makes the images.
    std::array<bool, 3> periodic{};
    Vector3 domainMin{}, domainMax{};

    /// m = rho0 d0^D [kg], in 2-D per metre of width.
    Real particleMass() const;
    /// h of a particle [m], h0/eps^(1/D).
    Real smoothingLength(std::size_t i) const;
    /// m/(eps rho0) [m^D], the volume a particle occupies with its share of soil.
    Real occupiedVolume(std::size_t i) const;
    /// A field by name; throws FatalError that lists the fields of this kind.
    const std::vector<Real>& scalar(const std::string& name) const;
    const std::vector<Vector3>& vector(const std::string& name) const;
};

}  // namespace isph
