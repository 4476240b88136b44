// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverTesting.hpp"

#include "core/Parallel.hpp"
#include "pressure/Components.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

using namespace isph;
using namespace isph::test;

namespace {
/// Components without an anchor by repeated relabelling, the slow and plain way.
std::set<std::set<Index>> floatingByRelabelling(const SymmetricMatrix& a,
                                                const std::vector<char>& anchored)
{
    const std::size_t n = a.size();
    std::vector<Index> label(n);
    std::iota(label.begin(), label.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < n; ++i)
            for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k)
                if (a.offDiagonal[k] != 0 && label[a.column[k]] < label[i])
                    label[i] = label[a.column[k]], changed = true;
    }
    std::vector<std::set<Index>> rows(n);
    std::vector<char> held(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        rows[label[i]].insert(static_cast<Index>(i));
        if (anchored[i]) held[label[i]] = 1;
    }
    std::set<std::set<Index>> floating;
    for (std::size_t i = 0; i < n; ++i)
        if (!rows[i].empty() && !held[i]) floating.insert(rows[i]);
    return floating;
}

std::set<std::set<Index>> asSets(const FloatingComponents& floating)
{
    std::set<std::set<Index>> all;
    for (std::size_t c = 0; c < floating.size(); ++c) {
        const std::set<Index> rows(floating[c].begin(), floating[c].end());
        EXPECT_EQ(rows.size(), floating[c].size()) << "a row is listed twice";
        EXPECT_EQ(*rows.begin(), floating[c].front()) << "the lowest row is not the first";
        all.insert(rows);
    }
    return all;
}

/// Two floating blocks, one isolated particle, and a tank with a surface.
ParticleSystem splash()
{
    Scene scene(40, 30);
    scene.present = [](int ix, int iy) {
        const bool tank = iy < 8, left = ix < 10 && iy > 14,
                   right = ix > 20 && ix < 34 && iy > 12 && iy < 22;
        return tank || left || right || (ix == 37 && iy == 26);
    };
    scene.atmosphere = [](int, int iy) { return iy == 7; };
    return particleSystem(scene);
}
}  // namespace

TEST(ComponentFinder, FindsNoneWhereEveryPartHasAFreeSurface)
{
    const ParticleSystem s = particleSystem(Scene(40, 30));
    ComponentFinder finder;
    EXPECT_EQ(finder.find(s.matrix, s.anchored).size(), 0u);
}

TEST(ComponentFinder, FindsWhatRelabellingFinds)
{
    ComponentFinder finder;
    const ParticleSystem s = splash();
    const auto found = asSets(finder.find(s.matrix, s.anchored));
    EXPECT_EQ(found.size(), 3u);
    EXPECT_EQ(found, floatingByRelabelling(s.matrix, s.anchored));
    for (unsigned seed = 1; seed <= 5; ++seed) {  // spray: many small parts
        Scene scene(40, 30);
        std::mt19937 random(seed);
        std::vector<char> there(40 * 30);
        for (char& t : there) t = random() % 10 < 1 + seed;
        scene.present = [&](int ix, int iy) { return there[iy * 40 + ix] != 0; };
        const ParticleSystem spray = particleSystem(scene);
        EXPECT_EQ(asSets(finder.find(spray.matrix, spray.anchored)),
                  floatingByRelabelling(spray.matrix, spray.anchored));
    }
}

TEST(ComponentFinder, FindsTheSameWithAnyNumberOfThreads)
{
    // a tank whose surface stands at one end of the rows, drops above it: runs of rows hold
    // no anchor
    Scene scene(120, 100);
    std::mt19937 random(7);
    std::vector<char> there(120 * 100);
    for (char& t : there) t = random() % 100 < 4;
    scene.present = [&](int ix, int iy) { return iy < 80 || there[iy * 120 + ix] != 0; };
    scene.atmosphere = [](int ix, int iy) { return iy == 0 && ix == 0; };
    const ParticleSystem s = particleSystem(scene);
    ASSERT_GT(s.matrix.size(), 8192u) << "fewer rows are swept by one thread";
    const int before = threadCount();
    for (const int threads : {1, 2, 5}) {
        setThreadCount(threads);
        ComponentFinder finder;
        const FloatingComponents& found = finder.find(s.matrix, s.anchored);
        EXPECT_GT(found.size(), 10u);
        EXPECT_EQ(asSets(found), floatingByRelabelling(s.matrix, s.anchored)) << threads;
    }
    setThreadCount(before);
}

