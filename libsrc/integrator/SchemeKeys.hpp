// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of system/isphSchemes, and the scheme that a case's dictionaries set.
#pragma once
#include "dictionary/Schema.hpp"
#include "integrator/Scheme.hpp"

namespace isph {

enum class Projection { dragImplicit, paper };
enum class PaperDrag { explicitly, semiImplicit };

Schema schemeKeys();          ///< system/isphSchemes
Schema stabilisationKeys();   ///< its stabilisation
Schema shiftingKeys();        ///< its shifting
Schema dissipationKeys();     ///< its dissipation
Schema paperKeys();           ///< its paperCoeffs
Schema solutionKeys();        ///< system/isphSolution

/// Checks system/isphSchemes and everything below it. Throws FatalIOError.
void checkSchemes(const Dictionary& schemes);

Projection readProjection(const Dictionary& schemes);
PaperDrag readPaperDrag(const Dictionary& schemes);   ///< of projection paper

/// What the scheme is made of besides isphSchemes.
struct WaterProperties {
    Real spacing = 0;        ///< d0 [m]
    Real density = 1000;     ///< [kg/m3]
    Real viscosity = 1e-6;   ///< [m2/s]
    Vector3 force{};         ///< g + body force [m/s2]
    Real depth = 0;  ///< extent of the water along g at the start, without gravity the largest [m]
    Real speed = 0;          ///< largest at the start [m/s]
};

/// The scheme of a case. relaxationTime auto is 0.2 sqrt(H/|g|) with the water's depth H at the
/// start, and 10 L/U without gravity (L the largest extent, U the largest speed at the start).
///                                                                                   [theory (5.5)]
template <int Dim>
Scheme<Dim> readScheme(const Dictionary& schemes, const WaterProperties& water);

extern template Scheme<2> readScheme<2>(const Dictionary&, const WaterProperties&);
extern template Scheme<3> readScheme<3>(const Dictionary&, const WaterProperties&);

}  // namespace isph
