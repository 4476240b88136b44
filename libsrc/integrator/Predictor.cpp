// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/Predictor.hpp"

#include <algorithm>

namespace isph {

namespace {
constexpr Real kSoilShare = 0.05;   // a particle with more soil around it takes no dissipation

constexpr Real kInnerStrength = 8;  // c_r of inner pairs, whose rough part is small, over that of others

/// Lower bound of (lambda_i + lambda_j)/(2 Dim): sprays have little of a support.  [theory (2.8)]
constexpr Real kLeastSupport = 0.7;

template <int Dim>
Real supportFactor(Real lambda_i, Real lambda_j)
{
    return 1 / std::max(kLeastSupport, (lambda_i + lambda_j) / (2 * Dim));
}

/// grad v, row d = grad of component d, of inner particles; zero near the surface and in soil, where
/// the dissipation takes the whole velocity difference.                                    [theory (7.3)]
template <int Dim, class Medium>
void smoothPart(const Medium& medium, const StepFields<Dim>& fields, const std::vector<Vec<Dim>>& v,
                std::vector<Mat<Dim>>& gradV)
{
    const Points<Dim>& points = fields.points;
    gradV.assign(points.fluid, Mat<Dim>{});
    parallelForDynamic(points.water, [&](Index i) {
        if (fields.role[i] != SurfaceRole::inner || medium.share(i) >= kSoilShare) return;
        Mat<Dim> sum;
        fields.pairs.forWater(i, [&](const auto& pair) {
            sum += outer(points.volume[pair.j] * (v[pair.j] - v[i]), pair.gradW());
        });
        gradV[i] = sum * fields.corrections.Lwater[i];
    });
    points.refresh(gradV);
}

/// (v_ij.e) r without its smooth part, never more than it and never of the other sign.
inline Real roughPart(Real approach, Real smooth)
{
    const Real rough = approach - smooth;
    if (rough * approach <= 0) return 0;
    return std::abs(rough) < std::abs(approach) ? rough : approach;
}

/// Points of the lattice within 2 h. A pair may take away this share of its velocity difference in a
/// step and no more: the dissipation is explicit and must not overshoot where sprays meet.
template <int Dim>
Real neighboursOfLattice(const Scheme<Dim>& scheme)
{
    const Real q = 2 * scheme.h0 / scheme.spacing, pi = 3.141592653589793;
    return Dim == 2 ? pi * sqr(q) : 4 * pi / 3 * cube(q);
}
}  // namespace

template <int Dim, class Medium>
void predict(const Water<Dim>& water, const WallCloud<Dim>& walls, const Medium& medium,
             const Scheme<Dim>& scheme, const StepWeights& weights, StepFields<Dim>& fields)
{
    const Points<Dim>& points = fields.points;
    // Slip walls take no part in the friction, nor then in its support.
    const auto& lambda = walls.noSlip.empty() ? fields.corrections.lambdaWater : fields.corrections.lambda;
    std::vector<Vec<Dim>> v(points.fluid);   // extrapolated to the new time
    parallelFor(points.water, [&](Index i) {
        v[i] = medium.porosity(i) * ((1 + weights.ratio) * water.u[i] - weights.ratio * water.uOld[i]);
    });
    points.refresh(v);
    const bool turbulent = !fields.eddyViscosity.empty();
    const auto viscosity = [&](Index i) {
        return (scheme.viscosity + (turbulent ? fields.eddyViscosity[i] : 0)) / medium.porosity(i);
    };
    const Real most = 1 / (neighboursOfLattice(scheme) * weights.dtPrime());
    std::vector<Mat<Dim>> gradV;
    const bool dissipates = scheme.dissipation > 0;
    if (dissipates) smoothPart(medium, fields, v, gradV);
    const auto inner = [&](Index i) { return fields.role[i] == SurfaceRole::inner; };
    fields.v.resize(points.fluid);
    parallelForDynamic(points.water, [&](Index i) {
        Vec<Dim> rate;
        const Real nu_i = viscosity(i);
        const bool clear_i = medium.share(i) < kSoilShare;
        fields.pairs.forWater(i, [&](const auto& pair) {
            const Vec<Dim> v_ij = v[i] - v[pair.j];
            const Real VF = points.volume[pair.j] * pair.F();
            const Real nu_j = viscosity(pair.j), both = nu_i + nu_j;
            if (both > 0)
                rate -= (VF * 2 * nu_i * nu_j / both * supportFactor<Dim>(lambda[i], lambda[pair.j])) * v_ij;
            if (dissipates && clear_i && medium.share(pair.j) < kSoilShare) {
                Real approach = dot(v_ij, pair.x_ij);   // (v_ij.e) r
                Real strength = scheme.dissipation;
                if (inner(i) && inner(pair.j)) {
                    const Mat<Dim> gradient = Real(0.5) * (gradV[i] + gradV[pair.j]);
                    approach = roughPart(approach, dot(gradient * pair.x_ij, pair.x_ij));
                    strength *= kInnerStrength;
                }
                const Real r2 = std::max(normSqr(pair.x_ij), 1e-12 * sqr(scheme.spacing));
                const Real pull = std::min(2 * VF * strength * std::abs(approach), most);
                rate -= (pull * approach / r2) * pair.x_ij;
            }
        });
        if (!walls.noSlip.empty())
            fields.pairs.forWalls(i, [&](const auto& pair) {
                const Index k = pair.j - points.fluid;
                if (walls.noSlip[k])
                    rate -= points.volume[pair.j] * pair.F() * nu_i * supportFactor<Dim>(lambda[i], lambda[i])
                          * walls.slip(k, pair.x_ij, v[i], medium.porosity(i), scheme.spacing);
            });
        fields.v[i] = medium.porosity(i) * (weights.now() * water.u[i] + weights.before() * water.uOld[i])
                    + medium.mobility(i) * weights.dtPrime() * rate;
    });
    points.refresh(fields.v);
}

template void predict(const Water<2>&, const WallCloud<2>&, const ClearWater<2>&, const Scheme<2>&, const StepWeights&,
                      StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const ClearWater<3>&, const Scheme<3>&, const StepWeights&,
                      StepFields<3>&);
template void predict(const Water<2>&, const WallCloud<2>&, const WaterInSoil<2>&, const Scheme<2>&, const StepWeights&,
                      StepFields<2>&);
template void predict(const Water<3>&, const WallCloud<3>&, const WaterInSoil<3>&, const Scheme<3>&, const StepWeights&,
                      StepFields<3>&);

}  // namespace isph
