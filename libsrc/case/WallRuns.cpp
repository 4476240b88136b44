// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/WallRuns.hpp"

#include <algorithm>
#include <numbers>

namespace isph {

namespace {

constexpr Real degree = std::numbers::pi / 180;

/// Angle from the direction of e to that of f, positive to the left.
Real turn(const Edge& e, const Edge& f)
{
    const Vec<2> s = unit(e.along()), t = unit(f.along());
    return std::atan2(s[0] * t[1] - s[1] * t[0], dot(s, t));
}

enum class Joint { smooth, corner, tip };

/// The body is on the left: a turn to the right is a wedge of water, which the layers go around.
Joint jointOf(const Edge& e, const Edge& f)
{
    const Real angle = turn(e, f);
    if (std::fabs(angle) < 30 * degree) return Joint::smooth;
    return angle < -100 * degree ? Joint::tip : Joint::corner;
}

/// Where the joint of two edges goes per unit of depth: m.(-n) = 1 for the normals of both.
Vec<2> miter(const Edge& e, const Edge& f)
{
    const Vec<2> n = e.normal(), m = f.normal();
    const Real c = 1 + dot(n, m);
    return c > 1e-3 ? (n + m) * (-1 / c) : -1.0 * n;
}

/// The end of a chain: along the face of the domain where that is periodic, else square to the
/// edge.
Vec<2> endDirection(const Edge& e, const Vec<2>& end, const CaseGeometry& g)
{
    const Vec<2> n = e.normal();
    for (int d = 0; d < 2; ++d) {
        const Real tolerance = 1e-6 * g.spacing;
        const bool onFace = std::fabs(end[d] - g.domain.min[d]) < tolerance ||
                            std::fabs(end[d] - g.domain.max[d]) < tolerance;
        if (!g.periodic[d] || !onFace || std::fabs(n[1 - d]) < 0.2) continue;
        Vec<2> along;
        along[1 - d] = -1 / n[1 - d];
        return along;
    }
    return -1.0 * n;
}

void addVertex(WallRun& run, const Vec<2>& x, const Vec<2>& inward, int tag)
{
    run.vertex.push_back(x);
    run.inward.push_back(inward);
    run.tag.push_back(tag);
}

/// A fan of inward directions from the normal of e to that of f, in steps of about ten degrees.
void addTip(WallRun& run, const Edge& e, const Edge& f)
{
    const Vec<2> n = -1.0 * e.normal();
    const Real angle = turn(e, f);
    const int steps = std::max(2, static_cast<int>(std::ceil(std::fabs(angle) / (10 * degree))));
    for (int k = 0; k <= steps; ++k) {
        const Real a = angle * k / steps, c = std::cos(a), s = std::sin(a);
        addVertex(run, f.a, {{c * n[0] - s * n[1], s * n[0] + c * n[1]}}, f.tag);
    }
}

/// The run that begins with the first edge, which in a closed chain follows the last.
WallRun firstRun(const std::vector<Edge>& edges, bool closed, const CaseGeometry& g)
{
    WallRun run;
    const Edge &first = edges.front(), &last = edges.back();
    const Joint joint = jointOf(last, first);
    if (!closed)
        addVertex(run, first.a, endDirection(first, first.a, g), first.tag);
    else if (joint == Joint::tip)
        addTip(run, last, first);
    else
        addVertex(run, first.a, miter(last, first), first.tag);
    if (closed && joint == Joint::corner) run.start = WallRun::End::corner;
    return run;
}

}  // namespace

std::vector<WallRun> wallRuns(const Chain& chain, const CaseGeometry& g)
{
    std::vector<Edge> edges = chain.edges;
    const std::size_t n = edges.size();
    bool closed = chain.closed;
    if (closed)  // begin at a corner, if there is one
        for (std::size_t j = 0; j < n; ++j)
            if (jointOf(edges[(j + n - 1) % n], edges[j]) == Joint::corner) {
                std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(j),
                            edges.end());
                break;
            }
    const bool cornered = closed && jointOf(edges[n - 1], edges[0]) == Joint::corner;

    std::vector<WallRun> runs{firstRun(edges, closed, g)};
    for (std::size_t j = 1; j < n; ++j) {
        const Edge &e = edges[j - 1], &f = edges[j];
        const Joint joint = jointOf(e, f);
        if (joint == Joint::tip) {
            addTip(runs.back(), e, f);
            continue;
        }
        addVertex(runs.back(), f.a, miter(e, f), f.tag);
        if (joint == Joint::smooth) continue;
        runs.back().end = WallRun::End::corner;
        runs.emplace_back().start = WallRun::End::corner;
        addVertex(runs.back(), f.a, miter(e, f), f.tag);
    }
    WallRun& last = runs.back();
    if (!closed)
        addVertex(last, edges[n - 1].b, endDirection(edges[n - 1], edges[n - 1].b, g),
                  edges[n - 1].tag);
    else
        addVertex(last, edges[n - 1].b, runs[0].inward[0], edges[n - 1].tag);
    if (cornered) last.end = WallRun::End::corner;
    last.closed = closed && !cornered;
    return runs;
}

OffsetLine::OffsetLine(const WallRun& run, Real depth)
{
    for (std::size_t i = 0; i + 1 < run.vertex.size(); ++i) {
        const Vec<2> a = run.vertex[i] + depth * run.inward[i],
                     b = run.vertex[i + 1] + depth * run.inward[i + 1];
        const Vec<2> original = run.vertex[i + 1] - run.vertex[i];
        if (dot(b - a, original) < 0)
            continue;  // beyond the centre of curvature: nothing is left of it
        from.push_back(a);
        to.push_back(b);
        tag.push_back(run.tag[i]);
        length += norm(b - a);
    }
}

Vec<2> OffsetLine::at(Real s, int& tagThere) const
{
    std::size_t i = 0;
    for (; i + 1 < from.size(); ++i) {
        const Real piece = norm(to[i] - from[i]);
        if (s <= piece) break;
        s -= piece;
    }
    tagThere = tag[i];
    return from[i] + s * unit(to[i] - from[i]);
}

}  // namespace isph
