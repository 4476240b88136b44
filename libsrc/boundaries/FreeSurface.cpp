// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/FreeSurface.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace isph {

namespace {
constexpr Real kCarried = 0.75;   // of the water above a particle; with all of it the first row turns over
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
    // The few rows of surface particles name all that are near them; whoever writes writes the same.
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
    constexpr Real step = 0.1;   // of a spacing: how far a particle is moved to see lambda change
    const int m = static_cast<int>(std::ceil(kernel.supportRadius() * hOverSpacing)) + 1;
    const int mz = dimension == 3 ? m : 0;
    const Real scale = kernel.normalisation(dimension) / std::pow(hOverSpacing, dimension);
    const auto lambda = [&](Real depth) {
        Real sum = 0;
        for (int a = -m; a <= m; ++a)
            for (int b = -m; b <= 0; ++b)
                for (int c = -mz; c <= mz; ++c) {
                    if (a == 0 && b == 0 && c == 0) continue;   // its own place
                    const Real q = std::sqrt(a * a + sqr(b + depth) + c * c) / hOverSpacing;
                    Real w = 0, slope = 0;
                    kernel.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
                    sum -= slope * sqr(q);
                }
        return sum * scale;
    };
    return {lambda(0), (lambda(step) - lambda(0)) / step};
}

template <int Dim>
void surfacePressure(const FlatSurface& surface, Real spacingOverH, const Points<Dim>& points,
                     const Corrections<Dim>& corrections, const std::vector<SurfaceRole>& role,
                     Span<const Vec<Dim>> forceGradient, const Vec<Dim>& force, std::vector<Real>& p)
{
    p.resize(points.water);
    const Real strongest = norm(force);
    parallelFor(points.water, [&](Index i) {
        p[i] = 0;
        if (role[i] != SurfaceRole::surface) return;
        const Real depth = kCarried * std::max(Real(0), (corrections.lambda[i] - surface.lambda) / surface.rise);
        const Vec<Dim> gradient = atMost(forceGradient[i], strongest) + force;   // grad p / rho0
        const Real inwards = std::max(Real(0), -dot(gradient, unit(corrections.lopsided[i])));
        p[i] = depth * spacingOverH * points.h[i] * inwards;
    });
}

template void findFreeSurface(const Points<2>&, const PairList<2>&, const Corrections<2>&, std::vector<SurfaceRole>&);
template void findFreeSurface(const Points<3>&, const PairList<3>&, const Corrections<3>&, std::vector<SurfaceRole>&);
template void surfacePressure(const FlatSurface&, Real, const Points<2>&, const Corrections<2>&,
                              const std::vector<SurfaceRole>&, Span<const Vec<2>>, const Vec<2>&, std::vector<Real>&);
template void surfacePressure(const FlatSurface&, Real, const Points<3>&, const Corrections<3>&,
                              const std::vector<SurfaceRole>&, Span<const Vec<3>>, const Vec<3>&, std::vector<Real>&);

}  // namespace isph
