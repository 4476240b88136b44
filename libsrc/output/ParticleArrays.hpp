// SPDX-License-Identifier: GPL-3.0-or-later
// Water, walls and soil to and from particle files. What a file holds is declared once, for reading
// and for writing.
#pragma once
#include "core/Parallel.hpp"
#include "output/VtpFile.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// Particles of a file. Fields that only a run writes may be missing: the history of U is then U,
/// the others are zero. errors  FatalIOError: a field is missing or not finite, a wall or zone has
/// no name, a volume is none,
///         points of a 2-D case have a z
template <int Dim>
Water<Dim> waterOf(const ParticleFile& file);
template <int Dim>
Walls<Dim> wallsOf(const ParticleFile& file);
template <int Dim>
Soil<Dim> soilOf(const ParticleFile& file);

/// Everything that a restart needs, bit for bit, with spacing [m] and dimension.
template <int Dim>
ParticleFile fileOf(const Water<Dim>& water, Real spacing);
template <int Dim>
ParticleFile fileOf(const Walls<Dim>& walls, Real spacing);
template <int Dim>
ParticleFile fileOf(const Soil<Dim>& soil, Real spacing);

/// errors  FatalIOError: the file was made with another spacing or dimension than particlesDict has
void requireSameCase(const ParticleFile& file, Real spacing, int dimension);

template <int Dim>
Vector3 toVector3(const Vec<Dim>& a)
{
    Vector3 r{};
    for (int d = 0; d < Dim; ++d) r[static_cast<std::size_t>(d)] = a[d];
    return r;
}

template <int Dim>
std::vector<Vector3> toVectors3(const std::vector<Vec<Dim>>& field)
{
    std::vector<Vector3> r(field.size());
    parallelFor(field.size(), [&](Index i) { r[i] = toVector3(field[i]); });
    return r;
}

}  // namespace isph
