// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/FaceFilter.hpp"

#include "operators/SupportFactor.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kShare = 0.004;         // of h0^2 that the noise spreads over in a step
// Courant number of water that is past the face before noise has grown
constexpr Real kPassing = 0.05;

template <int Dim>
class Filter {
public:
    Filter(const Water<Dim>& water, const WaterInSoil<Dim>& medium, const Scheme<Dim>& scheme,
           const StepWeights& weights, const StepFields<Dim>& fields, FaceFields<Dim>& at)
        : medium_(medium), scheme_(scheme), weights_(weights), fields_(fields), at_(at)
    {
        const Points<Dim>& points = fields.points;
        at.viscosity.resize(points.fluid), at.gradient.resize(points.fluid);
        parallelForDynamic(points.water, [&](Index i) {
            at.viscosity[i] = viscosity(norm(water.u[i]), medium.porosity(i));
            if (at.viscosity[i] > 0 && !besideFace(i)) at.viscosity[i] = 0;
        });
        points.refresh(at.viscosity);
        parallelForDynamic(points.water, [&](Index i) {
            if (at.viscosity[i] > 0) at.gradient[i] = gradientInZone(i);
        });
        points.refresh(at.gradient);
    }
    Vec<Dim> rate(Index i) const
    {
        Vec<Dim> rate;
        if (at_.viscosity[i] == 0) return rate;
        const auto& lambda = fields_.corrections.lambda;
        fields_.pairs.forWater(i, [&](const auto& pair) {
            const Index j = pair.j;
            const Real nu = medium_.zone(j) == medium_.zone(i)
                                ? std::min(at_.viscosity[i], at_.viscosity[j])
                                : 0;
            if (nu == 0) return;
            const Index owner = fields_.points.owner[j];
            const Real weight =
                fields_.points.volume[j] * pair.F() * supportFactor<Dim>(lambda[i], lambda[owner]);
            const Vec<Dim> smooth = Real(0.5) * ((at_.gradient[i] + at_.gradient[j]) * pair.x_ij);
            rate -= weight * nu * (at_.v[i] - at_.v[j] - smooth);
        });
        return rate;
    }

private:
    bool besideFace(Index i) const
    {
        if (fields_.role[i] != SurfaceRole::inner) return false;
        bool beside = false;
        fields_.pairs.forWater(
            i, [&](const auto& pair) { beside |= medium_.zone(pair.j) != medium_.zone(i); });
        return beside;
    }
    Real viscosity(Real speed, Real porosity) const
    {
        // (3.8)
        const Real Co = weights_.dt * speed * std::pow(porosity, Real(1) / Dim) / scheme_.spacing;
        return kShare * std::max(Real(0), 1 - Co / kPassing) * sqr(scheme_.h0) / weights_.dtPrime();
    }
    /// grad v of the partners in the zone of i alone: across the face it has a jump.
    Mat<Dim> gradientInZone(Index i) const
    {
        Mat<Dim> sum, moments;
        fields_.pairs.forWater(i, [&](const auto& pair) {
            if (medium_.zone(pair.j) != medium_.zone(i)) return;
            const Vec<Dim> VGradW = fields_.points.volume[pair.j] * pair.gradW();
            sum += outer(at_.v[pair.j] - at_.v[i], VGradW);
            moments += outer(-VGradW, pair.x_ij);
        });
        return sum * blendedInverse(moments);
    }

    const WaterInSoil<Dim>& medium_;
    const Scheme<Dim>& scheme_;
    const StepWeights& weights_;
    const StepFields<Dim>& fields_;
    FaceFields<Dim>& at_;
};
}  // namespace

template <int Dim>
void filterAtFaces(const Water<Dim>& water, const WaterInSoil<Dim>& medium,
                   const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields)
{
    const Filter<Dim> filter(water, medium, scheme, weights, fields, fields.face);
    parallelForDynamic(fields.points.water, [&](Index i) {
        fields.v[i] += medium.mobility(i) * weights.dtPrime() * filter.rate(i);
    });
    fields.points.refresh(fields.v);
}

template void filterAtFaces(const Water<2>&, const WaterInSoil<2>&, const Scheme<2>&,
                            const StepWeights&, StepFields<2>&);
template void filterAtFaces(const Water<3>&, const WaterInSoil<3>&, const Scheme<3>&,
                            const StepWeights&, StepFields<3>&);

}  // namespace isph
