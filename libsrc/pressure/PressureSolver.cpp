// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/PressureSolver.hpp"

namespace isph {

PressureSolver::Table& PressureSolver::table()
{
    static Table rows;
    return rows;
}

std::unique_ptr<PressureSolver> PressureSolver::select(const Dictionary& pressure)
{
    return table().make(pressure.get<std::string>("solver"), pressure, pressure, "solver");
}

Schema SolverControls::keys()
{
    return {
        Key::word("solver", "Solver of the pressure equation."),
        Key::scalar("tolerance", "Converged where |b - A p| <= tolerance |b|.")
            .byDefault("1e-6")
            .above(0)
            .below(1),
        Key::scalar("relTol",
                    "Converged also where |b - A p| <= relTol times its value at the start.")
            .byDefault("0")
            .atLeast(0)
            .below(1),
        Key::integer("maxIter", "Most iterations of one solve.").byDefault("500").atLeast(1),
    };
}

SolverControls::SolverControls(const Dictionary& pressure)
    : tolerance(keys().get<Real>(pressure, "tolerance")),
      relTol(keys().get<Real>(pressure, "relTol")),
      maxIter(keys().get<int>(pressure, "maxIter"))
{
}

}  // namespace isph
