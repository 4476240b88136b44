// SPDX-License-Identifier: GPL-3.0-or-later
// The particles of a case as structures of arrays: water that moves, walls and soil that it meets.
#pragma once
#include "core/Vec.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace isph {

/// Water particles, each of mass rho0 d0^D. What a restart needs is exactly what stands here.
template <int Dim>
struct Water {
    std::vector<Vec<Dim>> x;              ///< position [m]
    std::vector<Vec<Dim>> u;              ///< pore velocity at the end of the last step [m/s]
    std::vector<Vec<Dim>> uOld;           ///< pore velocity one step before, for BDF2
    std::vector<Real> p;                  ///< pressure of the pressure equation [Pa]
    /// C, (grad p)/rho - g as the last step felt it [m/s2]; from its predictor
    std::vector<Vec<Dim>> forceGradient;
                        ///  to its corrector, as this one will
                        ///                                  [theory (6.4), (5.4)]
    /// The mean of those before, for its value at the new time   (5.4)
    std::vector<Vec<Dim>> forceGradientOld;
    /// At which u was found, v = eps u; empty where it is not known: without soil
    std::vector<Real> porosity;
    std::vector<Real> porosityOld;        ///< at which uOld was found
    std::vector<std::int64_t> id;

    std::size_t size() const { return x.size(); }
    void resize(std::size_t n);
    /// Reorders every array: entry k becomes what order[k] was.
    void reorder(const std::vector<Index>& order);
};

/// Fixed particles behind the wall surfaces.
template <int Dim>
struct Walls {
    std::vector<Vec<Dim>> x;
    std::vector<Vec<Dim>> normal;         ///< unit, from the nearest wall surface into the water
    std::vector<Real> depth;              ///< distance beneath that surface [m]
    std::vector<Real> volume;             ///< [m^D]
    std::vector<std::int64_t> wall;       ///< index into names
    std::vector<std::int64_t> id;
    std::vector<std::string> names;

    std::size_t size() const { return x.size(); }
};

/// Particles of the soil skeleton.
template <int Dim>
struct Soil {
    std::vector<Vec<Dim>> x;
    std::vector<Vec<Dim>> u;              ///< velocity of released particles, zero in the bed [m/s]
    std::vector<Real> solidVolume;        ///< volume of the grains alone [m^D]
    std::vector<std::int64_t> zone;       ///< index into names
    std::vector<std::int64_t> released;   ///< 1 once eroded
    std::vector<std::int64_t> id;
    std::vector<std::string> names;

    std::size_t size() const { return x.size(); }
};

extern template struct Water<2>;
extern template struct Water<3>;

}  // namespace isph
