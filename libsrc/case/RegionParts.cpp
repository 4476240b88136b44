// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/RegionParts.hpp"

#include "case/BoxCells.hpp"
#include "case/FaceLayer.hpp"

#include <algorithm>

namespace isph {

namespace {

std::vector<RegionPart> boxParts(const std::vector<BoxCell>& cells, int partners,
                                 const CaseGeometry& g)
{
    std::vector<RegionPart> parts;
    for (int p = -1; p < partners; ++p) {
        RegionPart part;
        part.partner = p;
        for (const BoxCell& cell : cells) {
            if (cell.partner != p) continue;
            part.boxes.push_back(cell.box);
            part.volume += volumeOf(cell.box, g.dimension);
            const BoundingBox b = boundsOf(cell.box);
            part.bounds.include(b.min);
            part.bounds.include(b.max);
        }
        if (!part.boxes.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

/// Area where the distance is negative, from the contours of all shapes that bound it.
Real areaOf(const RegionPart& part, const CaseGeometry& g, const std::vector<const Shape*>& shapes)
{
    const Real chord = 2e-4 * g.spacing;
    std::vector<Edge> edges = Box(g.domain.min, g.domain.max, 2).contour(0);
    for (const Shape* shape : shapes)
        for (const Edge& e : shape->contour(chord)) edges.push_back(e);
    return enclosedArea(
        boundaryOf(cutAtCrossings(edges, 1e-7 * g.spacing), 10 * chord, [&](const Vec<2>& x) {
            return part.distance({{x[0], x[1], 0}}) < 0;
        }));
}

/// Volumes of the parts of a region in 3-D. What no partner overlaps is the rest: faces that it
/// shares with partners would count by a fraction of the quadrature's cells. It is the rest of the
/// same quadrature: a region that partners overlap as a whole has none.
/// alone  nothing is taken from the shape
/// own    the distance to the whole region, within `bounds`
void measureParts(std::vector<RegionPart>& parts, const Shape& shape, bool alone,
                  const CaseGeometry& g, const BoundingBox& bounds,
                  const std::function<Real(const Point&)>& own)
{
    const Real step = 0.25 * g.spacing;
    const bool whole = alone && parts.size() == 1 && parts[0].partner < 0 && shape.bounded();
    const auto exact = whole ? shape.volume() : std::nullopt;
    Real rest = exact ? *exact : measure(bounds, 3, step, own);
    for (RegionPart& part : parts)
        if (part.partner >= 0) rest -= part.volume = measure(part.bounds, 3, step, part.distance);
    for (RegionPart& part : parts)
        if (part.partner < 0) part.volume = rest;
}

}  // namespace

std::vector<RegionPart> partsOf(const CaseGeometry& g, const Shape& shape,
                                const std::vector<const Shape*>& taken,
                                const std::vector<const Shape*>& partners)
{
    const std::optional<OrientedBox> box = shape.box();
    const auto cells = box ? cutIntoCells(*box, g.dimension, taken, partners) : std::nullopt;
    std::vector<RegionPart> parts;
    if (cells) parts = boxParts(*cells, static_cast<int>(partners.size()), g);

    const auto own = [&shape, &g, taken](const Point& x) {
        Real f = shape.signedDistance(x);
        if (!shape.bounded())
            f = std::max(f, Box(g.domain.min, g.domain.max, g.dimension).signedDistance(x));
        for (const Shape* other : taken) f = std::max(f, -other->signedDistance(x));
        return f;
    };
    const auto within = [own, partners](int p, const Point& x) {
        Real f = own(x);
        for (int q = 0; q < (p < 0 ? static_cast<int>(partners.size()) : p); ++q)
            f = std::max(f, -partners[q]->signedDistance(x));
        return p < 0 ? f : std::max(f, partners[p]->signedDistance(x));
    };
    if (cells) {
        for (RegionPart& part : parts)
            part.distance = [within, p = part.partner](const Point& x) { return within(p, x); };
        return parts;
    }
    const BoundingBox whole =
        shape.bounded() ? shape.bounds() : intersection(shape.bounds(), g.domain);
    for (int p = -1; p < static_cast<int>(partners.size()); ++p) {
        RegionPart part;
        part.partner = p;
        part.distance = [within, p](const Point& x) { return within(p, x); };
        part.bounds = p < 0 ? whole : intersection(whole, partners[p]->bounds());
        if (part.bounds.empty()) continue;
        part.frame = p < 0 ? box : partners[p]->box();
        parts.push_back(std::move(part));
    }
    if (g.dimension == 2) {
        std::vector<const Shape*> shapes{&shape};
        shapes.insert(shapes.end(), taken.begin(), taken.end());
        shapes.insert(shapes.end(), partners.begin(), partners.end());
        for (RegionPart& part : parts) part.volume = areaOf(part, g, shapes);
    } else {
        measureParts(parts, shape, taken.empty(), g, whole, own);
    }
    std::erase_if(parts, [&](const auto& part) { return part.volume <= 1e-9 * g.cellVolume(); });
    return parts;
}

namespace {

/// Points of a lattice over the bounds: aligned with the frame and fitted to it, else with the
/// corner of the domain.
template <class F>
void forEachLatticePoint(const RegionPart& part, const CaseGeometry& g, Real spacing, F&& f)
{
    OrientedBox lattice;
    lattice.origin = g.domain.min;
    Point step{{spacing, spacing, spacing}};
    if (part.frame) {
        lattice = *part.frame;
        for (int d = 0; d < g.dimension; ++d)
            step[d] = lattice.length[d] / std::max(1.0, std::round(lattice.length[d] / spacing));
    }
    BoundingBox local;
    for (int corner = 0; corner < 8; ++corner) {
        Point x;
        for (int d = 0; d < 3; ++d)
            x[d] = corner >> d & 1 ? part.bounds.max[d] : part.bounds.min[d];
        local.include(lattice.toLocal(x));
    }
    std::int64_t low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < g.dimension; ++d) {
        low[d] = static_cast<std::int64_t>(std::floor(local.min[d] / step[d])) - 1;
        high[d] = static_cast<std::int64_t>(std::ceil(local.max[d] / step[d]));
    }
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
        for (std::int64_t j = low[1]; j <= high[1]; ++j)
            for (std::int64_t i = low[0]; i <= high[0]; ++i) {
                const std::int64_t at[3] = {i, j, k};
                Point x;
                for (int d = 0; d < g.dimension; ++d)
                    x[d] = (static_cast<Real>(at[d]) + 0.5) * step[d];
                f(lattice.toGlobal(x));
            }
}

/// Even in each box; sums are rounded so that all boxes together have the number.
std::vector<Point> pointsInBoxes(const RegionPart& part, int dimension, std::int64_t count)
{
    std::vector<Point> points;
    Real filled = 0;
    std::int64_t placed = 0;
    for (const OrientedBox& box : part.boxes) {
        filled += volumeOf(box, dimension) / part.volume * static_cast<Real>(count);
        const std::int64_t upTo = std::llround(filled);
        for (const Point& x : fillBox(box, dimension, upTo - placed)) points.push_back(x);
        placed = upTo;
    }
    return points;
}

struct Candidate {
    Real distance;
    Point x;
};

/// The `count` deepest, in order of depth; of a row of equal depth that is cut, evenly many along
/// it.
std::vector<Point> deepest(std::vector<Candidate> candidates, std::size_t count, Real spacing)
{
    // round-off must not choose among points of equal depth
    const auto level = [&](const Candidate& c) {
        return std::llround(c.distance / (1e-7 * spacing));
    };
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](const auto& a, const auto& b) { return level(a) < level(b); });
    count = std::min(count, candidates.size());
    std::size_t first = count, last = count;  // of the row that is cut
    while (first > 0 && count < candidates.size() &&
           level(candidates[first - 1]) == level(candidates[count]))
        --first;
    while (last < candidates.size() && level(candidates[last]) == level(candidates[count])) ++last;
    std::vector<Point> points;
    for (std::size_t i = 0; i < first; ++i) points.push_back(candidates[i].x);
    for (std::size_t i = first; i < count; ++i)
        points.push_back(
            candidates[first + (2 * (i - first) + 1) * (last - first) / (2 * (count - first))].x);
    return points;
}

}  // namespace

PartPoints pointsIn(const RegionPart& part, const CaseGeometry& g, std::int64_t number,
                    Real spacing, const std::function<Real(const Point&)>& outside)
{
    PartPoints points;
    const auto count = static_cast<std::size_t>(number);
    if (part.isBoxes()) {
        points.x = pointsInBoxes(part, g.dimension, number);
        points.snapped.assign(points.x.size(), 0);
        return points;
    }
    const FaceLayer layer(g, outside, part.distance, spacing);
    std::vector<Candidate> others;
    forEachLatticePoint(part, g, spacing, [&](const Point& x) {
        const Real f = part.distance(x);
        if (f < 0 && outside && points.x.size() < count && layer.holds(x)) {
            points.x.push_back(x);
        } else if (f < 1.5 * spacing) {
            others.push_back({f, x});
        }
    });
    points.snapped = layer.laid(points.x);
    for (const Point& x : deepest(others, count - points.x.size(), spacing)) {
        const bool extra = outside && outside(x) > 0;  // one more than the lattice has inside
        points.x.push_back(extra ? layer.atDepth(x, 1.25) : x);
        points.snapped.push_back(extra);
    }
    return points;
}

}  // namespace isph
