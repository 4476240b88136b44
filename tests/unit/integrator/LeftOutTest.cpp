// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene does not need is not allocated: the arrays of particle length, counted.
#include "../SceneBuilder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>
#include <new>

namespace {

/// Live allocations by address, while `counts`. Plain storage: the hooks must not allocate through
/// themselves.
template <class T>
struct Mallocator {
    using value_type = T;
    Mallocator() = default;
    template <class U>
    Mallocator(const Mallocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(std::malloc(n * sizeof(T))); }
    void deallocate(T* p, std::size_t) { std::free(p); }
    template <class U>
    bool operator==(const Mallocator<U>&) const { return true; }
};
using Live =
    std::map<void*, std::size_t, std::less<>, Mallocator<std::pair<void* const, std::size_t>>>;
Live& live()
{
    static Live* const all = new (std::malloc(sizeof(Live))) Live;
    return *all;
}
std::mutex guard;
bool counts = false;

void* take(std::size_t size)
{
    void* const p = std::malloc(size ? size : 1);
    if (!p) throw std::bad_alloc();
    if (counts) {
        const std::scoped_lock lock(guard);
        live()[p] = size;
    }
    return p;
}
void give(void* p)
{
    if (counts && p) {
        const std::scoped_lock lock(guard);
        live().erase(p);
    }
    std::free(p);
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void operator delete(void* p) noexcept { give(p); }
void operator delete(void* p, std::size_t) noexcept { give(p); }

using namespace isph;

namespace {

/// Live blocks of whole bytes a particle, by that number, after a few steps of a tank: 37 x 23, so
/// that the rows are not as many, and more wall than water, so that arrays over both have no room
/// to spare.
template <int Dim>
std::map<std::size_t, int> arraysOf(const std::function<void(SceneBuilder<Dim>&)>& more = {})
{
    const Real d0 = 0.01;
    Vec<Dim> low, high, top;
    for (int d = 0; d < Dim; ++d) high[d] = top[d] = (Dim == 2 ? 37 : 11) * d0;
    high[Dim - 1] = (Dim == 2 ? 23 : 13) * d0, top[Dim - 1] = (Dim == 2 ? 90 : 20) * d0;
    SceneBuilder<Dim> builder(d0);
    builder.water(low, high).openTank(low, top);
    if (more) more(builder);
    counts = true;
    std::map<std::size_t, int> arrays;
    {
        Scene<Dim> scene = builder.build();
        const std::size_t n = scene.water.size();
        {
            std::vector<Index> order(n);
            for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<Index>(i);
            scene.water.reorder(order);   // into arrays without room to spare
        }
        Timers timers;
        DragImplicitStep<Dim> step(scene, timers);
        step.look();
        for (int k = 0; k < 3; ++k) step.advance(1e-3, k > 0 ? 1e-3 : 0);
        for (const auto& [p, size] : live())
            if (size % n == 0) ++arrays[size / n];
    }
    counts = false;
    live().clear();
    return arrays;
}

using Arrays = std::map<std::size_t, int>;

TEST(LeftOut, TheArraysOfClearWaterAreThese)
{
    const Arrays expected{
        {1, 1},  // role
        {4, 2},  // row of the pressure equation; place among the corrections of few particles
        // p [Pa], id; porosity (1), p/rho, filling, lambda, lambda of water alone,
        // divergence wanted
        {8, 8},
        // x, u, uOld, (grad p)/rho - g and the mean of the past ones; v, lopsided; the row of the
        // pair list: where its pairs stand
        {16, 8},
        {24, 1},  // L: symmetric, three numbers; L of water alone and L A of few particles
    };
    EXPECT_EQ(arraysOf<2>(), expected);
}

TEST(LeftOut, InTwoDimensionsNothingHasAZ)
{
    // Vectors have 16 and 24 bytes, symmetric matrices 24 and 48; a row of the pair list has 16 in
    // both.
    const Arrays flat = arraysOf<2>(), deep = arraysOf<3>();
    EXPECT_EQ(flat.at(16), deep.at(24) + 1);
    EXPECT_EQ(flat.at(24), deep.at(48));
    EXPECT_FALSE(flat.contains(48));
    EXPECT_EQ(deep.at(8), flat.at(8));
}

TEST(LeftOut, SoilBringsItsArraysWithIt)
{
    // In a corner that no water reaches: share, depth, sharp porosity, a, b, mobility, inertia,
    // resistance, viscosity of the filter, the porosities of u and uOld; normal and extrapolated
    // velocity; velocity gradient.
    const Arrays clear = arraysOf<2>(),
                 wet = arraysOf<2>([](SceneBuilder<2>&builder) {
                     builder.soil({0.3, 0.8}, {0.37, 0.85},
                                  "porousModel akbari; akbariCoeffs { porosity 0.4; D50 0.01; }");
                 });
    EXPECT_EQ(wet.at(8), clear.at(8) + 11);
    EXPECT_EQ(wet.at(16), clear.at(16) + 2);
    EXPECT_EQ(wet.at(24), clear.at(24));
}

}  // namespace
