// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousModel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace isph;

namespace {

constexpr Real nu = 1.3e-6;  // [m2/s]; not 1e-6, so that a forgotten nu shows

std::unique_ptr<PorousModel> model(const std::string& name, const std::string& coefficients)
{
    return PorousModel::select(Dictionary::parse(
        "porousModel " + name + ";\n" + name + "Coeffs\n{ " + coefficients + " }\n",
        "porousZones"));
}

Resistance intact(const PorousModel& m)
{
    return m.resistance(m.porosity(), nu);
}

/// The message of the error that a zone is refused with.
std::string refusal(const std::string& name, const std::string& coefficients)
{
    try {
        model(name, coefficients);
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.file(), "porousZones");
        EXPECT_GE(error.line(), 1);
        return error.what();
    }
    return "";
}

// Tolerances: the same algebra in another order, a few roundings.
constexpr Real exact = 1e-14;

TEST(PorousModel, AkbariIsThePapersEquations8And9)
{
    const Real e = 0.49, d = 0.0159;
    const auto m = model("akbari", "porosity 0.49; D50 0.0159; alphaC 700; betaC 2.0;");
    EXPECT_EQ(m->porosity(), e);
    EXPECT_NEAR(intact(*m).linear / (700 * nu * (1 - e) * (1 - e) / (e * e * e * d * d)), 1, exact);
    EXPECT_NEAR(intact(*m).quadratic / (2.0 * (1 - e) / (e * e * e * d)), 1, exact);
}

TEST(PorousModel, AkbarisDefaultsAreThePapers)
{
    const auto paper = model("akbari", "porosity 0.4; D50 0.01; alphaC 1000; betaC 1.1;");
    const auto plain = model("akbari", "porosity 0.4; D50 0.01;");
    EXPECT_EQ(intact(*plain).linear, intact(*paper).linear);
    EXPECT_EQ(intact(*plain).quadratic, intact(*paper).quadratic);
}

TEST(PorousModel, AkbariHasThePermeabilityAndForchheimerCoefficientOfEquation4)
{
    const Real e = 0.41, d = 3e-3, alphaC = 640, betaC = 1.3;
    const auto m = model("akbari", "porosity 0.41; D50 3e-3; alphaC 640; betaC 1.3;");
    const Real K = cube(e) * sqr(d) / (alphaC * sqr(1 - e));
    EXPECT_NEAR(permeability(intact(*m), nu) / K, 1, exact);
    EXPECT_NEAR(
        forchheimerCoefficient(intact(*m), nu) / (betaC / (std::sqrt(alphaC) * std::pow(e, 1.5))),
        1, exact);

    // The same soil given by K and C is the same resistance.
    std::ostringstream coefficients;
    coefficients.precision(17);
    coefficients << "porosity 0.41; K " << K << "; C " << forchheimerCoefficient(intact(*m), nu)
                 << ";";
    const auto same = model("darcyForchheimer", coefficients.str());
    EXPECT_NEAR(intact(*same).linear / intact(*m).linear, 1, exact);
    EXPECT_NEAR(intact(*same).quadratic / intact(*m).quadratic, 1, exact);
}

TEST(PorousModel, DarcyIsLinearAndForchheimerAddsTheSquare)
{
    const auto darcy = model("darcy", "porosity 0.4; K 2e-9;");
    EXPECT_NEAR(intact(*darcy).linear / (nu / 2e-9), 1, exact);
    EXPECT_EQ(intact(*darcy).quadratic, 0);

    const auto both = model("darcyForchheimer", "porosity 0.4; K 2e-9; C 0.55;");
    EXPECT_EQ(intact(*both).linear, intact(*darcy).linear);
    EXPECT_NEAR(intact(*both).quadratic / (0.55 / std::sqrt(2e-9)), 1, exact);
}

