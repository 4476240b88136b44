// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries of 2-D shapes as directed edges: cut where they cross, kept where they bound, chained.
#pragma once
#include "core/Vec.hpp"

#include <functional>
#include <vector>

namespace isph {

/// A straight piece of a boundary; the interior is on its left, the outside on its right.
struct Edge {
    Vec<2> a, b;
    int tag = 0;          ///< whose edge it is (a wall's index, a box's side)
    bool curved = false;  ///< a chord of an arc

    Vec<2> along() const { return b - a; }
    Real length() const { return norm(b - a); }
    /// Unit normal to the right: out of the shape.
    Vec<2> normal() const
    {
        const Vec<2> t = unit(b - a);
        return {{t[1], -t[0]}};
    }
};

/// Edges in a row, each beginning where the one before ends.
struct Chain {
    std::vector<Edge> edges;
    bool closed = false;
};

/// Closed loop through the points (the last joins the first).
std::vector<Edge> loopOf(const std::vector<Vec<2>>& points, int tag = 0, bool curved = false);

/// The circle as chords, counter-clockwise, that deviate by at most `tolerance`; the polygon has
/// the circle's area.
std::vector<Edge> circleEdges(const Vec<2>& centre, Real radius, Real tolerance);

/// The edges cut wherever two of them cross, touch or overlap (within `tolerance`).
std::vector<Edge> cutAtCrossings(const std::vector<Edge>& edges, Real tolerance);

/// Of edges cut at their crossings, those that bound the set `inside`: the points at distance
/// `probe` to the left and right differ. Turned where the set is on the right; of edges that lie on
/// each other the first stays.
std::vector<Edge> boundaryOf(const std::vector<Edge>& edges, Real probe,
                             const std::function<bool(const Vec<2>&)>& inside);

/// Chains of edges whose ends meet within `tolerance`.
std::vector<Chain> chained(const std::vector<Edge>& edges, Real tolerance);

/// Nearest point of an edge.
Vec<2> nearestOn(const Edge& edge, const Vec<2>& x);
/// Area enclosed (shoelace formula over directed edges) [m2].
Real enclosedArea(const std::vector<Edge>& edges);
/// True if x is to the left: number of signed crossings of a ray is not zero.
bool encloses(const std::vector<Edge>& edges, const Vec<2>& x);

}  // namespace isph
