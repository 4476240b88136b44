// SPDX-License-Identifier: GPL-3.0-or-later
// Contours split at their corners, to be followed at a depth.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

/// A smooth stretch of a contour. At depth delta its vertex i lies at vertex[i] + delta*inward[i],
/// which keeps straight edges parallel and joins neighbouring runs at their corners.
struct WallRun {
    /// Corner: shared with the next run; open: half a spacing to the end
    enum class End {
        corner,
        open
    };
    std::vector<Vec<2>> vertex, inward;
    std::vector<int> tag;  ///< of the edge from vertex i to i + 1
    End start = End::open, end = End::open;
    bool closed = false;  ///< one smooth loop
};

/// The runs of a chain in order; in a closed chain with corners run r ends where run r + 1 starts,
/// and the last where the first starts. Joints that turn by less than 30 degrees belong to a smooth
/// run; where the water's side is a wedge sharper than 80 degrees the run goes around its tip on an
/// arc.
std::vector<WallRun> wallRuns(const Chain& chain, const CaseGeometry& geometry);

/// A run at a depth: a polyline and its edges' tags.
struct OffsetLine {
    std::vector<Vec<2>> from, to;
    std::vector<int> tag;
    Real length = 0;

    OffsetLine(const WallRun& run, Real depth);
    /// The point at the arc length s, and the tag there.
    Vec<2> at(Real s, int& tagThere) const;
};

}  // namespace isph
