// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/SchemeKeys.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
// Water of the speed U at the start turns within a tenth of its extent   (5.4)
constexpr Real kSharpestTurn = 10;
}

Schema schemeKeys()
{
    return {
        Key::word("kernel", "the smoothing kernel").byDefault("wendlandC2"),
        Key::scalar("smoothingRatio", "h/d0, the smoothing length over the spacing in clear water")
            .byDefault("1.5")
            .atLeast(0.8)
            .atMost(3),
        Key::word("projection", "dragImplicit, or the paper's equations as printed, for comparison")
            .oneOf({"dragImplicit", "paper"})
            .byDefault("dragImplicit"),
        Key::dictionary("paperCoeffs", "choices of projection paper").mayBeAbsent(),
        Key::dictionary("stabilisation", "how the density is kept").mayBeAbsent(),
        Key::dictionary("shifting", "how the particles are evened out").mayBeAbsent(),
        Key::dictionary("dissipation", "numerical dissipation of velocity differences")
            .mayBeAbsent()};
}

Schema stabilisationKeys()
{
    return {
        Key::word("type", "relaxedDensity: alpha = dt/relaxationTime; constantAlpha: the paper's")
            .oneOf({"relaxedDensity", "constantAlpha", "none"})
            .byDefault("relaxedDensity"),
        Key::scalar(
            "relaxationTime",
            "time in which density errors decay [s]; auto: 0.2 sqrt(H/g), without gravity 10 L/U")
            .units(dims::time)
            .above(0)
            .oneOf({"auto"})
            .byDefault("auto"),
        Key::scalar("speedFactor", "upper bound of the decay rate in units of max|u|/d0")
            .byDefault("0.1")
            .atLeast(0),
        Key::scalar("alpha", "share of the density error that constantAlpha removes in a step")
            .byDefault("0.01")
            .atLeast(0)
            .atMost(1)};
}

Schema shiftingKeys()
{
    return {Key::scalar("coefficient",
                        "A of dx = -A h U dt grad C, U = max|u_i - u_j| of the neighbours, 0: none")
                .byDefault("10")
                .atLeast(0),
            Key::scalar("largestShift", "bound of a step's shift in local spacings")
                .byDefault("0.05")
                .above(0)
                .atMost(0.5)};
}

Schema dissipationKeys()
{
    return {
        Key::scalar("coefficient", "c_r of the pair viscosity c_r r|v.e|, 0: none")
            .byDefault("16")
            .atLeast(0),
        Key::word(
            "surface",
            "what dissipates at and near the surface: whole differences of the velocity, or their "
            "rough part, as inside")
            .oneOf({"whole", "rough"})
            .byDefault("whole"),
        Key::scalar("collisionDistance", "local spacings below which approach is stopped")
            .byDefault("0.5")
            .atLeast(0)
            .atMost(0.9)};
}

Schema paperKeys()
{
    return {Key::word("drag", "how drag enters the predictor").oneOf({"explicit", "semiImplicit"})
                .byDefault("explicit")};
}

Schema solutionKeys()
{
    return {Key::dictionary("pressure", "the solver of the pressure equation with its controls")};
}

namespace {
const Dictionary& optionalPart(const Dictionary& dict, const std::string& key)
{
    static const Dictionary empty;
    return dict.found(key) ? dict.subDict(key) : empty;
}
}  // namespace

void checkSchemes(const Dictionary& schemes)
{
    schemeKeys().check(schemes);
    stabilisationKeys().check(optionalPart(schemes, "stabilisation"));
    shiftingKeys().check(optionalPart(schemes, "shifting"));
    dissipationKeys().check(optionalPart(schemes, "dissipation"));
    paperKeys().check(optionalPart(schemes, "paperCoeffs"));
    if (schemes.found("paperCoeffs") && readProjection(schemes) != Projection::paper)
        schemes.fail("paperCoeffs", "paperCoeffs have a meaning with projection paper; only");
}

Projection readProjection(const Dictionary& schemes)
{
    return schemeKeys().get<std::string>(schemes, "projection") == "paper"
               ? Projection::paper
               : Projection::dragImplicit;
}

PaperDrag readPaperDrag(const Dictionary& schemes)
{
    const auto drag = paperKeys().get<std::string>(optionalPart(schemes, "paperCoeffs"), "drag");
    return drag == "explicit" ? PaperDrag::explicitly : PaperDrag::semiImplicit;
}

template <int Dim>
Scheme<Dim> readScheme(const Dictionary& schemes, const WaterProperties& water)
{
    checkSchemes(schemes);
    const Dictionary& stabilisation = optionalPart(schemes, "stabilisation");
    const Dictionary& shifting = optionalPart(schemes, "shifting");
    const Dictionary& dissipation = optionalPart(schemes, "dissipation");
    Scheme<Dim> scheme;
    scheme.spacing = water.spacing;
    scheme.h0 = schemeKeys().get<Real>(schemes, "smoothingRatio") * water.spacing;
    scheme.density = water.density;
    scheme.viscosity = water.viscosity;
    for (int d = 0; d < Dim; ++d) scheme.force[d] = water.force[d];

    const auto type = stabilisationKeys().get<std::string>(stabilisation, "type");
    scheme.stabilisation = type == "none"            ? Stabilisation::none
                         : type == "constantAlpha" ? Stabilisation::constantAlpha
                                                     : Stabilisation::relaxedDensity;
    const bool automatic = !stabilisation.found("relaxationTime")
                        || stabilisation.tokens("relaxationTime").front().text == "auto";
    const Real g = norm(scheme.force);
    if (water.depth > 0) scheme.strongest = kSharpestTurn * sqr(water.speed) / water.depth;
    scheme.surfaceCarries = readProjection(schemes) == Projection::dragImplicit;
    if (!automatic) scheme.relaxationTime = stabilisation.get<Real>("relaxationTime", dims::time);
    else if (g > 0) scheme.relaxationTime = 0.2 * std::sqrt(water.depth / g);
    else if (water.speed > 0) scheme.relaxationTime = 10 * water.depth / water.speed;
    scheme.speedFactor = stabilisationKeys().get<Real>(stabilisation, "speedFactor");
    scheme.alpha = stabilisationKeys().get<Real>(stabilisation, "alpha");
    scheme.shifting = shiftingKeys().get<Real>(shifting, "coefficient");
    scheme.largestShift = shiftingKeys().get<Real>(shifting, "largestShift");
    scheme.dissipation = dissipationKeys().get<Real>(dissipation, "coefficient");
    scheme.wholeAtSurface = dissipationKeys().get<std::string>(dissipation, "surface") == "whole";
    scheme.collisionDistance = dissipationKeys().get<Real>(dissipation, "collisionDistance");
    return scheme;
}

template Scheme<2> readScheme<2>(const Dictionary&, const WaterProperties&);
template Scheme<3> readScheme<3>(const Dictionary&, const WaterProperties&);

}  // namespace isph
