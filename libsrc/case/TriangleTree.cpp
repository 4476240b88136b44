// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TriangleTree.hpp"

#include <algorithm>
#include <map>

namespace isph {

namespace {

constexpr Index leafSize = 4;

/// Barycentric coordinates of the point of a triangle nearest to x: zeros tell the feature.
/// source  Ericson (2005), Real-Time Collision Detection, 5.1.5
std::array<Real, 3> nearestWeights(const Point& x, const Point& a, const Point& b, const Point& c)
{
    const Point ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
    const Real d1 = dot(ab, ax), d2 = dot(ac, ax);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const Real d3 = dot(ab, bx), d4 = dot(ac, bx);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const Real wc = d1 * d4 - d3 * d2;
    if (wc <= 0 && d1 >= 0 && d3 <= 0) {
        const Real t = d1 / (d1 - d3);
        return {1 - t, t, 0};
    }
    const Real d5 = dot(ab, cx), d6 = dot(ac, cx);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const Real wb = d5 * d2 - d1 * d6;
    if (wb <= 0 && d2 >= 0 && d6 <= 0) {
        const Real t = d2 / (d2 - d6);
        return {1 - t, 0, t};
    }
    const Real wa = d3 * d6 - d5 * d4;
    if (wa <= 0 && d4 >= d3 && d5 >= d6) {
        const Real t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const Real sum = wa + wb + wc;
    return {wa / sum, wb / sum, wc / sum};
}

Real distanceTo(const BoundingBox& box, const Point& x)
{
    Point outside;
    for (int d = 0; d < 3; ++d) outside[d] = std::max({box.min[d] - x[d], x[d] - box.max[d], 0.0});
    return norm(outside);
}

}  // namespace

Point crossProduct(const Point& a, const Point& b)
{
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

TriangleTree::TriangleTree(std::vector<Point> corners, std::vector<Triangle> triangles)
    : corners_(std::move(corners)), triangles_(std::move(triangles))
{
    build(0, static_cast<Index>(triangles_.size()));
    makeNormals();
}

void TriangleTree::makeNormals()
{
    cornerNormal_.resize(corners_.size());
    std::map<std::pair<Index, Index>, Point> edges;
    const auto edgeOf = [](const Triangle& t, int k) {  // opposite to corner k
        const Index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        return std::make_pair(std::min(a, b), std::max(a, b));
    };
    for (const Triangle& t : triangles_) {
        const Point &a = corners_[t[0]], &b = corners_[t[1]], &c = corners_[t[2]];
        const Point n = unit(crossProduct(b - a, c - a));
        faceNormal_.push_back(n);
        for (int k = 0; k < 3; ++k) {
            edges[edgeOf(t, k)] += n;
            const Point e = unit(corners_[t[(k + 1) % 3]] - corners_[t[k]]);
            const Point f = unit(corners_[t[(k + 2) % 3]] - corners_[t[k]]);
            cornerNormal_[t[k]] += std::acos(std::clamp(dot(e, f), -1.0, 1.0)) * n;
        }
    }
    for (const Triangle& t : triangles_)
        edgeNormal_.push_back({edges[edgeOf(t, 0)], edges[edgeOf(t, 1)], edges[edgeOf(t, 2)]});
}

/// Halves the triangles at the median along the longest extent of their centres.
Index TriangleTree::build(Index first, Index count)
{
    const auto here = static_cast<Index>(nodes_.size());
    nodes_.emplace_back();
    BoundingBox box, centres;
    const auto centre = [&](const Triangle& t) {
        return (corners_[t[0]] + corners_[t[1]] + corners_[t[2]]) / 3;
    };
    for (Index i = first; i < first + count; ++i) {
        for (Index corner : triangles_[i]) box.include(corners_[corner]);
        centres.include(centre(triangles_[i]));
    }
    nodes_[here] = {box, first, count, -1};
    if (count <= leafSize) return here;
    int axis = 0;
    for (int d = 1; d < 3; ++d)
        if (centres.size()[d] > centres.size()[axis]) axis = d;
    const auto begin = triangles_.begin() + first;
    std::nth_element(
        begin, begin + count / 2, begin + count,
        [&](const Triangle& a, const Triangle& b) { return centre(a)[axis] < centre(b)[axis]; });
    build(first, count / 2);
    nodes_[here].right = build(first + count / 2, count - count / 2);
    return here;
}

void TriangleTree::tryTriangle(Index t, const Point& x, Foot& best) const
{
    const Triangle& corner = triangles_[t];
    const Point &a = corners_[corner[0]], &b = corners_[corner[1]], &c = corners_[corner[2]];
    const std::array<Real, 3> w = nearestWeights(x, a, b, c);
    const Point p = w[0] * a + w[1] * b + w[2] * c;
    const Real distance = norm(x - p);
    if (distance >= best.distance) return;
    best.point = p;
    best.distance = distance;
    best.normal = faceNormal_[t];
    for (int k = 0; k < 3; ++k) {
        if (w[k] == 0) best.normal = edgeNormal_[t][k];
        if (w[k] == 1) {
            best.normal = cornerNormal_[corner[k]];
            return;
        }
    }
}

void TriangleTree::search(Index node, const Point& x, Foot& best) const
{
    const Node& n = nodes_[node];
    if (n.right < 0) {
        for (Index t = n.first; t < n.first + n.count; ++t) tryTriangle(t, x, best);
        return;
    }
    Index nearer = node + 1, farther = n.right;
    Real near = distanceTo(nodes_[nearer].box, x), far = distanceTo(nodes_[farther].box, x);
    if (far < near) std::swap(nearer, farther), std::swap(near, far);
    if (near < best.distance) search(nearer, x, best);
    if (far < best.distance) search(farther, x, best);
}

TriangleTree::Foot TriangleTree::nearest(const Point& x) const
{
    Foot best;
    search(0, x, best);
    if (dot(x - best.point, best.normal) < 0) best.distance = -best.distance;
    return best;
}

Real TriangleTree::volume() const
{
    Real v = 0;
    for (const Triangle& t : triangles_)
        v += dot(corners_[t[0]], crossProduct(corners_[t[1]], corners_[t[2]])) / 6;
    return v;
}

}  // namespace isph
