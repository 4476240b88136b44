// SPDX-License-Identifier: GPL-3.0-or-later
// Places for the wall particles of one wall in three dimensions.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

struct WallCandidates {
    std::vector<Point> x;
    std::vector<Real> volume;
    bool exact = false;  ///< volumes are cells of a lattice
};

/// A box: cells of its own lattice, in `layers` around a tank or in the whole of a solid.
WallCandidates boxCandidates(const Wall& wall, const CaseGeometry& geometry, int layers);

/// Any other wall: each shell of thickness d0 gets as many particles as lattice points lie in it,
/// on the surface at its middle depth, spread evenly by repulsion along it.
WallCandidates shellCandidates(const Wall& wall, const CaseGeometry& geometry, int layers);

}  // namespace isph
