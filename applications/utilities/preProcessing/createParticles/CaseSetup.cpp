// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseSetup.hpp"

#include "case/CaseSchemas.hpp"
#include "integrator/SchemeKeys.hpp"
#include "porous/PorousModel.hpp"

#include <algorithm>

namespace isph {

namespace {

Dictionary readOptional(const std::filesystem::path& file)
{
    return std::filesystem::exists(file) ? Dictionary::read(file)
                                         : Dictionary::parse("", file.string());
}

std::unique_ptr<Kernel> readKernel(const Dictionary& schemes)
{
    checkSchemes(schemes);
    Dictionary choice = schemes;
    if (!choice.found("kernel"))
        choice.set("kernel", schemeKeys().get<std::string>(schemes, "kernel"));
    return Kernel::select(choice);
}

/// Of the zones that the case has soil of; 1 without soil.
Real leastPorosity(const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    Real least = 1;
    for (const SoilRegion& region : g.soil)
        for (const ZonePorosity& zone : zones)
            if (zone.name == region.zone) least = std::min(least, zone.porosity);
    return least;
}

void loadCaseLibraries(const std::filesystem::path& controlDict)
{
    if (!std::filesystem::exists(controlDict)) return;
    for (const std::string& name :
         Dictionary::read(controlDict).getOrDefault("libs", std::vector<std::string>{}))
        loadLibrary(name);
}

}  // namespace

CaseSetup readCase(const std::filesystem::path& caseDir)
{
    CaseSetup setup;
    loadCaseLibraries(caseDir / "system" / "controlDict");
    const Dictionary particles = Dictionary::read(caseDir / "system" / "particlesDict");
    const Dictionary boundaries = readOptional(caseDir / "system" / "boundaryDict");
    const auto periodic = readPeriodic(boundaries, particles.getOrDefault("dimension", 3));
    setup.geometry = readGeometry(particles, periodic, caseDir);
    if (setup.geometry.water.empty())
        particles.fail("water", "water holds no region: a case has some water to begin with");
    setup.porousZones = readOptional(caseDir / "constant" / "porousZones");
    const Dictionary& zones = setup.porousZones;
    for (const std::string& name : zones.keywords())
        if (name != "FoamFile" && zones.isDict(name))
            setup.zones.push_back({name, PorousModel::select(zones.subDict(name))->porosity()});
    const CaseGeometry& g = setup.geometry;
    const Dictionary schemes = readOptional(caseDir / "system" / "isphSchemes");
    setup.kernel = readKernel(schemes);
    setup.clearRadius = setup.kernel->supportRadius() * g.spacing *
                        schemeKeys().get<Real>(schemes, "smoothingRatio");
    setup.supportRadius =
        setup.clearRadius / std::pow(leastPorosity(g, setup.zones), 1.0 / g.dimension);
    return setup;
}

}  // namespace isph
