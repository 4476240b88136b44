// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "particles/Points.hpp"
#include "pressure/SymmetricMatrix.hpp"

namespace isph {

/// Row r stands where particle[r] does; its spacing is V^(1/Dim), which is d0/eps^(1/Dim).
template <int Dim>
void placeRows(const Points<Dim>& points, Span<const Index> particle, RowPlaces& places);

}  // namespace isph
