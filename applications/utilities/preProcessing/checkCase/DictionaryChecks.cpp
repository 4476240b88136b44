// SPDX-License-Identifier: GPL-3.0-or-later
#include "DictionaryChecks.hpp"

#include "case/CaseGeometry.hpp"
#include "case/CaseSchemas.hpp"
#include "case/Time.hpp"
#include "erosion/ErosionModel.hpp"
#include "functionObjects/FunctionObjectList.hpp"
#include "integrator/SchemeKeys.hpp"
#include "kernels/Kernel.hpp"
#include "porous/PorousModel.hpp"
#include "pressure/PressureSolver.hpp"
#include "turbulence/TurbulenceModel.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace isph {

namespace {

namespace fs = std::filesystem;

/// Checks a file that must be there, or one that may be missing: "absent: <what that means>".
void checkFile(Checklist& list, const fs::path& caseDir, const std::string& name,
               const std::string& whenAbsent,
               const std::function<std::string(const Dictionary&)>& work)
{
    list.check(name, [&]() -> std::string {
        if (!whenAbsent.empty() && !fs::exists(caseDir / name)) return "absent: " + whenAbsent;
        return work(Dictionary::read(caseDir / name));
    });
}

std::string checkControl(const fs::path& caseDir, const Dictionary& control)
{
    controlDictKeys().check(control);
    const FunctionObjectList functions(control, {caseDir, "0", {}});
    const auto names = functions.names();
    return names.empty() ? "" : fmt::format("{} function objects", names.size());
}

std::string checkSchemesDict(const Dictionary& schemes)
{
    checkSchemes(schemes);
    Dictionary choice = schemes;
    if (!choice.found("kernel")) choice.set("kernel", "wendlandC2");
    Kernel::select(choice);
    return choice.get<std::string>("kernel");
}

std::string checkSolution(const Dictionary& solution)
{
    solutionKeys().check(solution);
    PressureSolver::select(solution.subDict("pressure"));
    return SolverControls::keys().get<std::string>(solution.subDict("pressure"), "solver");
}

int dimensionOf(const fs::path& caseDir)
{
    return particlesKeys().get<int>(Dictionary::read(caseDir / "system" / "particlesDict"),
                                    "dimension");
}

std::string checkGravity(const fs::path& caseDir, const Dictionary& gravity)
{
    readForce(gravity, dimensionOf(caseDir));
    const Vector3 g = gravityKeys().get<Vector3>(gravity, "value");
    return fmt::format("({} {} {}) m/s2", g[0], g[1], g[2]);
}

std::string checkTransport(const Dictionary& transport)
{
    transportKeys().check(transport);
    return "";
}

std::string checkZones(const Dictionary& zones)
{
    std::string names;
    for (const std::string& name : zones.keywords()) {
        if (name == "FoamFile" || zones.isUsedByMacro(name)) continue;
        PorousModel::select(zones.subDict(name));
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

std::string checkTurbulence(const Dictionary& dict)
{
    TurbulenceModel::select(dict);
    return dict.get<std::string>("turbulenceModel");
}

std::string checkErosion(const Dictionary& dict)
{
    ErosionModel::select(dict);
    return dict.get<std::string>("erosionModel");
}

/// boundaryDict names walls of particlesDict.
std::string checkBoundaries(const fs::path& caseDir, const Dictionary& boundaries)
{
    const Dictionary particles = Dictionary::read(caseDir / "system" / "particlesDict");
    readPeriodic(boundaries, particles.get<int>("dimension"));
    if (!boundaries.found("walls")) return "";
    const Dictionary& conditions = boundaries.subDict("walls");
    const auto walls = particles.found("walls") ? particles.subDict("walls").keywords()
                                                : std::vector<std::string>{};
    for (const std::string& name : conditions.keywords()) {
        if (std::find(walls.begin(), walls.end(), name) == walls.end())
            conditions.fail(
                name, fmt::format("particlesDict has no wall {}\n\nIts walls are:\n\n{}", name,
                                  listOf(walls)));
        wallConditionKeys().check(conditions.subDict(name));
    }
    return "";
}

}  // namespace

void checkDictionaries(const fs::path& caseDir, Checklist& list)
{
    checkFile(list, caseDir, "system/controlDict", "",
              [&](const Dictionary& d) { return checkControl(caseDir, d); });
    checkFile(list, caseDir, "system/isphSchemes", "", checkSchemesDict);
    checkFile(list, caseDir, "system/isphSolution", "", checkSolution);
    checkFile(list, caseDir, "system/boundaryDict", "no periodic direction, walls slip",
              [&](const Dictionary& d) { return checkBoundaries(caseDir, d); });
    checkFile(list, caseDir, "constant/g", "",
              [&](const Dictionary& d) { return checkGravity(caseDir, d); });
    checkFile(list, caseDir, "constant/transportProperties", "nu = 1e-6 m2/s, rho = 1000 kg/m3",
              checkTransport);
    checkFile(list, caseDir, "constant/porousZones", "no soil", checkZones);
    checkFile(list, caseDir, "constant/turbulenceProperties", "laminar", checkTurbulence);
    checkFile(list, caseDir, "constant/erosionProperties", "no erosion", checkErosion);
}

}  // namespace isph
