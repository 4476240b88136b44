// SPDX-License-Identifier: GPL-3.0-or-later
// Work arrays are kept: a solve of a size seen before takes no memory of that size.
#include "SolverTesting.hpp"

#include "pressure/Components.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> largestRequest{0};
}

void* operator new(std::size_t size)
{
    std::size_t seen = largestRequest.load();
    while (size > seen && !largestRequest.compare_exchange_weak(seen, size)) {
    }
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

using namespace isph;
using namespace isph::test;

TEST(WorkArrays, AreKeptBetweenSolvesOfTheSameSize)
{
    const ParticleSystem s = particleSystem(Scene(60, 50));
    ComponentFinder finder;
    for (const std::string solver : {"solver PCG;", "solver PCG; preconditioner Jacobi;",
                                     "solver lagCholmod;", "solver cholmod;",
                                     "solver multigridPCG;"}) {
        const auto model = solverOf(solver);
        std::vector<Real> x(s.b.size(), 0);
        model->solve(s.matrix, s.b, x);
        finder.find(s.matrix, s.anchored);
        std::fill(x.begin(), x.end(), 0);
        largestRequest = 0;
        model->solve(s.matrix, s.b, x);
        finder.find(s.matrix, s.anchored);
        EXPECT_LT(largestRequest.load(), s.b.size()) << solver;  // bytes: below one per row
    }
}
