// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/StrainRate.hpp"

#include "operators/Gradient.hpp"

#include <cmath>

namespace isph {

template <int Dim>
void strainRate(const Points<Dim>& points, const PairList<Dim>& pairs,
                const Corrections<Dim>& corrections, Span<const Vec<Dim>> u,
                std::vector<Real>& rate)
{
    rate.resize(points.water);
    parallelForDynamic(points.water, [&](Index i) {
        const Mat<Dim> gradU = pairGradient(points, pairs, u, i) * corrections.Lwater(i);
        const Mat<Dim> S = Real(0.5) * (gradU + transpose(gradU));
        Real SS = 0;
        for (int d = 0; d < Dim; ++d) SS += dot(S[d], S[d]);
        rate[i] = std::sqrt(2 * SS);
    });
}

template void strainRate(const Points<2>&, const PairList<2>&, const Corrections<2>&,
                         Span<const Vec<2>>, std::vector<Real>&);
template void strainRate(const Points<3>&, const PairList<3>&, const Corrections<3>&,
                         Span<const Vec<3>>, std::vector<Real>&);

}  // namespace isph
