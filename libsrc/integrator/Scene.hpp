// SPDX-License-Identifier: GPL-3.0-or-later
// What a case consists of. Parts that it does not name do not exist: their pointers are null.
#pragma once
#include "boundaries/PointCloud.hpp"
#include "integrator/Scheme.hpp"
#include "kernels/Kernel.hpp"
#include "particles/Particles.hpp"
#include "porous/PorousField.hpp"
#include "pressure/PressureSolver.hpp"
#include "turbulence/TurbulenceModel.hpp"

#include <memory>

namespace isph {

template <int Dim>
struct Scene {
    Scheme<Dim> scheme;
    std::unique_ptr<Kernel> kernel;
    std::unique_ptr<PressureSolver> solver;
    PeriodicBox<Dim> box;
    Water<Dim> water;
    Walls<Dim> walls;
    WallCloud<Dim> wallCloud;
    Soil<Dim> soil;
    std::unique_ptr<PorousField<Dim>> porous;       ///< null without soil
    std::unique_ptr<TurbulenceModel> turbulence;    ///< null when laminar
};

}  // namespace isph
