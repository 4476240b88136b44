// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"
#include "particles/Particles.hpp"

namespace isph {

/// What particles bring to the new time: v of its time derivative (3.3) and v extrapolated to it.
/// Through a face of rigid soil water carries its Darcy velocity, which is continuous there; along
/// it and at the free surface its pore
/// velocity:                                                                        [theory (3.12)]
///   v = eps^(n+1) sum_k c_k u^k + n n.sum_k c_k (eps^k - eps^(n+1)) u^k
/// in    pore velocities and the porosities at which they were found; soil, roles and points of
///       the new time
/// out   fields.v of water; fields.face.v, fields.face.carriesDarcy of water and images
template <int Dim>
void carryThroughFaces(const Water<Dim>& water, const StepWeights& weights,
                       StepFields<Dim>& fields);

}  // namespace isph
