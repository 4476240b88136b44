// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/PackingPush.hpp"

namespace isph {

namespace {

constexpr Real evenness = 0.3;  // e: orders the particles
constexpr Real stiffness = 4;   // K: evens out the kernel sum where the spacing varies

/// What is within the support of a particle, side by side for vector instructions.
struct Near {
    std::vector<Real> x, y, z, distanceSqr, h, volume, excess;

    void resize(std::size_t n)
    {
        for (auto* v : {&x, &y, &z, &distanceSqr, &h, &volume, &excess}) v->resize(n);
    }
};

/// Fills `within` with what is within the support of i; how many that are.
std::size_t gather(const PackingSource& i, const std::vector<PackingSource>& sources,
                   const std::vector<Index>& near, Near& within)
{
    within.resize(near.size());
    std::size_t count = 0;
    for (Index k : near) {
        const PackingSource& j = sources[k];
        const bool outside = j.spacing == PackingSource::ofTheOther;
        const Real h = 0.5 * packingSmoothing * (i.spacing + (outside ? i.spacing : j.spacing));
        const Point r = j.x - i.x;
        const Real r2 = normSqr(r);
        within.x[count] = r[0], within.y[count] = r[1], within.z[count] = r[2];
        within.distanceSqr[count] = r2;
        within.h[count] = h;
        within.volume[count] = j.volume;
        within.excess[count] = outside ? i.excess : j.excess;
        count += r2 < 4 * h * h;
    }
    return count;
}

/// The sums over `within` without the kernel's factors.
template <int Dim>
PackingPush sumOver(const Near& within, std::size_t count, Real excess)
{
    Real x = 0, y = 0, z = 0, sum = 0;
#pragma omp simd reduction(+ : x, y, z, sum)
    for (std::size_t a = 0; a < count; ++a) {
        const Real inverse = 1 / within.h[a];
        const Real q = std::sqrt(within.distanceSqr[a]) * inverse, t = 1 - 0.5 * q;
        const Real w = within.volume[a] * (Dim == 2 ? 1 : inverse) * sqr(inverse) * cube(t);
        const Real f = w * sqr(inverse) * (evenness + stiffness * (excess + within.excess[a]));
        sum += w * t * (1 + 2 * q);
        x += f * within.x[a];
        y += f * within.y[a];
        z += f * within.z[a];
    }
    return {{{x, y, z}}, sum};
}

}  // namespace

PackingPush pushOn(std::size_t i, const std::vector<PackingSource>& sources,
                   const std::vector<Index>& near, const PackingKernel& kernel)
{
    thread_local Near within;
    const PackingSource& own = sources[i];
    const std::size_t count = gather(own, sources, near, within);
    PackingPush push = kernel.dimension == 2 ? sumOver<2>(within, count, own.excess)
                                             : sumOver<3>(within, count, own.excess);
    const Real h = packingSmoothing * own.spacing;
    push.by *= -5 * kernel.sigma() * sqr(h);
    push.excess = own.volume * kernel.w(0, h) + kernel.sigma() * push.excess;
    return push;
}

}  // namespace isph
