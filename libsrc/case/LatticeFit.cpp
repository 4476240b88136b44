// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/LatticeFit.hpp"

#include "case/PointGrid.hpp"

#include <algorithm>

namespace isph {

namespace {

constexpr Real fits = 0.1;         // of a spacing: how far from half a spacing off a face is right
constexpr Real firstLayer = 0.95;  // of a spacing: points deeper than this belong to the second

/// 1 beside a disturbance of the lattice, 0 from `reach` on.
Real loosened(Real distance, Real reach)
{
    return std::clamp(2 * (1 - distance / reach), 0.0, 1.0);
}

bool inFirstLayer(Real distance, Real spacing)
{
    return distance > -firstLayer * spacing;
}

bool standsRight(Real distance, Real spacing)
{
    return std::fabs(distance + 0.5 * spacing) < fits * spacing;
}

}  // namespace

void LaidPoints::add(RegionPart p, std::size_t ofRegion, Real eps, Real apart,
                     const PartPoints& points)
{
    parts.push_back(std::move(p));
    region.push_back(ofRegion);
    porosity.push_back(eps);
    spacing.push_back(apart);
    x.insert(x.end(), points.x.begin(), points.x.end());
    snapped.insert(snapped.end(), points.snapped.begin(), points.snapped.end());
    part.resize(x.size(), parts.size() - 1);
}

LatticeFit latticeFit(const LaidPoints& laid, const CaseGeometry& g,
                      const std::function<Real(const Point&)>& outside)
{
    const Real reach = 5 * g.spacing;
    std::vector<PointGrid> byPart(laid.parts.size(), PointGrid(reach));
    PointGrid misfits(2 * reach);
    LatticeFit fit{std::vector<Real>(laid.x.size(), 0), std::vector<char>(laid.x.size(), 0)};
    for (std::size_t i = 0; i < laid.x.size(); ++i) {
        const std::size_t own = laid.part[i];
        byPart[own].add(laid.x[i]);
        const Real spacing = laid.spacing[own];
        const bool layered = laid.porosity[own] == 1 || laid.snapped[i];
        fit.slides[i] = layered && standsRight(outside(laid.x[i]), spacing);
        if (laid.parts[own].isBoxes()) continue;
        const Real f = laid.parts[own].distance(laid.x[i]);
        if (laid.snapped[i] || (inFirstLayer(f, spacing) && !standsRight(f, spacing)))
            misfits.add(laid.x[i]);
    }
    const auto loosen = [&](std::size_t i, const PointGrid& by, Real within) {
        const Index j = by.nearest(laid.x[i], within);
        if (j < 0) return;
        fit.mobility[i] = std::max(fit.mobility[i], loosened(norm(by[j] - laid.x[i]), within));
    };
    for (std::size_t i = 0; i < laid.x.size(); ++i) {
        const std::size_t own = laid.part[i];
        const bool inLayer = laid.snapped[i] && fit.slides[i];  // laid evenly: the others give way
        if (!laid.parts[own].isBoxes() && !inLayer) loosen(i, misfits, 2 * reach);
        for (std::size_t p = 0; p < laid.parts.size(); ++p) {
            const bool alike = laid.parts[p].isBoxes() && laid.porosity[p] == laid.porosity[own];
            if (p != own && !alike) loosen(i, byPart[p], reach);
        }
    }
    return fit;
}

}  // namespace isph