TEST(PorousModel, ErgunIsThePressureDropOfAPackedBed)
{
    // Ergun (1952): dp/L = 150 mu (1-e)^2 v/(e^3 d^2) + 1.75 rho (1-e) v^2/(e^3 d)
    const Real e = 0.38, d = 2e-3, v = 0.013;
    const Resistance r = intact(*model("ergun", "porosity 0.38; D50 2e-3;"));
    const Real drop =
        150 * nu * sqr(1 - e) * v / (cube(e) * sqr(d)) + 1.75 * (1 - e) * sqr(v) / (cube(e) * d);
    EXPECT_NEAR((r.linear * v + r.quadratic * sqr(v)) / drop, 1, exact);
}

TEST(PorousModel, EngelundHasItsOwnPowersOfThePorosity)
{
    const Real e = 0.43, d = 5e-4;
    const Resistance r =
        intact(*model("engelund", "porosity 0.43; D50 5e-4; alpha 780; beta 1.8;"));
    EXPECT_NEAR(r.linear / (780 * nu * cube(1 - e) / (sqr(e) * sqr(d))), 1, exact);
    EXPECT_NEAR(r.quadratic / (1.8 * (1 - e) / (cube(e) * d)), 1, exact);
    const Resistance plain = intact(*model("engelund", "porosity 0.43; D50 5e-4;"));
    EXPECT_NEAR(plain.linear / r.linear, 1000.0 / 780, exact);
    EXPECT_NEAR(plain.quadratic / r.quadratic, 2.8 / 1.8, exact);
}

TEST(PorousModel, VanGentIsAkbariWithHisTermOfTheWaves)
{
    const std::string soil = "porosity 0.4; D50 0.02; alphaC 900; betaC 1.2; ";
    const Resistance akbari = intact(*model("akbari", soil));
    const Resistance waves = intact(*model("vanGent", soil + "KC 30;"));
    EXPECT_EQ(waves.linear, akbari.linear);
    EXPECT_NEAR(waves.quadratic / akbari.quadratic, 1 + 7.5 / 30, exact);
    const Resistance steady = intact(*model("vanGent", soil + "KC 1e20;"));
    EXPECT_NEAR(steady.quadratic / akbari.quadratic, 1, exact);
}

TEST(PorousModel, GrainsOfferNoResistanceInClearWater)
{
    for (const std::string name : {"akbari", "ergun", "engelund"}) {
        const Resistance r = model(name, "porosity 0.4; D50 0.01;")->resistance(1, nu);
        EXPECT_EQ(r.linear, 0) << name;
        EXPECT_EQ(r.quadratic, 0) << name;
    }
}

TEST(PorousModel, TheInertiaCoefficientIsThePapersEquation6)
{
    const auto m = model("ergun", "porosity 0.4; D50 0.01;");
    EXPECT_NEAR(m->inertiaCoefficient(0.4), 1 + 0.34 * 0.6 / 0.4, exact);
    EXPECT_EQ(m->inertiaCoefficient(1), 1);
}

TEST(PorousModel, TheInertiaIntegralIsThatOfThePapersEquation6)
{
    const auto m = model("ergun", "porosity 0.4; D50 0.01;");
    const Real y = 1 / 0.4;   // C_r = 0.66 + 0.34 y
    EXPECT_NEAR(m->inertiaIntegral(0.4), 0.66 * (sqr(y) - 1) + 2 * 0.34 / 3 * (cube(y) - 1),
                10 * exact);
    EXPECT_EQ(m->inertiaIntegral(1), 0);
}

/// The rows of a csv below its header, comments and the header left out.
std::vector<std::vector<std::string>> rows(const std::string& file)
{
    std::vector<std::vector<std::string>> all;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        all.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
    }
    if (!all.empty()) all.erase(all.begin());
    return all;
}

