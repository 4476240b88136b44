// SPDX-License-Identifier: GPL-3.0-or-later
// Particles of a scene to and from the files of a time folder.
#pragma once
#include "integrator/ProjectionStep.hpp"
#include "output/ParticleArrays.hpp"

#include <map>
#include <string>

namespace isph {

/// Fills the particles of a scene from a time folder's files, as ParticleArrays reads them.
template <int Dim>
void takeParticles(const std::map<std::string, ParticleFile>& files, Scene<Dim>& scene);

/// Throws FatalIOError that names both where two water particles of a start stand at the same
/// place, within a tenth of a spacing: pair forces vanish with the distance, and they would stay
/// together as one.
template <int Dim>
void requireApart(const Scene<Dim>& scene, const std::filesystem::path& file);

/// Particles in the order of cells of a search within `reach`, as neighbours in space are to be
/// neighbours in memory. Done at the start, where the state is written, and in steps of fixed
/// numbers, so that a restart has the same order.
template <int Dim>
void sortParticles(Scene<Dim>& scene, Real reach);

/// The water with everything that a restart needs, bit for bit; and what users look at: p,
/// porosity, UDarcy in scenes with soil.
template <int Dim>
ParticleFile waterFile(const Scene<Dim>& scene, const StepFields<Dim>& fields);

/// Pressure as users know it: that of the equation. The one of projection paper is zero at the
/// centres of surface particles, half a spacing below the surface: rho |f| d0/2 is added where the
/// pressure carries the water, less where it falls.                                  [theory (6.7)]
template <int Dim>
std::vector<Real> pressure(const Scene<Dim>& scene, const StepFields<Dim>& fields);

}  // namespace isph
