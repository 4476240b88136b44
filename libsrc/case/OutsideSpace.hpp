// SPDX-License-Identifier: GPL-3.0-or-later
// The space around particles that is not theirs to fill, as points with volumes.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

struct OutsideSpace {
    std::vector<Point> x;
    std::vector<Real> volume;  ///< [m^D]
};

/// Cells of d0 within `reach` of the points that lie outside as a whole, so that a lattice goes on
/// in them, and parts of others by halves. outside: positive there.
OutsideSpace outsideSpace(const CaseGeometry& geometry, const std::vector<Point>& points,
                          Real reach, const std::function<Real(const Point&)>& outside);

}  // namespace isph
