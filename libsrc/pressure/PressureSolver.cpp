// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/PressureSolver.hpp"

#include "pressure/EquationFile.hpp"

namespace isph {

PressureSolver::Table& PressureSolver::table()
{
    static Table rows;
    return rows;
}

std::unique_ptr<PressureSolver> PressureSolver::select(const Dictionary& pressure)
{
    const Schema keys = SolverControls::keys();
    auto solver =
        table().make(keys.get<std::string>(pressure, "solver"), pressure, pressure, "solver");
    const int interval = keys.get<int>(pressure, "recordInterval");
    if (interval > 0) return std::make_unique<RecordingSolver>(std::move(solver), interval);
    return solver;
}

Schema SolverControls::keys()
{
    return {
        Key::word("solver", "Solver of the pressure equation; auto: by its size and dimension.")
            .byDefault("auto"),
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
        Key::integer("recordInterval",
                     "Every how many solves the equation is written to "
                     "postProcessing/pressureEquation, for measurements of solvers; 0: never.")
            .byDefault("0")
            .atLeast(0),
    };
}

SolverControls::SolverControls(const Dictionary& pressure)
    : tolerance(keys().get<Real>(pressure, "tolerance")),
      relTol(keys().get<Real>(pressure, "relTol")),
      maxIter(keys().get<int>(pressure, "maxIter"))
{
}

}  // namespace isph
