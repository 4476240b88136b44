// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points of a closed surface of triangles.
#pragma once
#include "case/Shape.hpp"

namespace isph {

/// A tree of bounding boxes over triangles. Inside and outside are told by the normal of the
/// feature that is nearest: of a face, the sum of two faces at an edge, weighted by angles at a
/// corner. source  Baerentzen and Aanaes (2005), IEEE Trans. Vis. Comput. Graph. 11(3), 243-253
class TriangleTree {
public:
    using Triangle = std::array<Index, 3>;

    /// Triangles of a closed surface, all with their corners in the sense that points out of it.
    TriangleTree(std::vector<Point> corners, std::vector<Triangle> triangles);

    struct Foot {
        Point point, normal;  ///< the normal of the feature, not of unit length
        Real distance = std::numeric_limits<Real>::max();  ///< negative inside
    };
    Foot nearest(const Point& x) const;

    const BoundingBox& bounds() const { return nodes_.front().box; }
    Real volume() const;  ///< by the divergence theorem

private:
    struct Node {
        BoundingBox box;
        Index first = 0, count = 0;  ///< triangles of a leaf
        Index right = -1;            ///< the left child stands next; -1: a leaf
    };
    void makeNormals();
    Index build(Index first, Index count);
    void search(Index node, const Point& x, Foot& best) const;
    void tryTriangle(Index t, const Point& x, Foot& best) const;

    std::vector<Point> corners_;
    std::vector<Triangle> triangles_;
    std::vector<Point> faceNormal_, cornerNormal_;
    std::vector<std::array<Point, 3>> edgeNormal_;  ///< of the edges opposite to the corners
    std::vector<Node> nodes_;
};

Point crossProduct(const Point& a, const Point& b);

}  // namespace isph
