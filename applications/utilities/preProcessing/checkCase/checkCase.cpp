// SPDX-License-Identifier: GPL-3.0-or-later
// checkCase: checks the dictionaries and the particles of a case before it is run.
#include "DictionaryChecks.hpp"
#include "Estimate.hpp"
#include "ParticleChecks.hpp"

#include "case/CaseSchemas.hpp"
#include "core/Log.hpp"
#include "selection/CommandLine.hpp"

namespace {

using namespace isph;

/// Gravity, or zero where constant/g cannot be read, which has been reported then.
Point gravityOf(const std::filesystem::path& caseDir)
{
    try {
        return {gravityKeys().get<Vector3>(Dictionary::read(caseDir / "constant" / "g"), "value")};
    } catch (const FatalError&) {
        return {};
    }
}

/// Everything there is to check; the number of failures.
int checkAll(const std::filesystem::path& caseDir)
{
    Checklist list;
    info("Dictionaries");
    checkDictionaries(caseDir, list);
    CaseSetup setup;
    const bool hasSetup = list.check("system/particlesDict", [&] {
        setup = readCase(caseDir);
        const CaseGeometry& g = setup.geometry;
        return fmt::format("{} dimensions, spacing {} m", g.dimension, g.spacing);
    });
    if (!hasSetup) return list.failures();

    info("\nParticles");
    CaseParticles particles;
    const bool hasParticles = list.check("reading or laying them", [&]() -> std::string {
        particles = particlesOf(setup, caseDir);
        return particles.fromFiles ? "those of 0/"
                                   : "as createParticles would lay them; 0/ has none";
    });
    const Point gravity = gravityOf(caseDir);
    if (hasParticles) checkParticles(setup, particles, gravity, list);
    if (hasParticles && setup.geometry.soil.size() > 0) noteGrains(setup, caseDir, list);
    if (list.failures() == 0) printEstimate(setup, particles, gravity, caseDir);
    return list.failures();
}

}  // namespace

int main(int argc, char* argv[])
{
    try {
        CommandLine line(
            "checkCase",
            "Checks the dictionaries of a case against the keys of their readers, its walls "
            "against the kernel, and estimates memory and time of the run.");
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
        line.printBanner();
        const int failures = checkAll(line.caseDir());
        if (failures == 0)
            info("\nCase OK.\n");
        else
            info("\nFailed {} check{}.\n", failures, failures == 1 ? "" : "s");
        return failures == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        return isph::reportFatal(error);
    }
}
