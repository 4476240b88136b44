// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayeredTank.hpp"
#include "SolverTesting.hpp"

#include "pressure/Components.hpp"
#include "pressure/solvers/Multigrid.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace isph;
using namespace isph::test;

namespace {

RowSums sumsOf(const SymmetricMatrix& a)
{
    RowSums sums;
    sums.resize(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        sums.excess[i] = a.diagonal[i], sums.largest[i] = 0;
        for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) {
            const Real a_ij = a.offDiagonal[k];
            sums.excess[i] += a_ij;
            sums.largest[i] = std::max(sums.largest[i], -a_ij);
        }
    }
    return sums;
}

Aggregation groupsOf(const SymmetricMatrix& a, Real strength)
{
    LargeArray<CellKey> keys;
    cellKeys(a.places, keys);
    Aggregation groups;
    groups.byCells(a, sumsOf(a), keys, strength);
    return groups;
}

int iterations(const LayeredTank& tank, const std::string& keys = "solver multigridPCG;")
{
    const PressureSystem s = pressureSystem(tank);
    std::vector<Real> x(s.b.size(), 0);
    const SolverReport report = solverOf(keys)->solve(s.matrix, s.b, x);
    EXPECT_TRUE(report.converged) << report.remark;
    return report.iterations;
}

constexpr LayeredTank::Layers kAllLayers[] = {LayeredTank::Layers::waterOverSoil,
                                              LayeredTank::Layers::soilOverWater,
                                              LayeredTank::Layers::column};

/// Rows that a group's first row reaches within the group by entries of that strength.
std::size_t reached(const SymmetricMatrix& a, const RowSums& sums, Span<const Index> members,
                    Real strength)
{
    const std::set<Index> inside(members.begin(), members.end());
    std::set<Index> seen{members.front()};
    std::vector<Index> open{members.front()};
    while (!open.empty()) {
        const Index i = open.back();
        open.pop_back();
        for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) {
            const Index j = a.column[k];
            const Real largest = std::max(sums.largest[i], sums.largest[j]);
            if (inside.count(j) && -a.offDiagonal[k] >= strength * largest && seen.insert(j).second)
                open.push_back(j);
        }
    }
    return seen.size();
}

}  // namespace

TEST(Aggregation, PutsEachRowIntoOneGroupOfStronglyConnectedRows)
{
    LayeredTank tank;
    tank.particles = 4000, tank.jump = 1e4;
    const SymmetricMatrix a = pressureSystem(tank).matrix;
    const RowSums sums = sumsOf(a);
    const Aggregation groups = groupsOf(a, 0.05);
    std::size_t rows = 0;
    Index lastFirst = -1;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        rows += groups[g].size();
        EXPECT_GT(groups[g].front(), lastFirst) << "groups in the order of their first rows";
        lastFirst = groups[g].front();
        EXPECT_EQ(reached(a, sums, groups[g], 0.05), groups[g].size());
        for (const Index i : groups[g]) EXPECT_EQ(groups.group[i], static_cast<Index>(g));
    }
    std::size_t out = 0;
    for (const Index g : groups.group) out += g < 0;
    EXPECT_EQ(rows + out, a.size());
    // Cells of 2 x 2 spacings hold four rows; those at layers and edges fewer.
    const Real mean = static_cast<Real>(rows) / static_cast<Real>(groups.size());
    EXPECT_GT(mean, 3);
    EXPECT_LT(mean, 5);
}

TEST(Aggregation, NeverGroupsWaterWithSoil)
{
    LayeredTank tank;
    tank.particles = 4000, tank.jump = 1e3;  // harmonic means across are 2e-3 of those in water
    const SymmetricMatrix a = pressureSystem(tank).matrix;
    const Aggregation groups = groupsOf(a, 0.05);
    const RowSums sums = sumsOf(a);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        Real least = 1e30, most = 0;
        for (const Index i : groups[g]) {
            least = std::min(least, sums.largest[i]);
            most = std::max(most, sums.largest[i]);
        }
        EXPECT_LT(most, 50 * least);
    }
}

TEST(Aggregation, LeavesLoneRowsAndThoseHeldByTheirDiagonalOut)
{
    const SymmetricMatrix a = fromDense({{10, -1, 0}, {-1, 1.5, 0}, {0, 0, 2}});
    Aggregation groups;
    groups.byNeighbours(a, sumsOf(a), 0);
    EXPECT_EQ(groups.group, (LargeArray<Index>{-1, 0, -1}));
}

