// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Grains set free in a periodic box of water without friction, at places without order.
Scene<2> grainsInWater(const Vec<2>& water, const Vec<2>& grains)
{
    constexpr Real d0 = 0.01, L = 32 * d0;
    Scene<2> s = SceneBuilder<2>(d0)
                     .force({})
                     .viscosity(0)
                     .water({0, 0}, {L, L}, water)
                     .shakeWater(0.1)
                     .soil({0.08, 0.08}, {0.24, 0.24},
                           "porousModel darcy; darcyCoeffs { porosity 0.8; K 1e9; }")
                     .periodic({0, 0}, {L, L}, {true, true})
                     .build();
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0, s.scheme.dissipation = 0;
    shake(s.soil.x, 0.4 * d0);
    s.soil.released.assign(s.soil.size(), 1);
    s.soil.u.assign(s.soil.size(), grains);
    s.porous->place(s.soil, s.box);
    return s;
}

TEST(MovingGrains, ThatDriftAlongWithTheWaterLeaveItAlone)
{
    const Vec<2> u = {1, 0.5};
    Scene<2> s = grainsInWater(u, u);
    constexpr Real dt = 1e-3;
    Real worst = 0;
    advance<2>(s, dt, 20, [&](int, const StepFields<2>&) {
        for (const Vec<2>& u_i : s.water.u) worst = std::max(worst, norm(u_i - u));
        for (Vec<2>& x : s.soil.x) x = s.box.wrap(x + dt * u);
        s.porous->place(s.soil, s.box);
    });
    EXPECT_LT(worst, 1e-5);   // kernels of pairs are in single precision
}

TEST(MovingGrains, DriveTheirVolumeOfWaterTheOtherWay)
{
    // A band of grains across the box, of a fifth of its volume, at 1 m/s: nothing else may go
    // where they come from.
    constexpr Real d0 = 0.01, L = 32 * d0;
    Scene<2> s = SceneBuilder<2>(d0).force({}).viscosity(0).water({0, 0}, {L, L})
        .soil({0, 0.08}, {L, 0.24}, "porousModel darcy; darcyCoeffs { porosity 0.8; K 1e9; }")
        .periodic({0, 0}, {L, L}, {true, true}).build();
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0, s.scheme.dissipation = 0;
    s.soil.released.assign(s.soil.size(), 1);
    s.soil.u.assign(s.soil.size(), Vec<2>{0, 1});
    s.porous->place(s.soil, s.box);
    advance<2>(s, 1e-4, 10, [&](int step, const StepFields<2>& fields) {
        if (step < 10) return;
        Real in = 0, out = 0, inCount = 0, outCount = 0;
        for (std::size_t i = 0; i < s.water.size(); ++i) {
            const Real v = fields.soil.porosity[i] * s.water.u[i][1];
            if (std::abs(s.water.x[i][1] - 0.16) < 0.04) in += v, ++inCount;
            if (s.water.x[i][1] < 0.04 || s.water.x[i][1] > 0.28) out += v, ++outCount;
        }
        EXPECT_NEAR(out / outCount - in / inCount, 0.2,
                    0.01);  // v + v_s is the same in the band and beside it
    });
}

}  // namespace
