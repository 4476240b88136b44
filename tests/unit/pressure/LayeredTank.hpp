// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure equations of tanks with layers of soil, in 2-D and 3-D, of any size.
#pragma once
#include "core/Parallel.hpp"
#include "core/Vec.hpp"
#include "pressure/SymmetricMatrix.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace isph::test {

/// A tank, 2:1 or 2:1:1, of jittered lattice particles with p = 0 along its top. Spacing 1.
///   waterOverSoil  water above, soil below
///   soilOverWater  a pocket of water below soil: it reaches p = 0 through the soil alone
///   column         water, soil layer, water pocket, and a column of soil through all of them
/// The coefficient is 1 in water and 1/jump in soil.
struct LayeredTank {
    enum class Layers { waterOverSoil, soilOverWater, column };

    int dimension = 2;
    Real particles = 1e4;
    Layers layers = Layers::column;
    Real jump = 1e4;
    Real jitter = 0.2;
    Real moved = 0;  ///< positions after a move of this share of the spacing
    bool withPlaces = true;
};

struct PressureSystem {
    SymmetricMatrix matrix;
    std::vector<Real> b;
};

namespace detail {

/// A number in [-1, 1] that belongs to (site, kind): the same at any order of evaluation.
inline Real randomNumber(std::uint64_t site, std::uint64_t kind)
{
    std::uint64_t z = (site * 16 + kind + 1) * 0x9E3779B97F4A7C15ULL;  // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<Real>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

struct Lattice {
    std::array<int, 3> n{};  // x, height y, depth z; rows in the order x, y, z
    const LayeredTank& tank;

    explicit Lattice(const LayeredTank& t) : tank(t)
    {
        const Real height = std::pow(t.particles / 2, 1.0 / t.dimension);
        const int side = std::max(4, static_cast<int>(std::lround(height)));
        n = {2 * side, side + 1, t.dimension == 3 ? side : 1};
    }
    std::int64_t sites() const { return std::int64_t{1} * n[0] * n[1] * n[2]; }
    std::array<int, 3> site(std::int64_t s) const
    {
        return {static_cast<int>(s % n[0]), static_cast<int>(s / n[0] % n[1]),
                static_cast<int>(s / n[0] / n[1])};
    }
    std::int64_t index(const std::array<int, 3>& i) const
    {
        return (std::int64_t{i[2]} * n[1] + i[1]) * n[0] + i[0];
    }
    bool atmosphere(const std::array<int, 3>& i) const { return i[1] == n[1] - 1; }
    /// Rows before site s: the uppermost lattice row of every plane has none.
    Index row(const std::array<int, 3>& i) const
    {
        return static_cast<Index>((std::int64_t{i[2]} * (n[1] - 1) + i[1]) * n[0] + i[0]);
    }
    Vec<3> place(const std::array<int, 3>& i) const
    {
        Vec<3> x;
        const auto s = static_cast<std::uint64_t>(index(i));
        for (int d = 0; d < tank.dimension; ++d)
            x[d] = i[d] + tank.jitter * randomNumber(s, d) + tank.moved * randomNumber(s, 4 + d);
        return x;
    }
    Real beta(const std::array<int, 3>& i) const
    {
        const Real y = (i[1] + 0.5) / n[1], x = (i[0] + 0.5) / n[0];
        bool soil = false;
        switch (tank.layers) {
            case LayeredTank::Layers::waterOverSoil:
                soil = y < 0.5;
                break;
            case LayeredTank::Layers::soilOverWater:
                soil = y > 0.35;
                break;
            case LayeredTank::Layers::column:
                soil = (y > 0.4 && y < 0.7) || (x > 0.45 && x < 0.55);
                break;
        }
        return soil ? 1 / tank.jump : 1;
    }
};

/// f(site j, |x_ij|^2, x_ij) for the partners of site i.
template <class F>
void forPartners(const Lattice& lattice, const std::array<int, 3>& i, F&& f)
{
    constexpr int reach = 3;  // sites; jitter below 0.3
    constexpr Real support = 2.4;
    const Vec<3> x_i = lattice.place(i);
    const auto low = [&](int d) { return std::max(0, i[d] - reach); };
    const auto high = [&](int d) { return std::min(lattice.n[d] - 1, i[d] + reach); };
    std::array<int, 3> j;
    for (j[2] = low(2); j[2] <= high(2); ++j[2])
        for (j[1] = low(1); j[1] <= high(1); ++j[1])
            for (j[0] = low(0); j[0] <= high(0); ++j[0]) {
                if (j == i) continue;
                const Vec<3> x_ij = lattice.place(j) - x_i;
                if (normSqr(x_ij) < sqr(support)) f(j, cube(1 - norm(x_ij) / support), x_ij);
            }
}

}  // namespace detail

/// a_ij = -beta_ij (1 - r/2.4)^3, the form of Wendland C2's W'/r, beta_ij harmonic. b: gravity
/// (wall fluxes), smooth sources and 5 % of noise.
inline PressureSystem pressureSystem(const LayeredTank& tank)
{
    const detail::Lattice lattice(tank);
    const std::int64_t plane = std::int64_t{1} * lattice.n[0] * (lattice.n[1] - 1);
    const auto rows = static_cast<std::size_t>(plane * lattice.n[2]);
    PressureSystem system;
    SymmetricMatrix& a = system.matrix;
    a.rowStart.assign(rows + 1, 0);
    a.diagonal.resize(rows), system.b.resize(rows);
    if (tank.withPlaces) {
        a.places.dimension = tank.dimension;
        a.places.coordinate.resize(rows * tank.dimension);
        a.places.spacing.assign(rows, 1);
    }
    const auto forSites = [&](auto&& f) {
        parallelForDynamic(static_cast<std::size_t>(lattice.sites()), [&](Index s) {
            const auto i = lattice.site(s);
            if (!lattice.atmosphere(i)) f(i, lattice.row(i));
        });
    };
    forSites([&](const auto& i, Index r) {
        PairIndex entries = 0;
        detail::forPartners(lattice, i, [&](const auto& j, Real, const Vec<3>&) {
            entries += !lattice.atmosphere(j);
        });
        a.rowStart[r + 1] = entries;
    });
    for (std::size_t r = 0; r < rows; ++r) a.rowStart[r + 1] += a.rowStart[r];
    a.column.resize(a.rowStart.back()), a.offDiagonal.resize(a.rowStart.back());
    forSites([&](const auto& i, Index r) {
        PairIndex entry = a.rowStart[r];
        Real sum = 0, gravity = 0;
        const Real beta_i = lattice.beta(i);
        detail::forPartners(lattice, i, [&](const auto& j, Real w, const Vec<3>& x_ij) {
            const Real beta_j = lattice.beta(j);
            const Real weight = 2 * beta_i * beta_j / (beta_i + beta_j) * w;
            const auto a_ij = static_cast<float>(-weight);
            sum -= static_cast<Real>(a_ij);
            gravity -= weight * x_ij[1];
            if (lattice.atmosphere(j)) return;
            a.column[entry] = lattice.row(j);
            a.offDiagonal[entry++] = a_ij;
        });
        a.diagonal[r] = sum;
        const Real phase = 3.0 * i[0] / lattice.n[0] + 2.0 * i[1] / lattice.n[1];
        const auto s = static_cast<std::uint64_t>(lattice.index(i));
        system.b[r] =
            gravity + beta_i * (0.02 * std::cos(phase) + 0.05 * detail::randomNumber(s, 8));
        const Vec<3> x = lattice.place(i);
        for (int d = 0; d < a.places.dimension; ++d)
            a.places.coordinate[r * tank.dimension + d] = x[d];
    });
    return system;
}

}  // namespace isph::test