TEST(CellKeys, OfCoarserCellsAreHalvedAndKeepTheirGrid)
{
    RowPlaces places;
    places.dimension = 3;
    places.coordinate = {0, 0, 0, 7, 5, 9, 0, 0, 0};
    places.spacing = {1, 1, 2};
    LargeArray<CellKey> keys, coarse;
    cellKeys(places, keys);
    places.coordinate = {0, 0, 0, 3.5, 2.5, 4.5, 0, 0, 0};  // the same rows in cells twice as large
    cellKeys(places, coarse);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(coarserKey(keys[i]), coarse[i]);
    EXPECT_NE(keys[0], keys[2]) << "cells of another spacing are others";
}

TEST(CoarseMatrix, IsTheSumOfTheEntriesBetweenGroups)
{
    LayeredTank tank;
    tank.particles = 800, tank.jump = 1e2;
    const SymmetricMatrix a = pressureSystem(tank).matrix;
    const Aggregation groups = groupsOf(a, 0.05);
    SymmetricMatrix coarse;
    RowSums sums;
    CoarseMatrixBuilder().build(a, sumsOf(a), groups, coarse, sums);
    const std::size_t n = groups.size();
    ASSERT_EQ(coarse.size(), n);
    std::vector<std::vector<Real>> sum(n, std::vector<Real>(n, 0)), built = sum;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Index g = groups.group[i];
        if (g < 0) continue;
        sum[g][g] += a.diagonal[i];
        for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k)
            if (const Index h = groups.group[a.column[k]]; h >= 0) sum[g][h] += a.offDiagonal[k];
    }
    for (std::size_t g = 0; g < n; ++g) {
        built[g][g] = coarse.diagonal[g];
        for (PairIndex k = coarse.rowStart[g]; k < coarse.rowStart[g + 1]; ++k)
            built[g][coarse.column[k]] += coarse.offDiagonal[k];
    }
    for (std::size_t g = 0; g < n; ++g) {
        const Real rounding =
            1e-13 * a.diagonal[groups[g].front()] * 8;  // some 80 terms of that size
        Real builtRow = 0, row = 0;
        for (std::size_t h = 0; h < n; ++h) {
            builtRow += built[g][h], row += sum[g][h];
            if (h == g) continue;
            const Real single = 6e-8 * std::abs(sum[g][h]);
            EXPECT_NEAR(built[g][h], sum[g][h], single + rounding) << g << ' ' << h;
        }
        EXPECT_NEAR(builtRow, row, rounding) << g << ": what ties the row to p = 0 is not rounded";
    }
}

TEST(Multigrid, IterationsHardlyGrowWithTheJumpOfTheCoefficient)
{
    for (const int dimension : {2, 3})
        for (const LayeredTank::Layers layers : kAllLayers) {
            LayeredTank tank;
            tank.dimension = dimension, tank.particles = 8000, tank.layers = layers;
            tank.jump = 1;
            const int even = iterations(tank);
            EXPECT_LE(even, 15);
            for (const Real jump : {1e2, 1e4, 1e6}) {
                tank.jump = jump;
                EXPECT_LE(iterations(tank), 1.4 * even) << dimension << "-D, jump " << jump;
            }
        }
}

TEST(Multigrid, SeesThinLayersThatCellsDoNot)
{
    const auto solve = [](Real jump) {
        Scene scene(120, 120);  // crossed layers of three particles, in no rhythm of the cells
        scene.beta = [=](int ix, int iy) { return ix % 13 < 3 || iy % 11 < 3 ? 1 / jump : 1.0; };
        const ParticleSystem s = particleSystem(scene);
        std::vector<Real> x(s.b.size(), 0);
        return solverOf("solver multigridPCG;")->solve(s.matrix, s.b, x).iterations;
    };
    EXPECT_LE(solve(1e6), 1.4 * solve(1));
}

TEST(Multigrid, IterationsHardlyGrowWithTheNumberOfRows)
{
    LayeredTank tank;
    tank.particles = 4000;
    const int few = iterations(tank);
    tank.particles = 64000;
    EXPECT_LE(iterations(tank), 1.3 * few);
}

TEST(Multigrid, SolvesWhereNoPlacesAreKnown)
{
    for (const int dimension : {2, 3})
        for (const Real jump : {1.0, 1e4}) {
            LayeredTank tank;
            tank.dimension = dimension, tank.particles = 8000, tank.jump = jump;
            tank.withPlaces = false;
            EXPECT_LE(iterations(tank), 25) << dimension << "-D, jump " << jump;
        }
}

