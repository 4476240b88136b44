// SPDX-License-Identifier: GPL-3.0-or-later
// Wall layers of two-dimensional cases, by arc length along the contours.
#include "case/PointGrid.hpp"
#include "case/WallLayers.hpp"
#include "case/WallRuns.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real seam = 1e-6;    // of d0: where two bodies touch there is no surface
constexpr Real closest = 0.6;  // of d0: two wall particles are not nearer than this

Point lifted(const Vec<2>& x)
{
    return {{x[0], x[1], 0}};
}

struct Foot {
    Vec<2> point;
    Real distance = std::numeric_limits<Real>::max();
    int tag = 0;
};

class Layers {
public:
    Layers(const CaseGeometry& g, Real thickness)
        : g_(g),
          d0_(g.spacing),
          layers_(layerCount(g.spacing, thickness)),
          depth_(layers_ * g.spacing),
          wet_(wetEdges(g, depth_ + g.spacing)),
          placed_(2 * g.spacing)
    {
        withImages();
    }

    WallParticles lay()
    {
        std::vector<std::vector<WallRun>> chains;
        for (const Chain& chain : chained(wet_, 1e-5 * d0_)) chains.push_back(wallRuns(chain, g_));
        for (int k = 0; k < layers_; ++k)
            for (const auto& runs : chains) layChain(runs, (k + 0.5) * d0_);
        correctVolumes();
        return std::move(walls_);
    }

private:
    /// Wet edges of the neighbouring periods: a particle's nearest surface may lie there.
    void withImages()
    {
        nearWet_ = wet_;
        for (int d = 0; d < 2; ++d) {
            if (!g_.periodic[d]) continue;
            const std::size_t count = nearWet_.size();
            Vec<2> shift;
            shift[d] = g_.domain.max[d] - g_.domain.min[d];
            for (std::size_t i = 0; i < count; ++i)
                for (Real sign : {-1.0, 1.0}) {
                    Edge e = nearWet_[i];
                    e.a += sign * shift;
                    e.b += sign * shift;
                    nearWet_.push_back(e);
                }
        }
    }

    Foot footOf(const Vec<2>& x) const
    {
        Foot best;
        for (const Edge& e : nearWet_) {
            const Vec<2> p = nearestOn(e, x);
            const Real distance = norm(p - x);
            if (distance < best.distance * (1 - 1e-12)) best = {p, distance, e.tag};
        }
        return best;
    }

    bool inBody(const Vec<2>& x) const
    {
        return g_.bodyDistance(g_.wrapped(lifted(x))) < seam * d0_;
    }

    void place(const Vec<2>& x, Real depth, Real volume)
    {
        const Foot foot = footOf(x);
        const bool free = inBody(x) && foot.distance > depth - 0.05 * d0_ &&
                          placed_.nearest(lifted(x), closest * d0_) < 0;
        if (!free) {
            refused_.push_back(lifted(x));
            return;
        }
        placed_.add(lifted(x));
        walls_.x.push_back(lifted(x));
        walls_.normal.push_back(lifted((foot.point - x) / foot.distance));
        walls_.depth.push_back(foot.distance);
        walls_.volume.push_back(volume);
        walls_.wall.push_back(foot.tag);
    }

    /// Spacing of a run at its length: the whole number of particles that comes nearest to d0.
    Real spacingOf(const WallRun& run, Real length) const
    {
        const Real ends = (run.start == WallRun::End::corner ? 0.5 : 0.0) +
                          (run.end == WallRun::End::corner ? 0.5 : 0.0);
        // particles stand at the corners themselves, half a spacing from open ends
        const Real between = ends == 0.5 ? std::max(0.0, std::round(length / d0_ - 0.5)) + 0.5
                                         : std::max(1.0, std::round(length / d0_));
        return length / between;
    }

    void layChain(const std::vector<WallRun>& runs, Real depth)
    {
        std::vector<OffsetLine> lines;
        std::vector<Real> spacing;
        for (const WallRun& run : runs) {
            lines.emplace_back(run, depth);
            spacing.push_back(lines.back().length > 0 ? spacingOf(run, lines.back().length) : 0);
        }
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const std::size_t before = (r + runs.size() - 1) % runs.size();
            const bool corner = runs[r].start == WallRun::End::corner;
            if (corner)
                place(runs[r].vertex[0] + depth * runs[r].inward[0], depth,
                      0.5 * d0_ * (spacing[before] + spacing[r]));
            if (lines[r].length <= 0) continue;
            const Real last = lines[r].length - 0.25 * spacing[r];
            for (Real s = (corner ? 1 : 0.5) * spacing[r]; s < last; s += spacing[r]) {
                int tag;
                place(lines[r].at(s, tag), depth, d0_ * spacing[r]);
            }
        }
    }

    /// Where layers of two sides met and particles were refused, each of those left gets the part
    /// of the body that is nearest to it, by quadrature.
    void correctVolumes()
    {
        const PointGrid refused(2 * d0_, refused_);
        const int samples = 20;  // eight to a spacing, so that cells of a lattice come out exact
        const Real reach = 1.25 * d0_, step = 2 * reach / samples;
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            if (refused.nearest(walls_.x[i], 1.6 * d0_) < 0) continue;
            int own = 0;
            for (int a = 0; a < samples; ++a)
                for (int b = 0; b < samples; ++b) {
                    const Vec<2> x{{walls_.x[i][0] - reach + (a + 0.5) * step,
                                    walls_.x[i][1] - reach + (b + 0.5) * step}};
                    if (placed_.nearest(lifted(x), 2 * d0_) != static_cast<Index>(i) || !inBody(x))
                        continue;
                    own += footOf(x).distance < depth_;
                }
            walls_.volume[i] = own * sqr(step);
        }
    }

    const CaseGeometry& g_;
    Real d0_;
    int layers_;
    Real depth_;
    std::vector<Edge> wet_, nearWet_;
    PointGrid placed_;
    std::vector<Point> refused_;
    WallParticles walls_;
};

}  // namespace

WallParticles detail::layWalls2(const CaseGeometry& geometry, Real thickness)
{
    return Layers(geometry, thickness).lay();
}

}  // namespace isph
