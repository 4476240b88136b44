// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "integrator/StepFields.hpp"

namespace isph {

/// div v_s of moving grains at a water particle, by the divergence that the water's own flux has:
///   sum_j V_j (v_s,j - v_s,i).L_i gradW_ij                                          [theory (9.5)]
/// over water and walls, which stand still: grains that drift along with the water take up no room
/// then, whatever the kernels are.
/// out   [1/s], 0 where no grain moves
template <int Dim>
Real solidsDivergence(const StepFields<Dim>& fields, Index i)
{
    const auto& flux = fields.soil.solidsFlux;
    if (flux.empty()) return 0;
    const Points<Dim>& points = fields.points;
    const Mat<Dim> L = fields.corrections.L[i];
    Real sum = 0;
    fields.pairs.forWater(i, [&](const auto& pair) {
        sum += points.volume[pair.j] * dot(flux[pair.j] - flux[i], L * pair.gradW());
    });
    fields.pairs.forWalls(i, [&](const auto& pair) {
        sum -= points.volume[pair.j] * dot(flux[i], L * pair.gradW());
    });
    return sum;
}

}  // namespace isph