TEST(ComponentFinder, FollowsAWindingChannelThatNoSweepFollows)
{
    // one chain in an order that goes up and down at every link: the flood fill must take over
    const std::size_t n = 200;
    std::vector<std::vector<Real>> dense(n, std::vector<Real>(n, 0));
    const auto row = [&](std::size_t link) { return link % 2 ? n - 1 - link / 2 : link / 2; };
    for (std::size_t link = 0; link + 1 < n; ++link)
        dense[row(link)][row(link + 1)] = dense[row(link + 1)][row(link)] = -1;
    for (std::size_t i = 0; i < n; ++i) dense[i][i] = 2;
    const SymmetricMatrix a = fromDense(dense);
    ComponentFinder finder;
    std::vector<char> anchored(n, 0);
    EXPECT_EQ(finder.find(a, anchored).size(), 1u);
    anchored[row(0)] = 1;
    EXPECT_EQ(finder.find(a, anchored).size(), 0u);
}

TEST(ComponentFinder, CoefficientsOfZeroConnectNothing)
{
    SymmetricMatrix a = chain(6);
    std::vector<char> anchored(6, 0);
    anchored[0] = 1;
    ComponentFinder finder;
    EXPECT_EQ(finder.find(a, anchored).size(), 0u);
    a.offDiagonal[a.rowStart[2] + 1] = a.offDiagonal[a.rowStart[3]] = 0;  // between rows 2 and 3
    EXPECT_EQ(asSets(finder.find(a, anchored)), (std::set<std::set<Index>>{{3, 4, 5}}));
}

TEST(StartAtZero, MakesThePressureOfTheLastStepTheSolutionWhereNothingChanged)
{
    ParticleSystem s = splash();
    ComponentFinder finder;
    const FloatingComponents& floating = finder.find(s.matrix, s.anchored);
    ASSERT_GT(floating.size(), 0u);
    makeSolvable(s.matrix, s.b, floating);
    std::vector<Real> x(s.b.size(), 0);
    ASSERT_TRUE(solverOf("solver cholmod; tolerance 1e-12;")->solve(s.matrix, s.b, x).converged);
    removeMean(x, floating);   // as a step leaves it
    startAtZero(x, floating);
    EXPECT_LE(trueResidual(s.matrix, x, s.b), 4e-12 * norm(s.b));
}

TEST(MakeSolvable, TheSolutionSolvesTheSingularSystemAndIsZeroInTheFirstRow)
{
    ParticleSystem s = splash();
    const SymmetricMatrix singular = s.matrix;
    ComponentFinder finder;
    const FloatingComponents& floating = finder.find(s.matrix, s.anchored);
    makeSolvable(s.matrix, s.b, floating);
    for (std::size_t c = 0; c < floating.size(); ++c) {
        Real sum = 0;
        for (const Index i : floating[c]) sum += s.b[i];
        EXPECT_NEAR(sum, 0,
                    1e-16 * sqr(static_cast<Real>(floating[c].size())));  // round-off x rows
    }
    std::vector<Real> x(s.b.size(), 0);
    ASSERT_TRUE(solverOf("solver cholmod; tolerance 1e-12;")->solve(s.matrix, s.b, x).converged);
    EXPECT_LE(trueResidual(singular, x, s.b),
              2e-12 * norm(s.b));  // that of the changed matrix and a_00 x_0
    for (std::size_t c = 0; c < floating.size(); ++c)
        EXPECT_NEAR(x[floating[c].front()], 0, 1e-11 * norm(s.b));
    removeMean(x, floating);
    EXPECT_LE(trueResidual(singular, x, s.b),
              2e-12 * norm(s.b));  // constants are in the null space
    for (std::size_t c = 0; c < floating.size(); ++c) {
        Real sum = 0, largest = 0;
        for (const Index i : floating[c]) sum += x[i], largest = std::max(largest, std::abs(x[i]));
        EXPECT_NEAR(sum, 0, 1e-15 * largest * sqr(static_cast<Real>(floating[c].size())));
    }
}

TEST(MakeSolvable, LeavesPartsWithAFreeSurfaceAsTheyAre)
{
    ParticleSystem s = splash();
    const ParticleSystem before = s;
    ComponentFinder finder;
    const FloatingComponents& floating = finder.find(s.matrix, s.anchored);
    makeSolvable(s.matrix, s.b, floating);
    const std::set<Index> changed(floating.row.begin(), floating.row.end());
    for (std::size_t i = 0; i < s.b.size(); ++i) {
        if (changed.count(static_cast<Index>(i))) continue;
        EXPECT_EQ(s.b[i], before.b[i]);
        EXPECT_EQ(s.matrix.diagonal[i], before.matrix.diagonal[i]);
    }
    EXPECT_EQ(s.matrix.offDiagonal, before.matrix.offDiagonal);
}

TEST(MakeSolvable, GivesAnIsolatedParticleThePressureZero)
{
    SymmetricMatrix a;
    a.diagonal = {0};
    a.rowStart = {0, 0};
    std::vector<Real> b{4}, x{7};
    ComponentFinder finder;
    const std::vector<char> anchored{0};
    makeSolvable(a, b, finder.find(a, anchored));
    EXPECT_TRUE(solverOf("solver PCG;")->solve(a, b, x).converged);
    EXPECT_EQ(x[0], 0);
}
