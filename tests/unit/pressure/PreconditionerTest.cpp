// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverTesting.hpp"

#include "pressure/solvers/CholmodFactor.hpp"
#include "pressure/solvers/IncompleteCholesky.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace {
std::vector<Real> noise(std::size_t n, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<Real> value(-1, 1);
    std::vector<Real> v(n);
    for (Real& entry : v) entry = value(random);
    return v;
}

Real dot(const std::vector<Real>& a, const std::vector<Real>& b)
{
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// u . M^-1 v = v . M^-1 u  and  u . M^-1 u > 0
void expectSymmetricAndPositive(Preconditioner& m, std::size_t n)
{
    const std::vector<Real> u = noise(n, 3), v = noise(n, 4);
    std::vector<Real> mu(n), mv(n);
    m.apply(u, mu);
    m.apply(v, mv);
    // two sums of n products, equal up to their rounding
    EXPECT_NEAR(dot(u, mv), dot(v, mu), 1e-13 * norm(u) * norm(mv));
    EXPECT_GT(dot(u, mu), 0);
    EXPECT_GT(dot(v, mv), 0);
}
}  // namespace

TEST(IncompleteCholesky, IsSymmetricAndPositiveWithOneStartAndWithTwo)
{
    for (const int rows : {20, 90})  // 90 x 60 particles are split, 20 x 60 are not
        for (const Real relaxation : {0.0, 0.97}) {
            const ParticleSystem s = particleSystem(Scene(60, rows));
            IncompleteCholesky m(relaxation);
            EXPECT_EQ(m.factorise(s.matrix), 0.0);
            expectSymmetricAndPositive(m, s.b.size());
        }
}

TEST(IncompleteCholesky, IsTheInverseWhereTheFactorHasNoFill)
{
    for (const std::size_t n : {1u, 7u, 2500u}) {  // a chain has none, also from both ends
        const SymmetricMatrix a = chain(n);
        IncompleteCholesky m(0);
        ASSERT_EQ(m.factorise(a), 0.0);
        const std::vector<Real> x(n, 1);
        std::vector<Real> b(n), z(n);
        multiply(a, x, b);
        m.apply(b, z);
        // L in single precision, 6e-8 a coefficient, amplified by at most the condition n^2
        const auto size = static_cast<Real>(n);
        for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(z[i], x[i], 6e-8 * (1 + sqr(size)));
    }
}

TEST(IncompleteCholesky, ModifiedInFullKeepsTheRowSums)
{
    const ParticleSystem s = particleSystem(Scene(60, 90));
    const std::vector<Real> ones(s.b.size(), 1);
    std::vector<Real> rowSum(s.b.size()), z(s.b.size());
    multiply(s.matrix, ones, rowSum);
    IncompleteCholesky m(1);
    ASSERT_EQ(m.factorise(s.matrix), 0.0);
    m.apply(rowSum, z);  // M 1 = A 1, so M^-1 A 1 = 1
    for (const Real value : z)
        ASSERT_NEAR(value, 1, 1e-3);  // single precision times the condition, about 1e4
    IncompleteCholesky plain(0);
    plain.factorise(s.matrix);
    plain.apply(rowSum, z);
    EXPECT_LT(*std::min_element(z.begin(), z.end()), 0.9);  // the plain factor does not
}

TEST(IncompleteCholesky, ShiftsTheDiagonalWhereAPivotIsNegativeAndTheSolverSaysSo)
{
    // positive definite, but its factor without fill has a negative pivot (Kershaw 1978, J. Comput.
    // Phys. 26, 43)
    const SymmetricMatrix a =
        fromDense({{3, -2, 0, 2}, {-2, 3, -2, 0}, {0, -2, 3, -2}, {2, 0, -2, 3}});
    IncompleteCholesky m(0);
    const auto shift = m.factorise(a);
    ASSERT_TRUE(shift);
    EXPECT_GT(*shift, 0);
    expectSymmetricAndPositive(m, 4);
    std::vector<Real> x(4, 0);
    const std::vector<Real> b{1, 2, -1, 4};
    const SolverReport report =
        solverOf("solver PCG; preconditioner IC0; tolerance 1e-10;")->solve(a, b, x);
    EXPECT_TRUE(report.converged);
    EXPECT_NE(report.remark.find("diagonal shift"), std::string::npos);
}

TEST(IncompleteCholesky, FindsNoShiftForADiagonalThatIsNotPositive)
{
    EXPECT_FALSE(IncompleteCholesky(0).factorise(fromDense({{1, -1}, {-1, 0}})));
}

TEST(IncompleteCholesky, ServesMatricesOfChangingSizeInTurn)
{
    IncompleteCholesky m(0.97);
    for (const int rows : {60, 20, 90, 2, 60}) {
        const ParticleSystem s = particleSystem(Scene(60, rows));
        IncompleteCholesky fresh(0.97);
        ASSERT_EQ(m.factorise(s.matrix), 0.0);
        fresh.factorise(s.matrix);
        std::vector<Real> kept(s.b.size()), expected(s.b.size());
        m.apply(s.b, kept);
        fresh.apply(s.b, expected);
        EXPECT_EQ(kept, expected);
    }
}

TEST(CholmodFactor, IsSymmetricAndPositive)
{
    const ParticleSystem s = particleSystem(Scene(60, 50));
    CholmodFactor m;
    ASSERT_TRUE(m.factorise(s.matrix));
    expectSymmetricAndPositive(m, s.b.size());
}
