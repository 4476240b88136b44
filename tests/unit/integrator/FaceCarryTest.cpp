// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

constexpr Real kAlong = 0.3;   // pore velocity along the faces [m/s]; the Darcy velocity through them is 1

/// Water that flows slantwise through a strip without resistance, in a shaken packing: v = 1 through its faces and
/// u = 0.3 along them stay what they are, (1.2).
Scene<2> slantwiseFlow()
{
    Scene<2> s = SceneBuilder<2>(0.025).force({}).viscosity(0)
        .water({0, 0}, {0.25, 0.3}).waterCells({0.25, 0}, {0.75, 0.3}, {12, 8}).water({0.75, 0}, {1, 0.3})
        .shakeWater(0.1).soil({0.25, 0}, {0.75, 0.3}, "porousModel darcy; darcyCoeffs { porosity 0.4; K 1e6; }")
        .periodic({0, 0}, {1, 0.3}, {true, true}).build();
    // Uneven packings are at rest without these.
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0;
    PorousState<2> state;
    s.porous->evaluate(s.water.x, state);
    for (std::size_t i = 0; i < s.water.size(); ++i) s.water.u[i] = s.water.uOld[i] = {1 / state.porosity[i], kAlong};
    return s;
}

TEST(FaceCarry, AUniformFlowThroughAFaceWithoutResistanceStaysUniform)
{
    Scene<2> s = slantwiseFlow();
    s.scheme.dissipation = 0;   // v along the face changes through it
    Real through = 0, along = 0;
    // Particles go two spacings in clear water and five in the pores.
    advance<2>(s, 1e-3, 50, [&](int, const StepFields<2>& fields) {
        for (std::size_t i = 0; i < s.water.size(); ++i) {
            through = std::max(through, std::abs(fields.soil.porosity[i] * s.water.u[i][0] - 1));
            along = std::max(along, std::abs(s.water.u[i][1] - kAlong));
        }
    });
    // The solver leaves 1e-11; u along the face feels that the divergence of v along it is not exactly zero.
    EXPECT_LT(through, 1e-2);
    EXPECT_LT(along, 1e-2);
}

TEST(FaceCarry, TheDarcyVelocityOfARestartIsThatOfItsPorosity)
{
    // Half a step further the porosities are others; a history tells which ones belonged to the velocities.
    Scene<2> s = slantwiseFlow();
    advance<2>(s, 1e-3, 3);
    ASSERT_EQ(s.water.porosity.size(), s.water.size());
    PorousState<2> before;
    s.porous->evaluate(s.water.x, before);
    EXPECT_EQ(s.water.porosity, before.porosity);
    EXPECT_NE(s.water.porosityOld, before.porosity);
}

}  // namespace
