// SPDX-License-Identifier: GPL-3.0-or-later
// Particles of a scene to and from the files of a time folder.
#pragma once
#include "integrator/ProjectionStep.hpp"
#include "output/VtpFile.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace isph {

/// Fills the particles of a scene from a time folder's files. Restart fields that a fresh start lacks
/// begin at zero (the history of U at U). Throws FatalIOError for arrays that are missing.
template <int Dim>
void takeParticles(const std::map<std::string, ParticleFile>& files,
                   const std::filesystem::path& folder, Scene<Dim>& scene);

/// The water with everything that a restart needs, bit for bit: U, UOld, pEquation, forceGradient, id;
/// and what users look at: p, porosity, UDarcy in scenes with soil.
template <int Dim>
ParticleFile waterFile(const Scene<Dim>& scene, const StepFields<Dim>& fields);
template <int Dim>
ParticleFile wallFile(const Scene<Dim>& scene);
template <int Dim>
ParticleFile soilFile(const Scene<Dim>& scene);

/// Pressure as users know it: that of the equation is zero at the centres of surface particles, half a
/// spacing below the surface; rho |f| d0/2 is added where the pressure carries the water, less where
/// it falls.                                                                          [theory (6.7)]
template <int Dim>
std::vector<Real> pressure(const Scene<Dim>& scene);

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
