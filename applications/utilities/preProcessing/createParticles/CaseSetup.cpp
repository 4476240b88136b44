// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseSetup.hpp"

#include "case/CaseSchemas.hpp"
#include "kernels/Kernel.hpp"
#include "porous/PorousModel.hpp"

#include <algorithm>

namespace isph {

namespace {

Dictionary readOptional(const std::filesystem::path& file)
{
    return std::filesystem::exists(file) ? Dictionary::read(file) : Dictionary::parse("", file.string());
}

/// Radius of the kernel, in the soil of the least porosity that the case has.
Real supportRadius(const Dictionary& schemes, const CaseGeometry& g, const std::vector<ZonePorosity>& zones)
{
    Dictionary choice = schemes;
    if (!choice.found("kernel")) choice.set("kernel", "wendlandC2");
    Real least = 1;
    for (const SoilRegion& region : g.soil)
        for (const ZonePorosity& zone : zones)
            if (zone.name == region.zone) least = std::min(least, zone.porosity);
    const Real h = schemes.getOrDefault("smoothingRatio", 1.5) * g.spacing / std::pow(least, 1.0 / g.dimension);
    return Kernel::select(choice)->supportRadius() * h;
}

}  // namespace

CaseSetup readCase(const std::filesystem::path& caseDir)
{
    CaseSetup setup;
    const Dictionary particles = Dictionary::read(caseDir / "system" / "particlesDict");
    const Dictionary boundaries = readOptional(caseDir / "system" / "boundaryDict");
    const auto periodic = readPeriodic(boundaries, particles.getOrDefault("dimension", 3));
    setup.geometry = readGeometry(particles, periodic, caseDir);
    const Dictionary zones = readOptional(caseDir / "constant" / "porousZones");
    for (const std::string& name : zones.keywords())
        if (name != "FoamFile" && zones.isDict(name))
            setup.zones.push_back({name, PorousModel::select(zones.subDict(name))->porosity()});
    setup.supportRadius = supportRadius(readOptional(caseDir / "system" / "isphSchemes"), setup.geometry, setup.zones);
    return setup;
}

}  // namespace isph
