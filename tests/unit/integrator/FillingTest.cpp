// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include "integrator/Filling.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Mean surplus of water in soil that fills a periodic box evenly, its particles shaken by so many spacings.
Real meanSurplus(Real shaken, bool asDisorder)
{
    constexpr Real d0 = 0.01, L = 24 * d0;   // of porosity 1/4: a lattice of 12 x 12
    Scene<2> s = SceneBuilder<2>(d0).force({}).waterCells({0, 0}, {L, L}, {12, 12}).shakeWater(shaken)
        .soil({0, 0}, {L, L}, "porousModel darcy; darcyCoeffs { porosity 0.25; K 1e-9; }")
        .periodic({0, 0}, {L, L}, {true, true}).build();
    Timers timers;
    DragImplicitStep<2> step(s, timers);
    step.look();
    const StepFields<2>& fields = step.fields();
    const LatticeSums lattice{latticeSum(*s.kernel, 2, 1.5), latticeSupport(*s.kernel, 2, 1.5)};
    LargeArray<Real> surplus;
    const std::vector<Real> resistance(fields.points.fluid, 0);
    if (asDisorder) fillingSurplus(fields, WaterInSoil<2>{1, fields.soil, resistance, d0}, lattice, surplus);
    else fillingSurplus(fields, ClearWater<2>{1}, lattice, surplus);
    return orderedSum(s.water.size(), [&](Index i) { return surplus[i]; }) / static_cast<Real>(s.water.size());
}

TEST(Filling, ALatticeHasNoSurplus)
{
    EXPECT_NEAR(meanSurplus(0, false), 0, 1e-6);   // kernels of pairs are in single precision
    EXPECT_NEAR(meanSurplus(0, true), 0, 1e-6);
}

TEST(Filling, DisorderInSoilIsHardlyTakenForASurplus)
{
    // A shaken packing fills as much space as the lattice that it was. Sums at its own particles find more, for each
    // has itself at the centre.
    const Real seen = meanSurplus(0.4, false);
    EXPECT_GT(seen, 0.005);
    EXPECT_LT(std::abs(meanSurplus(0.4, true)), 0.5 * seen);
}

}  // namespace
