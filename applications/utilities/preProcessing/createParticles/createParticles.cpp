// SPDX-License-Identifier: GPL-3.0-or-later
// createParticles: fills 0/ with water, wall and soil particles from system/particlesDict.
#include "CaseSetup.hpp"
#include "Report.hpp"
#include "WriteParticles.hpp"

#include "core/Log.hpp"
#include "selection/CommandLine.hpp"

int main(int argc, char* argv[])
{
    using namespace isph;
    try {
        CommandLine line("createParticles",
                         "Fills 0/ with particles of water, walls and soil as system/particlesDict "
                         "describes them, and reports numbers and volumes.");
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
        line.printBanner();

        const CaseSetup setup = readCase(line.caseDir());
        const WallParticles walls = layWalls(setup.geometry, setup.wallThickness());
        const SoilParticles soil = fillSoil(setup.geometry, setup.zones);
        const WaterParticles water = fillWater(setup.geometry, setup.zones, walls, soil);
        report(setup, water, walls, soil);
        writeParticles(line.caseDir() / "0", setup, water, walls, soil);
        info("\nEnd\n");
        return 0;
    } catch (const std::exception& error) {
        return isph::reportFatal(error);
    }
}
