// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "operators/Corrections.hpp"

namespace isph {

/// |S| = sqrt(2 S:S) with S the symmetric part of grad u, from water partners.       [theory (8.1)]
/// in  u of water and images [m/s];  out  strainRate of the water particles [1/s], resized.
template <int Dim>
void strainRate(const Points<Dim>& points, const PairList<Dim>& pairs,
                const Corrections<Dim>& corrections, Span<const Vec<Dim>> u,
                std::vector<Real>& rate);

}  // namespace isph
