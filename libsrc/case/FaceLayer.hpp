// SPDX-License-Identifier: GPL-3.0-or-later
// The first layer of particles beneath the faces that what is laid turns to the outside.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

/// Unit vector along which a distance grows at x; zero on the ridge between two faces.
Point steepest(const std::function<Real(const Point&)>& distance, const Point& x,
               const CaseGeometry& geometry);

/// x moved along `steepest` to where the distance is `level`, also beside the corners of faces.
Point movedToLevel(const std::function<Real(const Point&)>& distance, Point x, Real level,
                   const CaseGeometry& geometry);

/// Points at half a spacing beneath the outside faces (walls, free surfaces) of one part. A lattice
/// at an angle to a face would begin with stairs there.
class FaceLayer {
public:
    using Distance = std::function<Real(const Point&)>;
    /// outside: distance to all that is laid together, positive outside; own: to the part.
    FaceLayer(const CaseGeometry& geometry, Distance outside, Distance own, Real spacing);

    /// True if x is less than a spacing beneath a face that has nothing beyond it: a seam between
    /// two regions and a periodic face are none.
    bool holds(const Point& x) const;
    /// x moved along the normal to `depth` spacings beneath the face.
    Point atDepth(const Point& x, Real depth) const;
    /// Lays lattice points that the layer holds half a spacing beneath the face and spreads them
    /// evenly along it by repulsion. Where the lattice fits the face they stay. Not 0: was moved.
    std::vector<char> laid(std::vector<Point>& x) const;

private:
    std::vector<char> misfits(const std::vector<Point>& x) const;
    Real step(std::vector<Point>& x, const std::vector<char>& moves) const;

    const CaseGeometry& g_;
    Distance outside_, own_;
    Real spacing_;
};

}  // namespace isph
