// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/FreeSurface.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace isph {

namespace {
// Of what is above a particle beyond the mean; with all of it the first row turns over.
constexpr Real kCarried = 0.25;
constexpr Real kLeastThickening = 0.7, kMostThickening = 1.4;   // of the rise: narrow supports
}

template <int Dim>
void findFreeSurface(const Points<Dim>& points, const PairList<Dim>& pairs,
                     const Corrections<Dim>& corrections, std::vector<SurfaceRole>& role)
{
    role.resize(points.fluid);
    const auto atSurface = [&](Index j) { return corrections.lambda[j] < surfaceThreshold<Dim>(); };
    parallelFor(points.water, [&](Index i) {
        role[i] = atSurface(i) ? SurfaceRole::surface : SurfaceRole::inner;
    });
    // The few rows of surface particles name all that are near them; whoever writes writes the
    // same.
    parallelForDynamic(points.water, [&](Index i) {
        if (!atSurface(i)) return;
        pairs.forWater(i, [&](const auto& pair) {
            if (atSurface(pair.j)) return;
            const std::atomic_ref partner(role[points.owner[pair.j]]);
            partner.store(SurfaceRole::near, std::memory_order_relaxed);
        });
    });
    points.refresh(role);
}

FlatSurface latticeSurface(const Kernel& kernel, int dimension, Real hOverSpacing)
{
    constexpr Real step = 0.1;  // of a spacing: how far a particle is moved to see lambda change
    constexpr Real strain = 0.01;   // by which rows are stretched
    const Real reach = kernel.supportRadius() * hOverSpacing / (1 - strain);
    const int m = static_cast<int>(std::ceil(reach)) + 1;
    const int mz = dimension == 3 ? m : 0;
    const Real scale = kernel.normalisation(dimension) / std::pow(hOverSpacing, dimension);
    const auto lambda = [&](Real depth, Real along) {
        Real sum = 0;
        for (int a = -m; a <= m; ++a)
            for (int b = -m; b <= 0; ++b)
                for (int c = -mz; c <= mz; ++c) {
                    if (a == 0 && b == 0 && c == 0) continue;   // its own place
                    const Real r = std::sqrt(sqr(a * along) + sqr(b / along + depth) + c * c);
                    const Real q = r / hOverSpacing;
                    Real w = 0, slope = 0;
                    kernel.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1),
                                    Span<Real>(&slope, 1));
                    sum -= slope * sqr(q);
                }
        return sum * scale;
    };
    const Real flat = lambda(0, 1), rise = (lambda(step, 1) - flat) / step;
    // Half a spacing above the centres grows by half the strain.
    const Real thickening = (lambda(0, 1 - strain) - lambda(0, 1 + strain)) / strain;
    return {flat, rise, std::clamp(thickening, kLeastThickening * rise, kMostThickening * rise)};
}

template <int Dim>
void surfacePressure(const FlatSurface& surface, Real spacingOverH, const Points<Dim>& points,
                     const PairList<Dim>& pairs, const Corrections<Dim>& corrections,
                     const std::vector<SurfaceRole>& role, Span<const Vec<Dim>> forceGradient,
                     const Vec<Dim>& force, std::vector<Real>& p)
{
    const auto depthOf = [&](Index i) { return corrections.lambda[i] - surface.lambda; };
    const auto inwardsOf = [&](Index i) {
        return -dot(forceGradient[i] + force, unit(corrections.lopsided[i]));
    };
    p.resize(points.fluid);
    parallelForDynamic(points.water, [&](Index i) {
        p[i] = 0;
        if (role[i] != SurfaceRole::surface) return;
        Real weight = pairs.selfW(i);
        Real meanDepth = weight * depthOf(i), meanInwards = weight * inwardsOf(i);
        pairs.forWater(i, [&](const auto& pair) {
            if (role[pair.j] != SurfaceRole::surface) return;
            const Index owner = points.owner[pair.j];
            weight += pair.W;
            meanDepth += pair.W * depthOf(owner), meanInwards += pair.W * inwardsOf(owner);
        });
        meanDepth /= weight, meanInwards /= weight;
        const Real rough = kCarried * (depthOf(i) - meanDepth) / surface.rise;
        const Real above = Real(0.5) + meanDepth / surface.thickening + rough;
        p[i] = std::max(Real(0), above) * spacingOverH * points.h[i] * meanInwards;
    });
}

template void findFreeSurface(const Points<2>&, const PairList<2>&, const Corrections<2>&,
                              std::vector<SurfaceRole>&);
template void findFreeSurface(const Points<3>&, const PairList<3>&, const Corrections<3>&,
                              std::vector<SurfaceRole>&);
template void surfacePressure(const FlatSurface&, Real, const Points<2>&, const PairList<2>&,
                              const Corrections<2>&, const std::vector<SurfaceRole>&,
                              Span<const Vec<2>>, const Vec<2>&, std::vector<Real>&);
template void surfacePressure(const FlatSurface&, Real, const Points<3>&, const PairList<3>&,
                              const Corrections<3>&, const std::vector<SurfaceRole>&,
                              Span<const Vec<3>>, const Vec<3>&, std::vector<Real>&);

}  // namespace isph
