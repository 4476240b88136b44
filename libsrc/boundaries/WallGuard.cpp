// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/WallGuard.hpp"

#include <cmath>
#include <limits>

namespace isph {

namespace {
constexpr Real kLeastHeight = 0.1;   // in d0 above a wall surface
constexpr Real kReach = 1.5;         // in d0: how far from a foot its plane stands for the wall
}  // namespace

template <int Dim>
WallGuard<Dim>::WallGuard(const WallCloud<Dim>& walls, Real spacing) : spacing_(spacing)
{
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (walls.depth[k] < spacing) {
            foot_.push_back(walls.x[k] + walls.depth[k] * walls.normal[k]);
            normal_.push_back(walls.normal[k]);
        }
    grid_.build(foot_, kReach * spacing);
}

template <int Dim>
Index WallGuard<Dim>::keepOut(std::vector<Vec<Dim>>& x) const
{
    if (foot_.empty()) return 0;
    std::vector<char> moved(x.size(), 0);
    parallelFor(x.size(), [&](Index i) {
        Real nearest = sqr(kReach * spacing_);
        Index foot = -1;
        grid_.forEachNear(x[i], kReach * spacing_, [&](Index k) {
            const Real r2 = normSqr(x[i] - foot_[k]);
            if (r2 < nearest) nearest = r2, foot = k;
        });
        if (foot < 0) return;
        const Real lack = kLeastHeight * spacing_ - dot(x[i] - foot_[foot], normal_[foot]);
        if (lack <= 0) return;
        x[i] += lack * normal_[foot];
        moved[i] = 1;
    });
    return static_cast<Index>(std::count(moved.begin(), moved.end(), 1));
}

template class WallGuard<2>;
template class WallGuard<3>;

}  // namespace isph
