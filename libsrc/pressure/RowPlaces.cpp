// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/RowPlaces.hpp"

namespace isph {

template <int Dim>
void placeRows(const Points<Dim>& points, Span<const Index> particle, RowPlaces& places)
{
    places.dimension = Dim;
    places.particle.assign(particle.begin(), particle.end());
    places.coordinate.resize(Dim * particle.size());
    places.spacing.resize(particle.size());
    parallelFor(particle.size(), [&](Index r) {
        const Index i = particle[r];
        for (int d = 0; d < Dim; ++d) places.coordinate[r * Dim + d] = points.x[i][d];
        const Real volume = points.volume[i];
        places.spacing[r] = Dim == 2 ? std::sqrt(volume) : std::cbrt(volume);
    });
}

template void placeRows(const Points<2>&, Span<const Index>, RowPlaces&);
template void placeRows(const Points<3>&, Span<const Index>, RowPlaces&);

}  // namespace isph
