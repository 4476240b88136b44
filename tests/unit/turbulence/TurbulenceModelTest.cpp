// SPDX-License-Identifier: GPL-3.0-or-later
#include "turbulence/TurbulenceModel.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace isph;

namespace {

std::unique_ptr<TurbulenceModel> model(const std::string& text)
{
    return TurbulenceModel::select(Dictionary::parse(text, "turbulenceProperties"));
}

/// nuT of one particle.
Real nuT(const TurbulenceModel& m, Real strainRate, Real porosity, Real spacing)
{
    std::vector<Real> out{-1};
    m.eddyViscosity(std::vector<Real>{strainRate}, std::vector<Real>{porosity}, spacing, out);
    return out[0];
}

TEST(TurbulenceModel, LaminarHasNoEddyViscosityAndSaysSo)
{
    const auto m = model("turbulenceModel laminar;");
    EXPECT_FALSE(m->active());
    EXPECT_EQ(nuT(*m, 10, 1, 0.01), 0);
}

TEST(TurbulenceModel, SmagorinskyIsTheSquareOfItsLengthTimesTheStrainRate)
{
    const auto m = model("turbulenceModel Smagorinsky; SmagorinskyCoeffs { Cs 0.12; }");
    EXPECT_TRUE(m->active());
    EXPECT_NEAR(nuT(*m, 7, 1, 0.02) / (sqr(0.12 * 0.02) * 7), 1, 1e-14);  // the same algebra
    EXPECT_EQ(nuT(*m, 0, 1, 0.02), 0);
}

TEST(TurbulenceModel, SmagorinskyNeedsNoCoefficients)
{
    EXPECT_EQ(
        nuT(*model("turbulenceModel Smagorinsky;"), 7, 1, 0.02),
        nuT(*model("turbulenceModel Smagorinsky; SmagorinskyCoeffs { Cs 0.15; }"), 7, 1, 0.02));
}

TEST(TurbulenceModel, SmagorinskyVanishesInThePores)
{
    const auto m = model("turbulenceModel Smagorinsky;");
    for (const Real porosity : {0.2, 0.4, 0.49, 0.8, 0.9})
        EXPECT_EQ(nuT(*m, 100, porosity, 0.01), 0) << porosity;
    EXPECT_GT(nuT(*m, 100, 0.91, 0.01), 0);
}

TEST(TurbulenceModel, SmagorinskyFallsSmoothlyIntoTheSoil)
{
    const auto m = model("turbulenceModel Smagorinsky; SmagorinskyCoeffs { porosityOff 0.8; }");
    const Real clear = nuT(*m, 100, 1, 0.01), step = 1e-4;
    for (Real porosity = 0.78; porosity < 1; porosity += 0.01) {
        const auto share = [&](Real e) { return nuT(*m, 100, e, 0.01) / clear; };
        EXPECT_LE(share(porosity), share(porosity + step));
        // The cubic's slope is at most 1.5 and its second derivative at most 6 over the width 0.2.
        EXPECT_LE(share(porosity + step) - share(porosity), 1.5 / 0.2 * step * 1.001);
        EXPECT_LE(std::abs(share(porosity + step) - 2 * share(porosity) + share(porosity - step)),
                  6 / sqr(0.2) * sqr(step) * 1.01);
    }
    EXPECT_NEAR(nuT(*m, 100, 0.9, 0.01) / clear, 0.5, 1e-14);  // half way, by symmetry
}

TEST(TurbulenceModel, EachParticleIsItsOwn)
{
    const auto m = model("turbulenceModel Smagorinsky;");
    const std::vector<Real> strainRate{1, 2, 3}, porosity{1, 0.5, 0.95};
    std::vector<Real> out(3);
    m->eddyViscosity(strainRate, porosity, 0.01, out);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(out[k], nuT(*m, strainRate[k], porosity[k], 0.01));
}

TEST(TurbulenceModel, BadInputIsRefusedAtItsLine)
{
    const auto refusedAt = [](const std::string& text) {
        try {
            model(text);
        } catch (const FatalIOError& error) {
            return error.line();
        }
        return 0;
    };
    EXPECT_EQ(refusedAt("\nturbulenceModel smagorinsky;"), 2);
    EXPECT_EQ(refusedAt("turbulenceModel Smagorinsky;\nSmagorinskyCoeffs {\n Cs -0.1; }"), 3);
    EXPECT_EQ(refusedAt("turbulenceModel Smagorinsky;\nSmagorinskyCoeffs { Cz 0.1; }"), 2);
    EXPECT_EQ(refusedAt("turbulenceModel laminar;\nturbulance on;"), 2);
}

}  // namespace