TEST(Multigrid, GroupsAcrossNoJumpWhereParticlesStandInDisorder)
{
    LayeredTank tank;  // few neighbours are near ones: groups of near ones alone would be pairs
    tank.dimension = 3, tank.particles = 20000, tank.jump = 1e6, tank.jitter = 0.5;
    for (const bool withPlaces : {true, false}) {
        tank.withPlaces = withPlaces;
        EXPECT_LE(iterations(tank), 25) << (withPlaces ? "with places" : "without");
    }
}

TEST(Multigrid, OneTwoAndThreeThreadsAgreeBitForBit)
{
    for (const int dimension : {2, 3}) {
        LayeredTank tank;
        tank.dimension = dimension, tank.particles = 40000;  // two levels shared among threads
        const PressureSystem s = pressureSystem(tank);
        const auto run = [&](int count) {
            const Threads threads(count);
            std::vector<Real> x(s.b.size(), 0);
            solverOf("solver multigridPCG;")->solve(s.matrix, s.b, x);
            return x;
        };
        const std::vector<Real> one = run(1);
        EXPECT_EQ(one, run(2)) << dimension << "-D";
        EXPECT_EQ(one, run(3)) << dimension << "-D";
    }
}

TEST(Multigrid, SetupCostsFewEntriesBesideTheMatrix)
{
    LayeredTank tank;
    Multigrid multigrid;
    const SymmetricMatrix flat = pressureSystem(tank).matrix;
    multigrid.setUp(flat);
    EXPECT_GE(multigrid.levels(), 3u);
    EXPECT_LT(multigrid.operatorComplexity(), 1.25);  // 1.16 in 2-D, 1.07 in 3-D
    tank.dimension = 3;
    const SymmetricMatrix deep = pressureSystem(tank).matrix;
    multigrid.setUp(deep);
    EXPECT_LT(multigrid.operatorComplexity(), 1.15);
}

TEST(Multigrid, SolvesAnEnclosedFluidWhoseMatrixIsSingular)
{
    Scene scene(60, 60);  // nobody has made it solvable: b sums to zero, the level is free
    scene.atmosphere = [](int, int) { return false; };
    ParticleSystem s = particleSystem(scene);
    Real mean = 0;
    for (const Real b : s.b) mean += b / static_cast<Real>(s.b.size());
    for (Real& b : s.b) b -= mean;
    std::vector<Real> x(s.b.size(), 0);
    const SolverReport report = solverOf("solver multigridPCG;")->solve(s.matrix, s.b, x);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 20);
}

TEST(Auto, TakesTheLaggedFactorForSmall2DAndMultigridForAllElseAndSaysSo)
{
    const auto solver = solverOf("tolerance 1e-6;");  // auto is the default
    const auto solve = [&](int dimension, Real particles) {
        LayeredTank tank;
        tank.dimension = dimension, tank.particles = particles;
        const PressureSystem s = pressureSystem(tank);
        std::vector<Real> x(s.b.size(), 0);
        testing::internal::CaptureStdout();
        const std::string name = solver->solve(s.matrix, s.b, x).solver;
        return std::pair{name, testing::internal::GetCapturedStdout()};
    };
    EXPECT_EQ(
        solve(2, 500),
        (std::pair<std::string, std::string>{
            "lagCholmod", "Selecting pressure solver lagCholmod (auto: 512 unknowns in 2-D)\n"}));
    EXPECT_EQ(solve(2, 700).second, "") << "one line is enough";
    EXPECT_EQ(solve(2, 5000).first, "multigridPCG");
    EXPECT_EQ(solve(3, 500).first, "multigridPCG");
}

TEST(Hypre, KeepsItsHierarchyForTheSolvesAskedFor)
{
    const auto solver = solverOf("solver hypre; setupInterval 3;");
    for (const Real moved : {0.0, 0.02, 0.04, 0.06}) {
        LayeredTank tank;
        tank.particles = 3000, tank.moved = moved;
        const PressureSystem s = pressureSystem(tank);
        std::vector<Real> x(s.b.size(), 0);
        const SolverReport report = solver->solve(s.matrix, s.b, x);
        EXPECT_TRUE(report.converged);
        EXPECT_LE(report.iterations, 20);
    }
}
