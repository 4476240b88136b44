// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/FreeSurface.hpp"

namespace isph {

template <int Dim>
void findFreeSurface(const Points<Dim>& points, const PairList<Dim>& pairs,
                     const Corrections<Dim>& corrections, std::vector<SurfaceRole>& role)
{
    role.resize(points.fluid);
    const auto atSurface = [&](Index j) { return corrections.lambda[j] < surfaceThreshold<Dim>(); };
    parallelForDynamic(points.water, [&](Index i) {
        role[i] = SurfaceRole::inner;
        if (atSurface(i)) {
            role[i] = SurfaceRole::surface;
            return;
        }
        pairs.forWater(i, [&](const auto& pair) {
            if (atSurface(pair.j)) role[i] = SurfaceRole::near;
        });
    });
    points.refresh(role);
}

template void findFreeSurface(const Points<2>&, const PairList<2>&, const Corrections<2>&, std::vector<SurfaceRole>&);
template void findFreeSurface(const Points<3>&, const PairList<3>&, const Corrections<3>&, std::vector<SurfaceRole>&);

}  // namespace isph
