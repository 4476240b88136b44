// SPDX-License-Identifier: GPL-3.0-or-later
// Matrices as the pressure equation has them: the Laplacian of particles on a jittered lattice.
#pragma once
#include "pressure/SymmetricMatrix.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace isph::test {

/// What a test may vary. Lattice sites (ix, iy), spacing 1; rows of the matrix in the order of the
/// lattice rows.
struct Scene {
    int nx = 40, ny = 30;
    Real jitter = 0.2;  ///< of the spacing
    std::function<bool(int, int)> present = [](int, int) { return true; };
    /// p = 0, row eliminated: the uppermost lattice row unless said otherwise
    std::function<bool(int, int)> atmosphere = [top = &ny](int, int iy) { return iy == *top - 1; };
    std::function<Real(int, int)> beta = [](int, int) { return 1.0; };  ///< coefficient
    unsigned seed = 1;
    bool withPlaces = true;  ///< the rows' places come with the matrix

    Scene() = default;
    Scene(int columns, int rows) : nx(columns), ny(rows) {}
    Scene(const Scene&) = delete;  // atmosphere refers to ny
    Scene& operator=(const Scene&) = delete;
};

struct ParticleSystem {
    SymmetricMatrix matrix;
    std::vector<char> anchored;  ///< row has a neighbour at p = 0
    std::vector<Real> b;         ///< a smooth mode and noise
};

/// a_ij = -beta_ij w(r_ij), beta_ij harmonic, w = (1 - r/2.4)^3 within r < 2.4;  a_ii = -sum_j a_ij
inline ParticleSystem particleSystem(const Scene& scene)
{
    std::mt19937 random(scene.seed);
    std::uniform_real_distribution<Real> offset(-scene.jitter, scene.jitter), noise(-1, 1);
    enum : Index { absent = -1, atmosphere = -2 };
    const auto sites = static_cast<std::size_t>(scene.nx * scene.ny);
    std::vector<Index> row(sites, absent);
    std::vector<Real> x(sites), y(sites);
    Index rows = 0;
    for (int iy = 0; iy < scene.ny; ++iy)
        for (int ix = 0; ix < scene.nx; ++ix) {
            const std::size_t s = iy * scene.nx + ix;
            x[s] = ix + offset(random), y[s] = iy + offset(random);
            if (scene.present(ix, iy))
                row[s] = scene.atmosphere(ix, iy) ? Index{atmosphere} : rows++;
        }
    ParticleSystem system;
    SymmetricMatrix& a = system.matrix;
    if (scene.withPlaces) a.places.dimension = 2;
    constexpr int reach = 3;  // sites; jitter below 0.3
    constexpr Real support = 2.4;
    for (int iy = 0; iy < scene.ny; ++iy)
        for (int ix = 0; ix < scene.nx; ++ix) {
            const std::size_t s = iy * scene.nx + ix;
            if (row[s] < 0) continue;
            Real sum = 0;
            bool anchored = false;
            for (int jy = std::max(0, iy - reach); jy <= std::min(scene.ny - 1, iy + reach); ++jy)
                for (int jx = std::max(0, ix - reach); jx <= std::min(scene.nx - 1, ix + reach);
                     ++jx) {
                    const std::size_t t = jy * scene.nx + jx;
                    const Real r = std::hypot(x[s] - x[t], y[s] - y[t]);
                    if (t == s || row[t] == absent || r >= support) continue;
                    const Real bi = scene.beta(ix, iy), bj = scene.beta(jx, jy);
                    const Real weight = 2 * bi * bj / (bi + bj) * cube(1 - r / support);
                    const auto a_ij = static_cast<float>(-weight);
                    sum -= static_cast<Real>(a_ij);
                    anchored |= row[t] == atmosphere;
                    if (row[t] < 0) continue;
                    a.column.push_back(row[t]);
                    a.offDiagonal.push_back(a_ij);
                }
            a.diagonal.push_back(sum);
            a.rowStart.push_back(static_cast<PairIndex>(a.column.size()));
            system.anchored.push_back(anchored);
            system.b.push_back(std::cos(3.0 * ix / scene.nx) + 0.3 * noise(random));
            if (!scene.withPlaces) continue;
            a.places.coordinate.insert(a.places.coordinate.end(), {x[s], y[s]});
            a.places.spacing.push_back(1);
            a.places.particle.push_back(static_cast<Index>(s));
        }
    return system;
}

}  // namespace isph::test
