// SPDX-License-Identifier: GPL-3.0-or-later
// The equations that solvers are measured on, by the words of a command line.
#pragma once
#include "core/Error.hpp"
#include "pressure/EquationFile.hpp"
#include "unit/pressure/LayeredTank.hpp"

#include <fmt/core.h>

#include <sstream>

namespace isph::test {

/// tank:<dimension>:<particles>:<waterOverSoil|soilOverWater|column>:<jump>
inline LayeredTank tankOf(const std::string& word)
{
    std::istringstream in(word);
    std::vector<std::string> parts;
    for (std::string part; std::getline(in, part, ':');) parts.push_back(part);
    const std::vector<std::string> layers{"waterOverSoil", "soilOverWater", "column"};
    const auto found =
        parts.size() == 5 ? std::find(layers.begin(), layers.end(), parts[3]) : layers.end();
    if (found == layers.end())
        throw FatalError(fmt::format(
            "{} is no tank:<dimension>:<particles>:<waterOverSoil|soilOverWater|column>:<jump>.",
            word));
    LayeredTank tank;
    tank.dimension = std::stoi(parts[1]);
    tank.particles = std::stod(parts[2]);
    tank.layers = static_cast<LayeredTank::Layers>(found - layers.begin());
    tank.jump = std::stod(parts[4]);
    return tank;
}

/// A file that recordInterval wrote, or a layered tank whose particles have moved by a hundredth of
/// their spacing since the solution that is the first guess.
inline Equation equationOf(const std::string& word)
{
    if (word.rfind("tank:", 0) != 0) return readEquation(word);
    LayeredTank tank = tankOf(word);
    Equation equation;
    {
        const PressureSystem before = pressureSystem(tank);
        equation.x.assign(before.b.size(), 0);
        PressureSolver::select(Dictionary::parse("solver multigridPCG; tolerance 1e-8;", "start"))
            ->solve(before.matrix, before.b, equation.x);
    }
    tank.moved = 0.01;
    PressureSystem now = pressureSystem(tank);
    equation.matrix = std::move(now.matrix);
    equation.b = std::move(now.b);
    return equation;
}

}  // namespace isph::test
