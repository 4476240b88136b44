// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"

namespace isph {

/// What a full lattice has of the sums (2.7).
struct LatticeSums {
    Real filling = 1;   ///< n_0
    Real lambda = 2;    ///< lambda_0
};

/// delta_i/eps_i, by how much more than a lattice the water around a particle fills its space:
///                                                                                  [theory (5.3)]
///   zeta (n_i - n_0) + (1 - zeta) <n - n_0>_i - n_0/3 <n/n_0 - lambda/lambda_0>_i
/// Means are weighted by V_j W_ij. The first is taken over inner particles in soil and beside it;
/// elsewhere zeta = 1. The second is taken deep in soil alone, where packings are disordered and
/// nothing is cut.
/// in    ownShare zeta, of what the particle sees itself                            [theory (5.12)]
/// out   surplus of water, overwritten
template <int Dim, class Medium>
void fillingSurplus(const StepFields<Dim>& fields, const Medium& medium,
                    const LatticeSums& lattice, Real ownShare, LargeArray<Real>& surplus);

}  // namespace isph
