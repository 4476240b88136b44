// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes cut by boxes: rows of particles fit such cells exactly.
#pragma once
#include "case/Shape.hpp"

#include <cstdint>

namespace isph {

/// Part of a box that belongs to one partner, or to none (-1).
struct BoxCell {
    OrientedBox box;
    int partner = -1;
};

/// `box` without the shapes in `taken`, divided among `partners` (the first that holds a point has
/// it). nullopt where one of them overlaps the box and is no box along the same axes.
std::optional<std::vector<BoxCell>> cutIntoCells(const OrientedBox& box, int dimension,
                                                 const std::vector<const Shape*>& taken,
                                                 const std::vector<const Shape*>& partners);

Real volumeOf(const OrientedBox& box, int dimension);
BoundingBox boundsOf(const OrientedBox& box);

/// `count` points that fill a box evenly: a lattice with half a spacing to each face, or, where no
/// lattice has that count, rows of nearly equal numbers whose widths follow their numbers.
std::vector<Point> fillBox(const OrientedBox& box, int dimension, std::int64_t count);

}  // namespace isph
