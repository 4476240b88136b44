// SPDX-License-Identifier: GPL-3.0-or-later
// Regions divided by what overlaps them: water by zones of soil, each by regions listed before it.
#pragma once
#include "case/CaseGeometry.hpp"

#include <cstdint>

namespace isph {

/// The part of a region that one partner (a soil region) overlaps, or none does.
struct RegionPart {
    int partner = -1;                ///< -1: none
    Real volume = 0;                 ///< [m^D]
    std::vector<OrientedBox> boxes;  ///< the part as boxes; empty: it is no sum of boxes
    std::function<Real(const Point&)> distance;  ///< negative inside
    BoundingBox bounds;
    std::optional<OrientedBox> frame;  ///< a box whose faces bound it, for the lattice

    bool isBoxes() const { return !boxes.empty(); }
};

/// `shape` without `taken`, divided among `partners` (the first that holds a point has it), within
/// the domain where the shape is not bounded. Volumes are exact for boxes, for 2-D shapes (arcs by
/// chords of equal area) and for shapes alone; else by quadrature. Parts of no volume are left out.
std::vector<RegionPart> partsOf(const CaseGeometry& geometry, const Shape& shape,
                                const std::vector<const Shape*>& taken,
                                const std::vector<const Shape*>& partners);

/// Points of a part and which of them left their place in the lattice for the layer beneath a face.
struct PartPoints {
    std::vector<Point> x;
    std::vector<char> snapped;
};

/// `count` points in the part, even in box parts (see fillBox). In others the deepest of a lattice
/// at `spacing`; with `outside`, the distance to all that is laid together, positive outside, those
/// less than a spacing beneath an outside face stand in a layer half a spacing beneath it
/// (FaceLayer).
PartPoints pointsIn(const RegionPart& part, const CaseGeometry& geometry, std::int64_t count,
                    Real spacing, const std::function<Real(const Point&)>& outside = nullptr);

}  // namespace isph
