// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/WallGuard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph {

namespace {
constexpr Real kLeastHeight = 0.1;   // in d0 above a wall surface
constexpr Real kReach = 1.5;         // in d0: how far from a foot its plane stands for the wall
/// Cosine between the normals of two walls of a corner; below its negative the corner is narrow.
constexpr Real kTurned = 0.7;
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
        const Index wall = nearestFoot(x[i], [](Index) { return true; });
        if (wall < 0) return;
        const Index other = nearestFoot(x[i], [&](Index k) { return areCorner(wall, k); });
        const Vec<Dim> way = other < 0 ? wayOut(x[i], wall) : wayOut(x[i], wall, other);
        moved[i] = normSqr(way) > 0;
        x[i] += way;
    });
    return static_cast<Index>(std::count(moved.begin(), moved.end(), 1));
}

/// Of the feet that count; -1: none is near.
template <int Dim>
Index WallGuard<Dim>::nearestFoot(const Vec<Dim>& x, auto&& counts) const
{
    Real nearest = sqr(kReach * spacing_);
    Index foot = -1;
    grid_.forEachNear(x, kReach * spacing_, [&](Index k) {
        const Real r2 = normSqr(x - foot_[k]);
        if (r2 < nearest && counts(k)) nearest = r2, foot = k;
    });
    return foot;
}

/// Two walls with water between them: each lies on the wet side of the other. Those of an edge that
/// stands out into the water do not.
template <int Dim>
bool WallGuard<Dim>::areCorner(Index k, Index l) const
{
    const Vec<Dim> across = foot_[l] - foot_[k];
    return dot(normal_[k], normal_[l]) < kTurned && dot(across, normal_[k]) > 0 &&
           dot(across, normal_[l]) < 0;
}

template <int Dim>
Real WallGuard<Dim>::lack(const Vec<Dim>& x, Index k) const
{
    return kLeastHeight * spacing_ - dot(x - foot_[k], normal_[k]);
}

template <int Dim>
Vec<Dim> WallGuard<Dim>::wayOut(const Vec<Dim>& x, Index k) const
{
    return std::max(Real(0), lack(x, k)) * normal_[k];
}

/// The shortest way that leads out of both walls. Where they are close, as in the tip of a wedge,
/// it would be long, or there is none: then to the middle between them.
template <int Dim>
Vec<Dim> WallGuard<Dim>::wayOut(const Vec<Dim>& x, Index k, Index l) const
{
    const Vec<Dim> first = wayOut(x, k), second = wayOut(x, l);
    if (lack(x + first, l) <= 0) return first;
    if (lack(x + second, k) <= 0) return second;
    const Real c = dot(normal_[k], normal_[l]), a = lack(x, k), b = lack(x, l);
    if (c < -kTurned) return ((a - b) / (2 * (1 - c))) * (normal_[k] - normal_[l]);
    return (1 / (1 - sqr(c))) * ((a - c * b) * normal_[k] + (b - c * a) * normal_[l]);
}

template class WallGuard<2>;
template class WallGuard<3>;

}  // namespace isph
