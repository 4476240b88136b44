// SPDX-License-Identifier: GPL-3.0-or-later
// Wall layers of three-dimensional cases.
#include "case/WallCandidates.hpp"
#include "case/WallLayers.hpp"
#include "case/WetSurface.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real seam = 1e-6;    // of d0: where two bodies touch there is no surface
constexpr Real closest = 0.6;  // of d0: two wall particles are not nearer than this

class Layers3 {
public:
    Layers3(const CaseGeometry& g, int layers)
        : g_(g),
          d0_(g.spacing),
          layers_(layers),
          depth_(layers * g.spacing),
          limits_(wallLimits(g, depth_)),
          surface_(g, depth_ + g.spacing),
          placed_(2 * g.spacing)
    {
    }

    WallParticles lay()
    {
        for (bool boxes : {true, false})  // lattices first: others give way where they meet
            for (const Wall& wall : g_.walls)
                if (wall.shape().box().has_value() == boxes)
                    place(boxes ? boxCandidates(wall, g_, layers_)
                                : shellCandidates(wall, g_, layers_));
        correctVolumes();
        return std::move(walls_);
    }

private:
    void place(const WallCandidates& candidates)
    {
        for (std::size_t c = 0; c < candidates.x.size(); ++c) {
            const Point& x = candidates.x[c];
            if (!limits_.contains(x, 1e-9 * d0_) || g_.bodyDistance(x) > seam * d0_) continue;
            const WetSurface::Foot foot = surface_.foot(x);
            if (foot.wall < 0 || foot.distance > depth_) continue;  // too deep to be seen
            if (foot.distance < 0.35 * d0_ || placed_.nearest(x, closest * d0_) >= 0) {
                refused_.push_back(x);
                continue;
            }
            placed_.add(x);
            walls_.x.push_back(x);
            walls_.normal.push_back((foot.point - x) / foot.distance);
            walls_.depth.push_back(foot.distance);
            walls_.volume.push_back(candidates.volume[c]);
            walls_.wall.push_back(foot.wall);
            exact_.push_back(candidates.exact);
        }
    }

    /// Particles that are no cells of a lattice, or beside refused ones, get the part of the body
    /// that is nearest to them, by quadrature at d0/4.
    void correctVolumes()
    {
        const PointGrid refused(2 * d0_, refused_);
        std::vector<char> irregular(walls_.size());
        PointGrid around(2 * d0_);
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            irregular[i] = !exact_[i] || refused.nearest(walls_.x[i], 1.6 * d0_) >= 0;
            if (irregular[i]) around.add(walls_.x[i]);
        }
        if (around.size() == 0) return;
        for (std::size_t i = 0; i < walls_.size(); ++i)
            if (irregular[i]) walls_.volume[i] = 0;
        const Real step = 0.25 * d0_;
        const auto distance = [&](const Point& x) { return g_.bodyDistance(g_.wrapped(x)); };
        forEachCellNear(limits_, 3, step, depth_ + d0_, distance, [&](const Point& x) {
            if (around.nearest(x, 1.2 * d0_) < 0) return;
            const Index i = placed_.nearest(x, 1.2 * d0_);
            if (i < 0 || !irregular[i] || distance(x) >= 0) return;
            const Real deeper =
                dot(walls_.x[i] - x, walls_.normal[i]);  // the last layer ends half a spacing below
            if (deeper > 0.5 * d0_ && walls_.depth[i] > depth_ - d0_) return;
            walls_.volume[i] += cube(step);
        });
    }

    const CaseGeometry& g_;
    Real d0_;
    int layers_;
    Real depth_;
    BoundingBox limits_;
    WetSurface surface_;
    PointGrid placed_;
    std::vector<Point> refused_;
    std::vector<char> exact_;
    WallParticles walls_;
};

}  // namespace

WallParticles detail::layWalls3(const CaseGeometry& geometry, Real thickness)
{
    return Layers3(geometry, layerCount(geometry.spacing, thickness)).lay();
}

}  // namespace isph
