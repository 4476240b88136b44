// SPDX-License-Identifier: GPL-3.0-or-later
// Soil that water takes away: which grains go, and where they move.                    [theory 9]
#pragma once
#include "erosion/ErosionModel.hpp"
#include "porous/PorousField.hpp"

#include <memory>

namespace isph {

/// What erosion sees of the water.
template <int Dim>
struct WaterAround {
    const CellGrid<Dim>& grid;  ///< over all points
    const Points<Dim>& points;
    Span<const Vec<Dim>> u;     ///< pore velocity of the water particles [m/s]
    Span<const Real> porosity;  ///< of the water particles
    Real density = 1000, viscosity = 1e-6;
    Vec<Dim> gravity{};
};

struct ErosionReport {
    Index released = 0;  ///< in this step
    Index moving = 0;    ///< all that were ever released
};

/// Releases bed particles and moves the released ones, after every step:
///   judge   a particle of the bed's surface (phi below 0.85) meets the speed |u_t| of the
///           water along the bed: volume mean of water of porosity above 0.7 within 2 d0 of it
///           (grains in motion shelter those below), normal to the bed by n = -grad phi/|grad phi|.
///           Above the model's threshold, for the slope angle theta along u_t, it is released at
///           once, as the paper has it.
///   move    a released particle follows the water with the inertia and weight of its density,
///           du_s/dt = (u - u_s)/tau + g (1 - rho/rho_s),  tau = w_s/(g (1 - rho/rho_s)), taken
///           implicitly; without water around it flies. It does not enter the bed, other released
///           particles at rest, or walls.                                          [theory (9.4)]
/// Its volume goes on to count for the porosity, so releasing changes nothing but its velocity and
/// drag, and the sum of the solid volumes is exact.
template <int Dim>
class Erosion {
public:
    Erosion(std::unique_ptr<ErosionModel> model, Real spacing);

    const ErosionModel& model() const { return *model_; }
    ErosionReport advance(const WaterAround<Dim>& water, const PorousField<Dim>& field,
                          const PeriodicBox<Dim>& box, Real dt, Soil<Dim>& soil) const;

private:
    Index judge(const WaterAround<Dim>& water, const PorousField<Dim>& field,
                Soil<Dim>& soil) const;
    void move(const WaterAround<Dim>& water, const PorousField<Dim>& field,
              const PeriodicBox<Dim>& box, Real dt, Soil<Dim>& soil) const;

    std::unique_ptr<ErosionModel> model_;
    Real spacing_;
};

/// Soulsby's settling speed of natural grains [m/s]:
///   w_s = nu/d (sqrt(10.36^2 + 1.049 D*^3) - 10.36),  D* = d ((s-1) g/nu^2)^(1/3)   [Soulsby 1997,
///   102]
Real settlingSpeed(Real grainDiameter, Real relativeDensity, Real g, Real viscosity);

extern template class Erosion<2>;
extern template class Erosion<3>;

}  // namespace isph
