// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/BoxCells.hpp"

#include <algorithm>
#include <numeric>

namespace isph {

namespace {

struct Extent {
    Point min, max;
};  // in the frame of the box that is cut

bool overlaps(const Extent& a, const Extent& b, int dimension, Real tolerance)
{
    for (int d = 0; d < dimension; ++d)
        if (a.min[d] >= b.max[d] - tolerance || b.min[d] >= a.max[d] - tolerance) return false;
    return true;
}

bool holds(const Extent& e, const Point& x, int dimension)
{
    for (int d = 0; d < dimension; ++d)
        if (x[d] < e.min[d] || x[d] > e.max[d]) return false;
    return true;
}

/// The other box in the frame of `box`; nullopt if its axes differ.
std::optional<Extent> inFrame(const OrientedBox& box, const OrientedBox& other)
{
    const Mat<3> relative = transpose(box.rotation) * other.rotation;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            if (std::fabs(relative[r][c] - (r == c)) > 1e-12) return std::nullopt;
    const Point low = box.toLocal(other.origin);
    return Extent{low, low + other.length};
}

Extent extentInFrame(const OrientedBox& box, const BoundingBox& b)
{
    BoundingBox local;
    for (int corner = 0; corner < 8; ++corner) {
        Point x;
        for (int d = 0; d < 3; ++d) x[d] = corner >> d & 1 ? b.max[d] : b.min[d];
        local.include(box.toLocal(x));
    }
    return {local.min, local.max};
}

/// Those of the shapes that overlap the box, as extents (nullopt inside: does not overlap).
bool collect(const OrientedBox& box, int dimension, Real tolerance,
             const std::vector<const Shape*>& shapes, std::vector<std::optional<Extent>>& extents)
{
    const Extent whole{{}, box.length};
    for (const Shape* shape : shapes) {
        const std::optional<OrientedBox> other = shape->box();
        const std::optional<Extent> extent = other ? inFrame(box, *other) : std::nullopt;
        const bool meets = overlaps(whole, extent ? *extent : extentInFrame(box, shape->bounds()),
                                    dimension, tolerance);
        if (meets && !extent) return false;
        extents.push_back(meets ? extent : std::nullopt);
    }
    return true;
}

std::vector<Real> cutsAlong(int d, Real length, Real tolerance,
                            const std::vector<std::optional<Extent>>& extents)
{
    std::vector<Real> cuts{0, length};
    for (const auto& e : extents)
        if (e) cuts.push_back(e->min[d]), cuts.push_back(e->max[d]);
    std::sort(cuts.begin(), cuts.end());
    std::vector<Real> kept{0};
    for (Real c : cuts)
        if (c > kept.back() + tolerance && c < length - tolerance) kept.push_back(c);
    kept.push_back(length);
    return kept;
}

/// Joins cells of one partner that share a whole face across axis d.
void mergeAlong(int d, int dimension, Real tolerance, std::vector<std::pair<Extent, int>>& cells)
{
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t j = 0; j < cells.size(); ++j) {
            if (i == j || cells[i].second != cells[j].second) continue;
            Extent &a = cells[i].first, &b = cells[j].first;
            bool joins = std::fabs(a.max[d] - b.min[d]) < tolerance;
            for (int e = 0; e < dimension; ++e)
                if (e != d)
                    joins = joins && std::fabs(a.min[e] - b.min[e]) < tolerance &&
                            std::fabs(a.max[e] - b.max[e]) < tolerance;
            if (!joins) continue;
            a.max[d] = b.max[d];
            cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(j));
            mergeAlong(d, dimension, tolerance, cells);
            return;
        }
}

}  // namespace

