// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Water that flows through a strip without resistance in a shaken packing. Its Darcy velocity
/// through the faces, 1, and its pore velocity along them stay what they are, (1.2).
Scene<2> flowThroughStrip(Real along)
{
    Scene<2> s =
        SceneBuilder<2>(0.025)
            .force({})
            .viscosity(0)
            .water({0, 0}, {0.25, 0.3})
            .waterCells({0.25, 0}, {0.75, 0.3}, {12, 8})
            .water({0.75, 0}, {1, 0.3})
            .shakeWater(0.1)
            .soil({0.25, 0}, {0.75, 0.3}, "porousModel darcy; darcyCoeffs { porosity 0.4; K 1e9; }")
            .periodic({0, 0}, {1, 0.3}, {true, true})
            .build();
    // Uneven packings are at rest without these; the Darcy velocity along a face changes through
    // it.
    s.scheme.stabilisation = Stabilisation::none, s.scheme.shifting = 0, s.scheme.dissipation = 0;
    PorousState<2> state;
    s.porous->evaluate(s.water.x, state);
    for (std::size_t i = 0; i < s.water.size(); ++i)
        s.water.u[i] = s.water.uOld[i] = {1 / state.porosity[i], along};
    return s;
}

/// Largest changes of both in 50 ms, in which particles go two spacings in clear water and five in
/// the pores.
struct Change {
    Real through = 0, along = 0;
};
Change changeOf(Real along)
{
    Scene<2> s = flowThroughStrip(along);
    Change change;
    advance<2>(s, 1e-3, 50, [&](int, const StepFields<2>& fields) {
        for (std::size_t i = 0; i < s.water.size(); ++i) {
            change.through =
                std::max(change.through, std::abs(fields.soil.porosity[i] * s.water.u[i][0] - 1));
            change.along = std::max(change.along, std::abs(s.water.u[i][1] - along));
        }
    });
    return change;
}

TEST(FaceCarry, AUniformFlowThroughAFaceWithoutResistanceIsExact)
{
    // Kernels of pairs and the matrix are in single precision, 6e-8, and the pressure falls by 3.4
    // v^2. Were u carried, 0.24.
    const Change change = changeOf(0);
    EXPECT_LT(change.through, 1e-5);
    EXPECT_LT(change.along, 1e-5);
}

TEST(FaceCarry, AlongAFaceWaterKeepsItsPoreVelocity)
{
    // The Darcy velocity along the face is another in each depth; its divergence, zero, is that of
    // an uneven packing.
    const Change change = changeOf(0.3);
    EXPECT_LT(change.through, 0.01);
    EXPECT_LT(change.along, 0.01);
}

TEST(FaceCarry, TheDarcyVelocityOfARestartIsThatOfItsPorosity)
{
    // Without shifting particles stay where the step found their velocities.
    Scene<2> s = flowThroughStrip(0);
    advance<2>(s, 1e-3, 3);
    ASSERT_EQ(s.water.porosity.size(), s.water.size());
    PorousState<2> before;
    s.porous->evaluate(s.water.x, before);
    EXPECT_EQ(s.water.porosity, before.porosity);
    EXPECT_NE(s.water.porosityOld, before.porosity);
}

}  // namespace
