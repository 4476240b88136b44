// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Filling.hpp"

namespace isph {

namespace {
/// Of the disorder that n and lambda show, what is in n alone: 0.29 to 0.36 in packings that water
/// has flowed into.
constexpr Real kShare = 1.0 / 3;

/// Water in soil and beside it, and what it sees of the packing around it.
template <int Dim>
class SoilPacking {
public:
    SoilPacking(const StepFields<Dim>& fields, const WaterInSoil<Dim>& medium,
                const LatticeSums& lattice)
        : fields_(fields), medium_(medium), lattice_(lattice)
    {
    }
    bool isDeep(Index i) const
    {
        return medium_.inSoil(i) && !medium_.atFace(i) && fields_.role[i] == SurfaceRole::inner;
    }
    bool isInSoilOrBeside(Index i) const
    {
        return (medium_.inSoil(i) || medium_.atFace(i)) && fields_.role[i] == SurfaceRole::inner;
    }
    Real surplus(Index i) const { return fields_.corrections.filling[i] - lattice_.filling; }
    /// n - n_0 lambda/lambda_0
    Real disorder(Index i) const
    {
        const Real lambda = fields_.corrections.lambda[i] / lattice_.lambda;
        return fields_.corrections.filling[i] - lattice_.filling * lambda;
    }
    /// Mean of `value`, weighted by V_j W_ij, over those in the support that are such.
    Real mean(Index i, const auto& isSuch, const auto& value) const
    {
        const Points<Dim>& points = fields_.points;
        Real weight = points.volume[i] * fields_.pairs.selfW(i), sum = weight * value(i);
        fields_.pairs.forWater(i, [&](const auto& pair) {
            const Index j = points.owner[pair.j];
            if (!isSuch(j)) return;
            weight += points.volume[j] * pair.W;
            sum += points.volume[j] * pair.W * value(j);
        });
        return sum / weight;
    }

private:
    const StepFields<Dim>& fields_;
    const WaterInSoil<Dim>& medium_;
    LatticeSums lattice_;
};
}  // namespace

template <int Dim, class Medium>
void fillingSurplus(const StepFields<Dim>& fields, const Medium& medium,
                    const LatticeSums& lattice, Real ownShare, LargeArray<Real>& surplus)
{
    const auto& n = fields.corrections.filling;
    surplus.resize(fields.points.water);
    parallelFor(fields.points.water, [&](Index i) { surplus[i] = n[i] - lattice.filling; });
    if constexpr (Medium::hasSoil) {
        const SoilPacking<Dim> soil(fields, medium, lattice);
        parallelForDynamic(fields.points.water, [&](Index i) {
            if (ownShare < 1 && soil.isInSoilOrBeside(i)) {
                const Real shared = soil.mean(
                    i, [&](Index j) { return soil.isInSoilOrBeside(j); },
                    [&](Index j) { return soil.surplus(j); });
                surplus[i] = ownShare * surplus[i] + (1 - ownShare) * shared;
            }
            if (soil.isDeep(i))
                surplus[i] -= kShare * soil.mean(i, [&](Index j) { return soil.isDeep(j); },
                                                 [&](Index j) { return soil.disorder(j); });
        });
    }
}

template void fillingSurplus(const StepFields<2>&, const ClearWater<2>&, const LatticeSums&, Real,
                             LargeArray<Real>&);
template void fillingSurplus(const StepFields<3>&, const ClearWater<3>&, const LatticeSums&, Real,
                             LargeArray<Real>&);
template void fillingSurplus(const StepFields<2>&, const WaterInSoil<2>&, const LatticeSums&, Real,
                             LargeArray<Real>&);
template void fillingSurplus(const StepFields<3>&, const WaterInSoil<3>&, const LatticeSums&, Real,
                             LargeArray<Real>&);

}  // namespace isph