TEST(PorousModel, AgreesWithTheTableOfTheLiterature)
{
    const auto table = rows(ISPH_REFERENCE_DIR "/porous_resistance_literature_spread.csv");
    if (table.empty())
        GTEST_SKIP() << "no porous_resistance_literature_spread.csv in " ISPH_REFERENCE_DIR;
    int compared = 0;
    for (const auto& row : table) {  // material,n,D_m,author,alpha_c,beta_c,a_1_s,b_1_m,K_m2,...
        const std::string soil = "porosity " + row[1] + "; D50 " + row[2] + ";";
        std::unique_ptr<PorousModel> m;
        if (row[3].find("paper") == 0) m = model("akbari", soil);
        if (row[3].find("Liu") == 0) m = model("akbari", soil + " alphaC 200;");
        if (row[3].find("Ergun") == 0) m = model("ergun", soil);
        if (row[3].find("Engelund") == 0) m = model("engelund", soil);
        if (row[3].find("Jensen") == 0)
            m = model("vanGent", soil + " alphaC 500; betaC 2.0; KC 128;");
        if (!m) continue;
        const Resistance r = m->resistance(m->porosity(), 1e-6);
        EXPECT_NEAR(r.linear / std::stod(row[6]), 1, 1e-5)
            << row[0] << " " << row[3];  // 6 digits printed
        EXPECT_NEAR(r.quadratic / std::stod(row[7]), 1, 1e-5) << row[0] << " " << row[3];
        ++compared;
    }
    EXPECT_GE(compared, 5);
}

TEST(PorousModel, PorosityAndGrainDiameterMustBePossible)
{
    for (const std::string porosity : {"0", "1", "1.2", "-0.1"}) {
        const std::string text = refusal("akbari", "porosity " + porosity + "; D50 0.01;");
        EXPECT_NE(text.find("porosity"), std::string::npos) << text;
        EXPECT_NE(text.find("> 0 and < 1"), std::string::npos) << text;
    }
    EXPECT_NE(refusal("ergun", "porosity 0.4; D50 0;").find("D50"), std::string::npos);
    EXPECT_NE(refusal("darcy", "porosity 0.4; K -1e-9;").find("K"), std::string::npos);
    EXPECT_NE(refusal("darcy", "porosity 0.4; K [0 1 0 0 0 0 0] 1e-9;").find("dimensions"),
              std::string::npos);
}

TEST(PorousModel, AMisspelledOrMissingKeyIsRefused)
{
    EXPECT_NE(refusal("akbari", "porosity 0.4; D50 0.01; alphac 1000;").find("alphaC"),
              std::string::npos);
    EXPECT_NE(refusal("vanGent", "porosity 0.4; D50 0.01;").find("KC"), std::string::npos);
    EXPECT_THROW(PorousModel::select(Dictionary::parse("porousModel ergun; ergunCoefs {}")),
                 FatalIOError);
    EXPECT_THROW(PorousModel::select(Dictionary::parse("porousModel ergun;")), FatalIOError);
}

TEST(PorousModel, ChangingTheModelIsChangingOneWord)
{
    const std::string soils =
        "akbariCoeffs { porosity 0.4; D50 0.01; }  ergunCoeffs { porosity 0.4; D50 0.01; }";
    const auto a = PorousModel::select(Dictionary::parse("porousModel akbari; " + soils));
    const auto b = PorousModel::select(Dictionary::parse("porousModel ergun; " + soils));
    EXPECT_NEAR(intact(*a).linear / intact(*b).linear, 1000.0 / 150, exact);
}

TEST(PorousModel, AnUnknownModelIsRefusedInOpenFOAMsWords)
{
    const std::string text = refusal("foo", "porosity 0.4;");
    EXPECT_EQ(
        text.find(
            "Unknown porousModel type foo\n\nValid porousModel types are:\n\n6\n(\n    akbari\n"),
        0)
        << text;
}

TEST(PorousModel, TheLogTellsFormulaAndResultingCoefficients)
{
    const auto m = model("akbari", "porosity 0.49; D50 0.0159; betaC 2.0;");
    const std::string text = describe("rubble", *m, 1e-6);
    // a = 1000*1e-6*0.51^2/(0.49^3*0.0159^2) = 8.745, b = 2*0.51/(0.49^3*0.0159) = 545.3 by hand
    for (const std::string part :
         {"Porous zone rubble", "akbari: a = 1000 nu", "D50 = 0.0159 m", "porosity = 0.49",
          "a = 8.745 [1/s]", "b = 545.3 [1/m]", "K = 1.144e-07 [m^2]", "C_r = 1.354"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

}  // namespace
