// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure Poisson equation of a step: rows, matrix, right-hand side.            [theory 5]
#pragma once
#include "boundaries/FreeSurface.hpp"
#include "porous/Medium.hpp"
#include "pressure/SymmetricMatrix.hpp"

#include <vector>

namespace isph {

/// The unknowns are the water particles that are not at the surface.
struct PressureRows {
    std::vector<Index> row;        ///< of every water particle, -1 at the surface
    std::vector<Index> particle;   ///< of every row

    void number(const std::vector<SurfaceRole>& role, Index water);
    std::size_t size() const { return particle.size(); }
};

/// What enters the equation besides the pressure.
template <int Dim>
struct PressureSource {
    Span<const Vec<Dim>> v;               ///< w, the predictor's Darcy velocity, water and images
    Span<const Vec<Dim>> forceGradient;   ///< c_i, (s w - v)/beta, at the new time
    Span<const Real> divergence;          ///< wanted divergence of v_D after the step [1/s]
    Vec<Dim> force{};                     ///< g + body force
    /// P/rho0 of surface particles [m2/s2]; empty: 0   [theory (6.9)]
    Span<const Real> surfacePressure{};
    Real strongest = 0;     ///< |c_i| that counts near the surface, if larger than |force|
};

/// Row i, multiplied by V_i so that the matrix is symmetric:                         [theory (5.1)]
///   sum_j V_j F_ij beta_ij [(p_j - p_i)/rho + B_ij - g.(x_j - x_i)] - beta_i c_i.T_i
///   = D_i - divergence_i
/// over water partners; walls are left out, which makes them impermeable (natural Neumann
/// condition). p is known at surface particles. T_i = sum_j V_j F_ij x_ji over water and walls is
/// what the surface cuts off a support, and the disorder of a packing; the term makes the row exact
/// for a linear pressure, at rest as in free fall, and for a uniform flow through faces of soil.
///                                                                                            (5.4)
/// The unknown is p/rho0. B_ij is what the speed in pores takes of it
/// (3.13).
template <int Dim, class Medium>
void assemble(const Points<Dim>& points, const PairList<Dim>& pairs,
              const Corrections<Dim>& corrections, const std::vector<SurfaceRole>& role,
              const Medium& medium, const PressureSource<Dim>& source, const PressureRows& rows,
              SymmetricMatrix& matrix, std::vector<Real>& rhs, std::vector<char>& anchored);

}  // namespace isph
