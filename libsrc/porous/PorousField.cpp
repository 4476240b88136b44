// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousField.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr Real kLeastPorosity = 0.02;    // reached only by clumps of released grains
constexpr Real kClampCentre = 0.5;          // of the drag across a soil surface     [theory (4.13)]
constexpr Real kClampWidth = 0.2;
constexpr Real kLeastOpenSpace = 0.1;    // share of a kernel that is not wall, deep in corners
constexpr Real kSoilWidth = 1.5;         // h of the soil sums in d0, for a support of 2 h

/// Drag factor across a soil surface: no thin tail of drag reaches into the water above it.
Real clampedShare(Real share)
{
    return std::clamp((share - kClampCentre) / kClampWidth + Real(0.5), Real(0), Real(1));
}

/// sum_j d0^D W(x_j) over a full lattice with a point at x = 0.
template <int Dim>
Real latticeSum(const Kernel& kernel, Real sigma, Real hOverSpacing)
{
    const int m = static_cast<int>(std::ceil(kernel.supportRadius() * hOverSpacing));
    Real sum = 0;
    for (int a = -m; a <= m; ++a)
        for (int b = -m; b <= m; ++b)
            for (int c = (Dim == 3 ? -m : 0); c <= (Dim == 3 ? m : 0); ++c) {
                const Real q = std::sqrt(Real(a * a + b * b + c * c)) / hOverSpacing;
                if (q >= kernel.supportRadius()) continue;
                Real w = 0, slope = 0;
                kernel.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
                sum += w;
            }
    return sum * sigma / std::pow(hOverSpacing, Dim);
}
}  // namespace

/// Kernel sums at a point: solid volume fraction of the soil and its gradient, share of walls.
template <int Dim>
struct PorousField<Dim>::Sums {
    Real solid = 0, share = 0, wall = 0;
    Vec<Dim> gradShare{}, gradWall{};
};

template <int Dim>
PorousField<Dim>::PorousField(std::vector<SoilZone> zones, const Kernel& kernel,
                              const WallCloud<Dim>& walls, Real spacing)
    : zones_(std::move(zones)), kernel_(kernel), walls_(walls), spacing_(spacing),
      h_(kSoilWidth * spacing * 2 / kernel.supportRadius()), reach_(kernel.supportRadius() * h_),
      sigma_(kernel.normalisation(Dim))
{
    latticeSum_ = latticeSum<Dim>(kernel, sigma_, h_ / spacing);
    wallGrid_.build(walls.x, reach_);
}

template <int Dim>
void PorousField<Dim>::place(const Soil<Dim>& soil, const PeriodicBox<Dim>& box)
{
    soilX_ = soil.x;
    soilVolume_ = soil.solidVolume;
    soilZone_.assign(soil.zone.begin(), soil.zone.end());
    for (std::size_t k = 0; k < soil.size() && box.any(); ++k)
        box.forImages(soil.x[k], reach_ + spacing_, [&](const Vec<Dim>& shift) {
            soilX_.push_back(soil.x[k] + shift);
            soilVolume_.push_back(soil.solidVolume[k]);
            soilZone_.push_back(static_cast<Index>(soil.zone[k]));
        });
    soilGrid_.build(soilX_, reach_);
}

template <int Dim>
typename PorousField<Dim>::Sums PorousField<Dim>::sumsAt(const Vec<Dim>& x, std::vector<Real>& zoneShare) const
{
    Sums s;
    std::fill(zoneShare.begin(), zoneShare.end(), Real(0));
    const Real scaleW = sigma_ / (Dim == 2 ? sqr(h_) : cube(h_)) / latticeSum_, scaleG = scaleW / sqr(h_);
    const auto kernelAt = [&](const Vec<Dim>& r, Real& w, Real& slope) {
        const Real q = norm(r) / h_;
        kernel_.evaluate(Span<const Real>(&q, 1), Span<Real>(&w, 1), Span<Real>(&slope, 1));
    };
    soilGrid_.forEachNear(x, reach_, [&](Index k) {
        const Vec<Dim> r = x - soilX_[k];
        if (normSqr(r) >= sqr(reach_)) return;
        Real w = 0, slope = 0;
        kernelAt(r, w, slope);
        const Real V = soilVolume_[k], perSolid = 1 / (1 - zones_[soilZone_[k]].porosity);
        s.solid += V * w * scaleW;
        s.share += perSolid * V * w * scaleW;
        zoneShare[soilZone_[k]] += perSolid * V * w * scaleW;
        s.gradShare += (perSolid * V * slope * scaleG) * r;
    });
    if (s.solid == 0) return s;
    wallGrid_.forEachNear(x, reach_, [&](Index k) {
        const Vec<Dim> r = x - walls_.x[k];
        if (normSqr(r) >= sqr(reach_)) return;
        Real w = 0, slope = 0;
        kernelAt(r, w, slope);
        s.wall += walls_.volume[k] * w * scaleW;
        s.gradWall += (walls_.volume[k] * slope * scaleG) * r;
    });
    return s;
}

template <int Dim>
void PorousField<Dim>::evaluate(Span<const Vec<Dim>> x, PorousState<Dim>& state) const
{
    const std::size_t n = x.size();
    state.porosity.resize(n), state.share.resize(n), state.linear.resize(n), state.quadratic.resize(n);
    state.mobility.resize(n), state.normal.resize(n);
#pragma omp parallel
    {
        std::vector<Real> zoneShare(zones_.size());
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
            const Sums s = sumsAt(x[i], zoneShare);
            const Real open = std::max(kLeastOpenSpace, 1 - s.wall);   // soil goes on behind walls
            const Real eps = std::max(kLeastPorosity, 1 - s.solid / open);
            const Real share = std::min(Real(1), s.share / open);
            Real a = 0, b = 0, inertia = 1;
            if (share > 0) {
                const Real drag = clampedShare(share) / s.share;
                Real dominant = 0;
                for (std::size_t z = 0; z < zones_.size(); ++z) {
                    a += drag * zoneShare[z] * zones_[z].resistance.linear;
                    b += drag * zoneShare[z] * zones_[z].resistance.quadratic;
                    if (zoneShare[z] > dominant) {
                        dominant = zoneShare[z];
                        inertia = zones_[z].model->inertiaCoefficient(eps);
                    }
                }
            }
            state.porosity[i] = eps;
            state.share[i] = share;
            state.linear[i] = a;
            state.quadratic[i] = b;
            state.mobility[i] = eps / inertia;
            state.normal[i] = s.gradShare + s.share / open * s.gradWall;
        }
    }
}

template class PorousField<2>;
template class PorousField<3>;

}  // namespace isph
