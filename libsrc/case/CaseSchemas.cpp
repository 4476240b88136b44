// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/CaseSchemas.hpp"

namespace isph {

Schema particlesKeys()
{
    return {
        Key::scalar("spacing", "distance d0 between particles of clear water [m]")
            .units(dims::length)
            .above(0),
        Key::integer("dimension", "2 for a section in the x-y plane, or 3").atLeast(2).atMost(3),
        Key::dictionary("domain", "the box that holds the case: min and max"),
        Key::dictionary("walls", "bodies that water does not enter, by name").mayBeAbsent(),
        Key::dictionary("water", "regions of water, by name"),
        Key::dictionary("soil", "regions of soil, by name").mayBeAbsent()};
}

Schema domainKeys()
{
    return {Key::vector("min", "corner of the smallest coordinates [m]").units(dims::length),
            Key::vector("max", "corner of the largest coordinates [m]").units(dims::length)};
}

Schema wallKeys()
{
    return {Key::word("fluid",
                      "the side of the surface where the water is; inside by default for a box "
                      "with open faces, else outside")
                .oneOf({"inside", "outside"})
                .mayBeAbsent(),
            Key::list("open",
                      "faces of a box without wall: left right bottom top back front, or xMin xMax "
                      "yMin yMax zMin zMax")
                .mayBeAbsent()};
}

Schema waterKeys()
{
    return {Key::list("velocity",
                      "velocity at the start, a vector [m/s] or three expressions of x, y and "
                      "z; by default at rest")
                .units(dims::velocity)
                .mayBeAbsent()};
}

Schema soilKeys()
{
    return {Key::word("zone", "the soil's name in constant/porousZones")};
}

Schema boundaryKeys()
{
    return {Key::list("periodic", "directions in which the domain repeats: x, y, z")
                .oneOf({"x", "y", "z"})
                .mayBeAbsent(),
            Key::dictionary("walls", "conditions at walls, by the wall's name").mayBeAbsent()};
}

Schema wallConditionKeys()
{
    return {
        Key::word(
            "condition",
            "slip: no friction; noSlip: water at the wall moves with it; wallLaw: friction of a "
            "turbulent boundary layer that is thinner than the spacing, at a smooth wall")
            .oneOf({"slip", "noSlip", "wallLaw"})
            .byDefault("slip"),
        Key::vector("velocity", "of a noSlip or wallLaw wall's surface, along itself [m/s]")
            .units(dims::velocity)
            .mayBeAbsent()};
}

Schema gravityKeys()
{
    return {Key::list("dimensions", "[0 1 -2 0 0 0 0]").units(dims::acceleration).mayBeAbsent(),
            Key::vector("value", "acceleration of gravity [m/s2]").units(dims::acceleration),
            Key::vector("bodyForce", "uniform acceleration added to gravity [m/s2]")
                .units(dims::acceleration)
                .byDefault("(0 0 0)")};
}

Vector3 readForce(const Dictionary& gravity, int dimension)
{
    gravityKeys().check(gravity);
    Vector3 force{};
    for (const std::string key : {"value", "bodyForce"}) {
        const auto part = gravityKeys().get<Vector3>(gravity, key);
        if (dimension == 2 && part[2] != 0)
            gravity.fail(
                key, "a case of two dimensions lies in x and y: the third component has to be 0");
        for (std::size_t d = 0; d < 3; ++d) force[d] += part[d];
    }
    return force;
}

Schema transportKeys()
{
    return {Key::scalar("nu", "kinematic viscosity [m2/s]")
                .units(dims::kinematicViscosity)
                .byDefault("1e-6")
                .atLeast(0),
            Key::scalar("rho", "density [kg/m3]").units(dims::density).byDefault("1000").above(0)};
}

std::array<bool, 3> readPeriodic(const Dictionary& boundaryDict, int dimension)
{
    std::array<bool, 3> periodic{};
    boundaryKeys().check(boundaryDict);
    if (!boundaryDict.found("periodic")) return periodic;
    for (const std::string& word : boundaryDict.get<std::vector<std::string>>("periodic")) {
        const int d = word[0] - 'x';
        if (d >= dimension)
            boundaryDict.fail("periodic",
                              "a case of two dimensions has no direction z to repeat in");
        periodic[d] = true;
    }
    return periodic;
}

}  // namespace isph
