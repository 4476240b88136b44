// SPDX-License-Identifier: GPL-3.0-or-later
// What one step computes from the particles and the next step computes anew.
#pragma once
#include "boundaries/FreeSurface.hpp"
#include "integrator/Scheme.hpp"
#include "porous/Medium.hpp"

#include <vector>

namespace isph {

/// What faces of soil ask for, of water and images; empty without soil.      [theory (3.12), (7.6)]
template <int Dim>
struct FaceFields {
    std::vector<Vec<Dim>> v;           ///< extrapolated to the new time [m/s]
    /// Whether v, not u, is carried through faces       [theory (3.12)]
    std::vector<char> carriesDarcy;
    std::vector<Real> viscosity;       ///< [m2/s], 0 away from faces
    std::vector<Mat<Dim>> gradient;    ///< grad v in the zone of the particle [1/s]
};

template <int Dim>
struct StepFields {
    Points<Dim> points;
    PairList<Dim> pairs;
    Corrections<Dim> corrections;
    std::vector<SurfaceRole> role;
    PorousState<Dim> soil;               ///< empty without soil, porosity excepted
    std::vector<Real> resistance;        ///< r_i [1/s], empty without soil
    FaceFields<Dim> face;
    std::vector<Real> eddyViscosity;     ///< nu_T [m2/s], empty when laminar
    std::vector<Vec<Dim>> v;  ///< Darcy velocity: of the predictor, then of the corrector [m/s]
    std::vector<Real> p;                 ///< p/rho0 of water and images [m2/s2]
};

}  // namespace isph
