// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverTesting.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

TEST(SymmetricMatrix, TimesAVectorIsWhatTheDenseMatrixGives)
{
    const std::vector<std::vector<Real>> dense{
        {4, -1, 0, -2}, {-1, 3, -1, 0}, {0, -1, 5, -3}, {-2, 0, -3, 7}};
    const std::vector<Real> x{1, -2, 3, 0.5};
    std::vector<Real> y(4), withDot(4);
    const SymmetricMatrix a = fromDense(dense);
    multiply(a, x, y);
    const Real dot = multiplyAndDot(a, x, withDot);
    Real expected = 0;
    for (int i = 0; i < 4; ++i) {
        Real row = 0;
        for (int j = 0; j < 4; ++j) row += dense[i][j] * x[j];
        EXPECT_EQ(y[i], row);  // small integers and halves: exact
        EXPECT_EQ(withDot[i], row);
        expected += x[i] * row;
    }
    EXPECT_EQ(dot, expected);
}

TEST(SymmetricMatrix, ResidualNormIsThatOfExtendedPrecision)
{
    const ParticleSystem s = particleSystem(Scene(60, 50));
    const std::vector<Real> x(s.b.rbegin(), s.b.rend());
    std::vector<Real> r(x.size());
    const Real expected = trueResidual(s.matrix, x, s.b);
    // 3000 rows of about 20 terms in double: a few hundred roundings at the very worst
    EXPECT_NEAR(residualNorm(s.matrix, x, s.b) / expected, 1, 1e-13);
    EXPECT_EQ(residual(s.matrix, x, s.b, r), residualNorm(s.matrix, x, s.b));
    EXPECT_NEAR(norm(r) / expected, 1, 1e-13);
}

TEST(SymmetricMatrix, OneAndThreeThreadsAgreeBitForBit)
{
    const ParticleSystem s = particleSystem(Scene(90, 80));
    std::vector<Real> one(s.b.size()), three(s.b.size());
    Real dotOne, dotThree, normOne, normThree;
    {
        const Threads threads(1);
        dotOne = multiplyAndDot(s.matrix, s.b, one);
        normOne = residualNorm(s.matrix, one, s.b);
    }
    {
        const Threads threads(3);
        dotThree = multiplyAndDot(s.matrix, s.b, three);
        normThree = residualNorm(s.matrix, three, s.b);
    }
    EXPECT_EQ(one, three);
    EXPECT_EQ(dotOne, dotThree);
    EXPECT_EQ(normOne, normThree);
}

TEST(ParticleMatrix, TheMatricesOfTheseTestsAreSymmetricWithAscendingColumns)
{
    Scene scene(25, 20);
    scene.beta = [](int ix, int) { return ix < 10 ? 1.0 : 1e4; };
    const SymmetricMatrix a = particleSystem(scene).matrix;
    std::vector<std::vector<Real>> dense(a.size(), std::vector<Real>(a.size(), 0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) {
            EXPECT_TRUE(k == a.rowStart[i] || a.column[k - 1] < a.column[k]);
            dense[i][a.column[k]] = a.offDiagonal[k];
        }
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(dense[i][j], dense[j][i]);
}
