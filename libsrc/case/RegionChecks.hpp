// SPDX-License-Identifier: GPL-3.0-or-later
// What regions of water and soil must not do.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

/// errors  FatalIOError at the region: the shape or one of its particles lies outside the domain or
/// in
///         the body of a wall (names the wall, the place and how deep)
void checkInside(const CaseGeometry& geometry, const std::vector<Point>& points,
                 const std::string& kind, const std::string& name, const Shape& shape,
                 const Location& at);

}  // namespace isph
