// SPDX-License-Identifier: GPL-3.0-or-later
#include "erosion/Erosion.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kSurfaceShare =
    0.85;                   // phi at a bed particle: 0.77 in the top row, 0.99 in the next
constexpr Real kSight = 2;  // in d0: how far a grain sees water
constexpr Real kClearPorosity = 0.7;  // water with fewer grains around it is that of the flow
constexpr Real kLeastWater = 0.3;     // volume of it in d0^D for a bed particle to be wet
constexpr Real kRepulsion = 15;       // of grains denser than intact soil, in d0 w_s grad C
// Of intact soil, the particle itself not counted (it has 0.30 in 2-D)
constexpr Real kPacked = 0.6;

/// Volume mean of the velocity of water of at least that porosity within reach of x, and its
/// volume.
template <int Dim>
struct Seen {
    Vec<Dim> u{};
    Real volume = 0;
};

template <int Dim>
Seen<Dim> lookAround(const WaterAround<Dim>& water, const Vec<Dim>& x, Real reach,
                     Real leastPorosity)
{
    Seen<Dim> seen;
    water.grid.forEachNear(x, reach, [&](Index j) {
        if (j >= water.points.fluid || normSqr(x - water.points.x[j]) >= reach * reach) return;
        const Index i = water.points.owner[j];
        if (water.porosity[i] < leastPorosity) return;
        seen.u += water.points.volume[j] * water.u[i];
        seen.volume += water.points.volume[j];
    });
    if (seen.volume > 0) seen.u *= 1 / seen.volume;
    return seen;
}
}  // namespace

Real settlingSpeed(Real grainDiameter, Real relativeDensity, Real g, Real viscosity)
{
    const Real DstarCubed = cube(grainDiameter) * (relativeDensity - 1) * g / sqr(viscosity);
    return viscosity / grainDiameter * (std::sqrt(sqr(10.36) + 1.049 * DstarCubed) - 10.36);
}

template <int Dim>
Erosion<Dim>::Erosion(std::unique_ptr<ErosionModel> model, Real spacing)
    : model_(std::move(model)), spacing_(spacing)
{
}

template <int Dim>
ErosionReport Erosion<Dim>::advance(const WaterAround<Dim>& water, const PorousField<Dim>& field,
                                    const PeriodicBox<Dim>& box, Real dt, Soil<Dim>& soil) const
{
    ErosionReport report;
    report.released = judge(water, field, soil);
    report.moving = static_cast<Index>(std::count(soil.released.begin(), soil.released.end(), 1));
    if (report.moving > 0) move(water, field, box, dt, soil);
    return report;
}

template <int Dim>
Index Erosion<Dim>::judge(const WaterAround<Dim>& water, const PorousField<Dim>& field,
                          Soil<Dim>& soil) const
{
    const std::size_t n = soil.size();
    const Vec<Dim> down = unit(water.gravity);
    const Real leastWater = kLeastWater * (Dim == 2 ? sqr(spacing_) : cube(spacing_));
    std::vector<Real> speed(n, 0), slope(n, 0), limit(n, 0);
    parallelForDynamic(n, [&](Index k) {
        if (soil.released[k]) return;
        const SoilSums<Dim> around = field.at(soil.x[k], -1);
        if (around.share / around.open > kSurfaceShare) return;
        const Seen<Dim> seen = lookAround(water, soil.x[k], kSight * spacing_, kClearPorosity);
        if (seen.volume < leastWater) return;
        const Vec<Dim> normal = unit(around.gradShare);
        const Vec<Dim> along = seen.u - dot(seen.u, normal) * normal;
        speed[k] = norm(along);
        slope[k] = std::asin(std::clamp(dot(unit(along), down), Real(-1), Real(1)));
    });
    model_->threshold(slope, water.density, norm(water.gravity), limit);
    Index released = 0;
    for (std::size_t k = 0; k < n; ++k)
        if (speed[k] > limit[k]) soil.released[k] = 1, ++released;
    return released;
}

template <int Dim>
void Erosion<Dim>::move(const WaterAround<Dim>& water, const PorousField<Dim>& field,
                        const PeriodicBox<Dim>& box, Real dt, Soil<Dim>& soil) const
{
    const Real s = model_->solidDensity() / water.density, g = norm(water.gravity);
    const Vec<Dim> reduced = (1 - 1 / s) * water.gravity;
    const Real fall = g > 0 ? settlingSpeed(model_->grainDiameter(), s, g, water.viscosity) : 1;
    const Real tau = fall / std::max(norm(reduced), 1e-30);
    const Real leastWater = kLeastWater * (Dim == 2 ? sqr(spacing_) : cube(spacing_));
    std::vector<Vec<Dim>> uNew(soil.u);
    parallelForDynamic(soil.size(), [&](Index k) {
        if (!soil.released[k]) return;
        const Seen<Dim> seen = lookAround(water, soil.x[k], kSight * spacing_, Real(0));
        Vec<Dim> u = soil.u[k] + dt * water.gravity;
        if (seen.volume >= leastWater)
            u = (soil.u[k] + dt * reduced + (dt / tau) * seen.u) / (1 + dt / tau);
        const SoilSums<Dim> here = field.at(soil.x[k], -1);
        const SoilSums<Dim> around = field.at(soil.x[k] + dt * u, k);
        const Real intact = 1 - field.zones()[static_cast<std::size_t>(soil.zone[k])].porosity;
        if (around.solid / around.open > kPacked * intact || around.open < Real(0.6)) {
            const Vec<Dim> into = unit(around.gradSolid);  // towards more solids, or the wall
            u -= std::max(Real(0), dot(u, into)) * into;
        }
        // Grains that are denser than the bed push each other apart, at most as fast as they
        // settle.
        const Real surplus = here.solid / here.open / intact - 1;
        if (surplus > 0) {
            const Vec<Dim> push = (-kRepulsion * spacing_ * fall * surplus) * here.gradSolid;
            const Real speed = norm(push);
            u += speed > fall ? (fall / speed) * push : push;
        }
        uNew[k] = u;
    });
    soil.u.swap(uNew);
    parallelFor(soil.size(), [&](Index k) {
        if (soil.released[k]) soil.x[k] = box.wrap(soil.x[k] + dt * soil.u[k]);
    });
}

template class Erosion<2>;
template class Erosion<3>;

}  // namespace isph
