// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a step, and what must hold after it.                            [theory (3.8)-(3.10)]
#pragma once
#include "integrator/Scheme.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// |u| over the local spacing d0/eps^(1/D), pore velocity throughout [1/s]; times dt: Courant
/// numbers.
struct CourantNumber {
    Real mean = 0, max = 0;
};
template <int Dim>
CourantNumber courantRate(const Scheme<Dim>& scheme, const Water<Dim>& water,
                          Span<const Real> porosity);

/// The largest step within all limits [s]:
///   maxCo/courant,  maxDeltaT,  0.25 sqrt(h0/|f|),  0.125 h0^2/(nu + nu_T),  1.2 times the last;
/// the first step (dtOld = 0) is at most `first`. Throws FatalError where the step collapses: where
/// maxCo/courant is below 1e-5 of the other limits, of `first` and of what the flow of the start
/// allows (courantAtStart, 0: water at rest). The growth is not among them: it follows the step
/// down.
template <int Dim>
Real stepSize(const Scheme<Dim>& scheme, Real maxCo, Real maxDeltaT, Real first, Real dtOld,
              Real courant, Span<const Real> eddyViscosity, Real courantAtStart = 0);

/// Of a step whose size is given: throws FatalError that names the limit where water would move
/// more than a spacing, or where the explicit friction is unstable: BDF2 with extrapolated friction
/// bears dt nu e = 4/3, and the largest eigenvalue e of the Laplacian on a lattice is 8.4/h0^2.
template <int Dim>
void requireStableStep(const Scheme<Dim>& scheme, Real dt, Real courant,
                       Span<const Real> eddyViscosity);

/// Throws FatalError with place and time where a position, velocity or pressure is not a number.
template <int Dim>
void requireFinite(const Water<Dim>& water, Real time, Real dt);

}  // namespace isph
