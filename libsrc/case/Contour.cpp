// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Contour.hpp"

#include <algorithm>
#include <numbers>

namespace isph {

std::vector<Edge> loopOf(const std::vector<Vec<2>>& points, int tag, bool curved)
{
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < points.size(); ++i)
        edges.push_back({points[i], points[(i + 1) % points.size()], tag, curved});
    return edges;
}

std::vector<Edge> circleEdges(const Vec<2>& centre, Real radius, Real tolerance)
{
    // sagitta of a chord of angle 2 pi/n: R (1 - cos(pi/n)) = tolerance
    const Real pi = std::numbers::pi;
    const Real angle = std::acos(std::max(0.0, 1 - std::min(1.0, tolerance / radius)));
    const int n = std::max(16, static_cast<int>(std::ceil(pi / angle)));
    const Real r = radius * std::sqrt(2 * pi / (n * std::sin(2 * pi / n)));  // equal area
    std::vector<Vec<2>> points;
    for (int i = 0; i < n; ++i)
        points.push_back(centre + r * Vec<2>{{std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)}});
    return loopOf(points, 0, true);
}

namespace {

Real cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Adds to `cuts` the positions on e (0..1) where the other edge crosses, touches or ends on it.
void crossings(const Edge& e, const Edge& other, Real tolerance, std::vector<Real>& cuts)
{
    const Real length = e.length();
    const Vec<2> t = e.along() / length;
    for (const Vec<2>& end : {other.a, other.b}) {
        const Vec<2> r = end - e.a;
        if (std::fabs(cross(t, r)) < tolerance) cuts.push_back(dot(t, r) / length);
    }
    const Real sideA = cross(t, other.a - e.a), sideB = cross(t, other.b - e.a);
    if (std::fabs(sideA) < tolerance || std::fabs(sideB) < tolerance || sideA * sideB > 0) return;
    const Vec<2> at = other.a + sideA / (sideA - sideB) * other.along();
    cuts.push_back(dot(t, at - e.a) / length);
}

struct Span2 {
    Real min[2], max[2];
    explicit Span2(const Edge& e)
    {
        for (int d = 0; d < 2; ++d) {
            min[d] = std::min(e.a[d], e.b[d]);
            max[d] = std::max(e.a[d], e.b[d]);
        }
    }
    bool apart(const Span2& o, Real tolerance) const
    {
        for (int d = 0; d < 2; ++d)
            if (min[d] > o.max[d] + tolerance || o.min[d] > max[d] + tolerance) return true;
        return false;
    }
};

}  // namespace

std::vector<Edge> cutAtCrossings(const std::vector<Edge>& edges, Real tolerance)
{
    std::vector<Span2> spans;
    for (const Edge& e : edges) spans.emplace_back(e);
    std::vector<std::size_t> order(edges.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return spans[i].min[0] < spans[j].min[0];
    });

    std::vector<std::vector<Real>> cuts(edges.size());
    for (std::size_t s = 0; s < order.size(); ++s)
        for (std::size_t u = s + 1; u < order.size(); ++u) {
            const std::size_t i = order[s], j = order[u];
            if (spans[j].min[0] > spans[i].max[0] + tolerance) break;
            if (spans[i].apart(spans[j], tolerance)) continue;
            crossings(edges[i], edges[j], tolerance, cuts[i]);
            crossings(edges[j], edges[i], tolerance, cuts[j]);
        }

    std::vector<Edge> pieces;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& e = edges[i];
        const Real near = tolerance / e.length();
        std::sort(cuts[i].begin(), cuts[i].end());
        Vec<2> from = e.a;
        Real last = 0;
        for (Real t : cuts[i]) {
            if (t < last + near || t > 1 - near) continue;
            const Vec<2> to = e.a + t * e.along();
            pieces.push_back({from, to, e.tag, e.curved});
            from = to;
            last = t;
        }
        pieces.push_back({from, e.b, e.tag, e.curved});
    }
    return pieces;
}

std::vector<Edge> boundaryOf(const std::vector<Edge>& edges, Real probe,
                             const std::function<bool(const Vec<2>&)>& inside)
{
    std::vector<Edge> kept;
    std::vector<Vec<2>> middles;
    for (const Edge& e : edges) {
        const Vec<2> middle = 0.5 * (e.a + e.b), n = e.normal();
        const bool left = inside(middle - probe * n), right = inside(middle + probe * n);
        if (left == right) continue;
        const auto same = [&](std::size_t k) {
            return norm(middles[k] - middle) < 0.5 * probe &&
                   std::fabs(kept[k].length() - e.length()) < probe &&
                   std::fabs(dot(kept[k].normal(), n)) > 0.99;
        };
        bool twice = false;
        for (std::size_t k = 0; k < kept.size() && !twice; ++k) twice = same(k);
        if (twice) continue;
        middles.push_back(middle);
        kept.push_back(left ? e : Edge{e.b, e.a, e.tag, e.curved});
    }
    return kept;
}

std::vector<Chain> chained(const std::vector<Edge>& edges, Real tolerance)
{
    const std::size_t none = edges.size();
    std::vector<std::size_t> next(edges.size(), none), previous(edges.size(), none);
    std::vector<std::size_t> byStart(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) byStart[i] = i;
    std::stable_sort(byStart.begin(), byStart.end(),
                     [&](std::size_t i, std::size_t j) { return edges[i].a[0] < edges[j].a[0]; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto from =
            std::lower_bound(byStart.begin(), byStart.end(), edges[i].b[0] - tolerance,
                             [&](std::size_t k, Real x) { return edges[k].a[0] < x; });
        for (auto k = from; k != byStart.end() && edges[*k].a[0] <= edges[i].b[0] + tolerance; ++k)
            if (previous[*k] == none && next[i] == none &&
                norm(edges[*k].a - edges[i].b) <= tolerance) {
                next[i] = *k;
                previous[*k] = i;
            }
    }
    std::vector<Chain> chains;
    std::vector<bool> used(edges.size(), false);
    const auto follow = [&](std::size_t start) {
        Chain chain;
        std::size_t i = start;
        for (; i != none && !used[i]; i = next[i]) {
            used[i] = true;
            chain.edges.push_back(edges[i]);
        }
        chain.closed = i == start && next[start] != none;
        chains.push_back(std::move(chain));
    };
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (previous[i] == none) follow(i);
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!used[i]) follow(i);
    return chains;
}

Vec<2> nearestOn(const Edge& edge, const Vec<2>& x)
{
    const Vec<2> t = edge.along();
    const Real s = dot(x - edge.a, t) / std::max(normSqr(t), 1e-300);
    return edge.a + std::clamp(s, 0.0, 1.0) * t;
}

Real enclosedArea(const std::vector<Edge>& edges)
{
    Real twice = 0;
    for (const Edge& e : edges) twice += cross(e.a, e.b);
    return 0.5 * twice;
}

bool encloses(const std::vector<Edge>& edges, const Vec<2>& x)
{
    int winding = 0;
    for (const Edge& e : edges) {
        const bool up = e.a[1] <= x[1] && e.b[1] > x[1], down = e.b[1] <= x[1] && e.a[1] > x[1];
        if (!up && !down) continue;
        const Real side = cross(e.along(), x - e.a);
        if (up && side > 0) ++winding;
        if (down && side < 0) --winding;
    }
    return winding != 0;
}

}  // namespace isph
