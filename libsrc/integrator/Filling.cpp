// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Filling.hpp"

namespace isph {

namespace {
/// Of the disorder that n and lambda show, what is in n alone: packings that water has flowed into, 0.29 to 0.36.
constexpr Real kShare = 1.0 / 3;

template <int Dim>
class Disorder {
public:
    Disorder(const StepFields<Dim>& fields, const WaterInSoil<Dim>& medium, const LatticeSums& lattice)
        : fields_(fields), medium_(medium), lattice_(lattice)
    {
    }
    bool isDeep(Index i) const
    {
        return medium_.inSoil(i) && !medium_.atFace(i) && fields_.role[i] == SurfaceRole::inner;
    }
    /// <n - n_0 lambda/lambda_0>_i over the deep ones in the support.
    Real mean(Index i) const
    {
        const Points<Dim>& points = fields_.points;
        Real weight = points.volume[i] * fields_.pairs.selfW(i), sum = weight * of(i);
        fields_.pairs.forWater(i, [&](const auto& pair) {
            const Index j = points.owner[pair.j];
            if (!isDeep(j)) return;
            weight += points.volume[j] * pair.W;
            sum += points.volume[j] * pair.W * of(j);
        });
        return sum / weight;
    }

private:
    Real of(Index i) const
    {
        return fields_.corrections.filling[i] - lattice_.filling * fields_.corrections.lambda[i] / lattice_.lambda;
    }

    const StepFields<Dim>& fields_;
    const WaterInSoil<Dim>& medium_;
    LatticeSums lattice_;
};
}  // namespace

template <int Dim, class Medium>
void fillingSurplus(const StepFields<Dim>& fields, const Medium& medium, const LatticeSums& lattice,
                    LargeArray<Real>& surplus)
{
    const auto& n = fields.corrections.filling;
    surplus.resize(fields.points.water);
    parallelFor(fields.points.water, [&](Index i) { surplus[i] = n[i] - lattice.filling; });
    if constexpr (Medium::hasSoil) {
        const Disorder<Dim> disorder(fields, medium, lattice);
        parallelForDynamic(fields.points.water, [&](Index i) {
            if (disorder.isDeep(i)) surplus[i] -= kShare * disorder.mean(i);
        });
    }
}

template void fillingSurplus(const StepFields<2>&, const ClearWater<2>&, const LatticeSums&, LargeArray<Real>&);
template void fillingSurplus(const StepFields<3>&, const ClearWater<3>&, const LatticeSums&, LargeArray<Real>&);
template void fillingSurplus(const StepFields<2>&, const WaterInSoil<2>&, const LatticeSums&, LargeArray<Real>&);
template void fillingSurplus(const StepFields<3>&, const WaterInSoil<3>&, const LatticeSums&, LargeArray<Real>&);

}  // namespace isph