std::optional<std::vector<BoxCell>> cutIntoCells(const OrientedBox& box, int dimension,
                                                 const std::vector<const Shape*>& taken,
                                                 const std::vector<const Shape*>& partners)
{
    const Real tolerance = 1e-9 * norm(box.length);
    std::vector<std::optional<Extent>> gone, owners, all;
    if (!collect(box, dimension, tolerance, taken, gone) ||
        !collect(box, dimension, tolerance, partners, owners))
        return std::nullopt;
    all = gone;
    all.insert(all.end(), owners.begin(), owners.end());
    std::vector<Real> cuts[3] = {{}, {}, {0, 0}};
    for (int d = 0; d < dimension; ++d) cuts[d] = cutsAlong(d, box.length[d], tolerance, all);

    const auto holder = [&](const std::vector<std::optional<Extent>>& extents, const Point& x) {
        for (std::size_t k = 0; k < extents.size(); ++k)
            if (extents[k] && holds(*extents[k], x, dimension)) return static_cast<int>(k);
        return -1;
    };
    std::vector<std::pair<Extent, int>> cells;
    for (std::size_t k = 0; k + 1 < cuts[2].size(); ++k)
        for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j)
            for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
                const Extent e{{{cuts[0][i], cuts[1][j], cuts[2][k]}},
                               {{cuts[0][i + 1], cuts[1][j + 1], cuts[2][k + 1]}}};
                const Point middle = 0.5 * (e.min + e.max);
                if (holder(gone, middle) < 0) cells.emplace_back(e, holder(owners, middle));
            }
    for (int d = 0; d < dimension; ++d) mergeAlong(d, dimension, tolerance, cells);

    std::vector<BoxCell> result;
    for (const auto& [extent, partner] : cells)
        result.push_back(
            {{box.toGlobal(extent.min), box.rotation, extent.max - extent.min}, partner});
    return result;
}

Real volumeOf(const OrientedBox& box, int dimension)
{
    Real v = 1;
    for (int d = 0; d < dimension; ++d) v *= box.length[d];
    return v;
}

BoundingBox boundsOf(const OrientedBox& box)
{
    BoundingBox b;
    for (int corner = 0; corner < 8; ++corner) {
        Point x;
        for (int d = 0; d < 3; ++d) x[d] = corner >> d & 1 ? box.length[d] : 0;
        b.include(box.toGlobal(x));
    }
    return b;
}

namespace {

/// Divides [low, low + width] of axis axes[level] into slabs, and each slab along the next axes.
void fillSlabs(const OrientedBox& box, const std::vector<int>& axes, std::size_t level,
               std::int64_t count, Real spacing, Point at, std::vector<Point>& points)
{
    const int d = axes[level];
    const Real length = box.length[d];
    if (level + 1 == axes.size()) {
        for (std::int64_t i = 0; i < count; ++i) {
            at[d] = (static_cast<Real>(i) + 0.5) * length / static_cast<Real>(count);
            points.push_back(box.toGlobal(at));
        }
        return;
    }
    const std::int64_t slabs = std::clamp<std::int64_t>(std::llround(length / spacing), 1, count);
    std::int64_t before = 0;
    for (std::int64_t k = 0; k < slabs; ++k) {
        const std::int64_t upTo =
            (2 * (k + 1) * count + slabs) / (2 * slabs);  // rounded (k+1) count/slabs
        const auto share = static_cast<Real>(count);
        at[d] = 0.5 * static_cast<Real>(before + upTo) / share * length;
        if (upTo > before) fillSlabs(box, axes, level + 1, upTo - before, spacing, at, points);
        before = upTo;
    }
}

}  // namespace

std::vector<Point> fillBox(const OrientedBox& box, int dimension, std::int64_t count)
{
    std::vector<Point> points;
    if (count <= 0) return points;
    const Real spacing =
        std::pow(volumeOf(box, dimension) / static_cast<Real>(count), 1.0 / dimension);
    // rows along the longest side: there one particle more or less matters least. Of equal sides
    // the last.
    std::vector<int> axes(static_cast<std::size_t>(dimension));
    std::iota(axes.begin(), axes.end(), 0);
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return box.length[a] < box.length[b] * (1 - 1e-9); });
    fillSlabs(box, axes, 0, count, spacing, {}, points);
    return points;
}

}  // namespace isph
