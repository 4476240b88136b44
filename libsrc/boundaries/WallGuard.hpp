// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "boundaries/PointCloud.hpp"
#include "neighbours/CellGrid.hpp"

namespace isph {

/// Keeps water out of walls, whatever the pressure did: a particle lower than a tenth of a spacing
/// above a wall surface is put back to that height, in a corner above both walls. Flow along walls
/// stays half a spacing away and never meets the guard; it is there for impacts.     [theory (6.6)]
template <int Dim>
class WallGuard {
public:
    WallGuard(const WallCloud<Dim>& walls, Real spacing);
    /// Returns the number of particles that were put back.
    Index keepOut(std::vector<Vec<Dim>>& x) const;

private:
    Index nearestFoot(const Vec<Dim>& x, auto&& counts) const;
    bool areCorner(Index k, Index l) const;
    Real lack(const Vec<Dim>& x, Index k) const;
    Vec<Dim> wayOut(const Vec<Dim>& x, Index k) const;
    Vec<Dim> wayOut(const Vec<Dim>& x, Index k, Index l) const;

    CellGrid<Dim> grid_;
    /// Points of the wall surface, one of each particle next to it
    std::vector<Vec<Dim>> foot_, normal_;
    Real spacing_;
};

extern template class WallGuard<2>;
extern template class WallGuard<3>;

}  // namespace isph
