// SPDX-License-Identifier: GPL-3.0-or-later
// Particles pushed apart until they fill their regions evenly.
#pragma once
#include "case/CaseGeometry.hpp"

namespace isph {

/// What a packing keeps to.
struct PackingTask {
    const CaseGeometry& geometry;
    /// Porosity, so that the spacing at x is d0/porosity^(1/D).
    std::function<Real(const Point&)> porosity;
    /// Distance to what all particles together fill, positive outside: space there counts as
    /// filled.
    std::function<Real(const Point&)> outside;
    /// Distance to the part that particle i belongs to, negative inside: it does not leave it.
    std::function<Real(std::size_t i, const Point&)> own;
    /// 0: stays where it is, 1: moves freely.
    std::vector<Real> mobility;
    /// Not 0: keeps its distance to the outside, clear of soil.
    std::vector<char> slides;
};

/// Sweeps of  x_i -= c h_i^2 sum_j V_j [e + K (n_i + n_j)] gradW_ij,  V_j = d0^D/porosity_j,
/// n_i = sum_j V_j W_ij less that of a lattice, over particles and over the space outside (by
/// midpoints), until the largest step is 2e-3 of a spacing or 200 sweeps are done. The term e
/// orders the particles; alone it leaves the sum uneven by 3 % where the spacing varies, which the
/// term K repairs; n is that of the sweep before, so that one pass over the pairs gives both.
/// Threaded, the same bits for any number of threads.
void pack(const PackingTask& task, std::vector<Point>& x);

}  // namespace isph
