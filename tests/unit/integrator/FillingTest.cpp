// SPDX-License-Identifier: GPL-3.0-or-later
#include "../SceneBuilder.hpp"

#include "integrator/Filling.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace {

/// Soil that water fills evenly in a periodic box, its particles shaken by so many spacings.
class EvenSoil {
public:
    explicit EvenSoil(Real shaken)
        : scene_(
              SceneBuilder<2>(d0)
                  .force({})
                  .waterCells({0, 0}, {L, L}, {12, 12})
                  .shakeWater(shaken)
                  .soil({0, 0}, {L, L}, "porousModel darcy; darcyCoeffs { porosity 0.25; K 1e-9; }")
                  .periodic({0, 0}, {L, L}, {true, true})
                  .build()),
          step_(scene_, timers_)
    {
        step_.look();
    }
    /// Of every particle.
    LargeArray<Real> surplus(bool asDisorder, Real ownShare = 1)
    {
        const StepFields<2>& fields = step_.fields();
        const LatticeSums lattice{latticeSum(*scene_.kernel, 2, 1.5),
                                  latticeSupport(*scene_.kernel, 2, 1.5)};
        const std::vector<Real> resistance(fields.points.fluid, 0);
        LargeArray<Real> surplus;
        if (asDisorder)
            fillingSurplus(fields, WaterInSoil<2>{1, fields.soil, resistance, d0}, lattice,
                           ownShare, surplus);
        else fillingSurplus(fields, ClearWater<2>{1}, lattice, ownShare, surplus);
        return surplus;
    }

private:
    static constexpr Real d0 = 0.01, L = 24 * d0;   // of porosity 1/4: a lattice of 12 x 12
    Scene<2> scene_;
    Timers timers_;
    DragImplicitStep<2> step_;
};

Real mean(const LargeArray<Real>& values)
{
    return orderedSum(values.size(), [&](Index i) { return values[i]; }) /
           static_cast<Real>(values.size());
}
Real scatter(const LargeArray<Real>& values)
{
    const Real middle = mean(values);
    return std::sqrt(orderedSum(values.size(), [&](Index i) { return sqr(values[i] - middle); }) /
                     static_cast<Real>(values.size()));
}
Real meanSurplus(Real shaken, bool asDisorder)
{
    return mean(EvenSoil(shaken).surplus(asDisorder));
}

TEST(Filling, ALatticeHasNoSurplus)
{
    EXPECT_NEAR(meanSurplus(0, false), 0, 1e-6);   // kernels of pairs are in single precision
    EXPECT_NEAR(meanSurplus(0, true), 0, 1e-6);
}

TEST(Filling, DisorderInSoilIsHardlyTakenForASurplus)
{
    // A shaken packing fills as much space as the lattice that it was. Sums at its own particles
    // find more, for each has itself at the centre.
    const Real seen = meanSurplus(0.4, false);
    EXPECT_GT(seen, 0.005);
    EXPECT_LT(std::abs(meanSurplus(0.4, true)), 0.5 * seen);
}

TEST(Filling, WhereWaterHardlyMovesInAStepItsPackingIsRepairedAsAWhole)
{
    // What a particle has more than its surroundings no pressure removes. Its kernel's mean leaves
    // the surplus of the packing as it is, but for particles that count in more means than others.
    EvenSoil soil(0.2);
    const LargeArray<Real> own = soil.surplus(true, 1), shared = soil.surplus(true, 0);
    EXPECT_LT(scatter(shared), 0.5 * scatter(own));
    EXPECT_NEAR(mean(shared), mean(own), 0.2 * scatter(own));
}

}  // namespace
