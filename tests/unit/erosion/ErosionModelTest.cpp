// SPDX-License-Identifier: GPL-3.0-or-later
#include "erosion/ErosionModel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace isph;

namespace {

constexpr Real g = 9.81, rho = 998;

std::unique_ptr<ErosionModel> model(const std::string& coefficients)
{
    return ErosionModel::select(Dictionary::parse(
        "erosionModel thresholdVelocity;\nthresholdVelocityCoeffs\n{ " + coefficients + " }\n",
        "erosionProperties"));
}

Real limit(const ErosionModel& m, Real theta)
{
    std::vector<Real> u{-1};
    m.threshold(std::vector<Real>{theta}, rho, g, u);
    return u[0];
}

const std::string kOdd =
    "D50 0.003; solidDensity 2400; frictionCoefficient 0.6; dragCoefficient 0.7; "
    "liftCoefficient 0.3; areaCoefficient 0.9; volumeCoefficient 0.4; minSlopeFactor 0;";
// Tolerance: the same algebra in another order, a few roundings.
constexpr Real exact = 1e-14;

TEST(ThresholdVelocity, DownslopeItIsThePapersEquation18)
{
    const auto m = model(kOdd);
    for (const Real theta : {0.0, 0.1, 0.3, 0.5}) {
        const Real u = std::sqrt(2 * 0.4 * (0.6 * std::cos(theta) - std::sin(theta)) *
                                 (2400 / rho - 1) * g * 0.003 / ((0.7 + 0.6 * 0.3) * 0.9));
        EXPECT_NEAR(limit(*m, theta) / u, 1, exact) << theta;
    }
}

TEST(ThresholdVelocity, UpslopeItIsThePapersEquation19)
{
    const auto m = model(kOdd);
    for (const Real theta : {0.0, 0.1, 0.3, 0.5, 1.0}) {
        const Real u = std::sqrt(2 * 0.4 * (0.6 * std::cos(theta) + std::sin(theta)) *
                                 (2400 / rho - 1) * g * 0.003 / ((0.7 + 0.6 * 0.3) * 0.9));
        EXPECT_NEAR(limit(*m, -theta) / u, 1, exact) << theta;
    }
}

TEST(ThresholdVelocity, TheSlopeActsAsTheSineOfTheAngleLeftToRepose)
{
    const Real phi = std::atan(0.6), beta = 0.35;  // Soulsby (1997), eqs 80b, c
    const auto m = model(kOdd);
    EXPECT_NEAR(sqr(limit(*m, beta) / limit(*m, 0)) * std::sin(phi) / std::sin(phi - beta), 1,
                10 * exact);
    EXPECT_NEAR(sqr(limit(*m, -beta) / limit(*m, 0)) * std::sin(phi) / std::sin(phi + beta), 1,
                10 * exact);
}

TEST(ThresholdVelocity, BeyondTheAngleOfReposeItKeepsItsFloor)
{
    const auto bare = model(kOdd), floored = model("D50 0.003;");
    for (const Real theta : {std::atan(0.6) + 1e-9, 0.8, 1.5, 3.0})
        EXPECT_EQ(limit(*bare, theta), 0) << theta;
    for (const Real theta : {std::atan(0.65), 0.8, 1.5})
        EXPECT_NEAR(sqr(limit(*floored, theta) / limit(*floored, 0)), 0.1, 10 * exact) << theta;
}

TEST(ThresholdVelocity, DefaultsAreASphereOfQuartz)
{
    const auto m = model("D50 0.003;");
    const Real u2 = 2 * std::numbers::pi / 6 * 0.65 * (2650 / rho - 1) * g * 0.003 /
                    ((0.4 + 0.65 * 0.2) * std::numbers::pi / 4);
    EXPECT_NEAR(sqr(limit(*m, 0)) / u2, 1, exact);
    EXPECT_EQ(m->solidDensity(), 2650);
    EXPECT_EQ(m->grainDiameter(), 0.003);
}

TEST(ThresholdVelocity, GrainsThatFloatHaveNone)
{
    EXPECT_EQ(limit(*model("D50 0.003; solidDensity 900;"), 0), 0);
}

TEST(ThresholdVelocity, AgreesWithTheTableOfFlatBeds)
{
    std::ifstream table(ISPH_REFERENCE_DIR "/eq18_flat_bed_vs_shields.csv");
    if (!table) GTEST_SKIP() << "no eq18_flat_bed_vs_shields.csv in " ISPH_REFERENCE_DIR;
    int compared = 0;
    for (std::string line; std::getline(table, line);) {
        std::istringstream cells(line);
        Real diameter = 0, u = 0;  // d_mm, u_CD0.4
        char comma = 0;
        if (line[0] == '#' || !(cells >> diameter >> comma >> u)) continue;
        const auto m =
            model("D50 " + std::to_string(1e-3 * diameter) + "; frictionCoefficient 0.65;");
        std::vector<Real> limit(1);
        m->threshold(std::vector<Real>{0}, 1000, g, limit);
        EXPECT_NEAR(limit[0], u, 0.6e-5) << diameter << " mm";  // five decimals printed
        ++compared;
    }
    EXPECT_GE(compared, 9);
}

TEST(ThresholdVelocity, GrainSizeIsRequiredAndKeysAreChecked)
{
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            model(text);
        } catch (const FatalIOError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(refusal("").find("D50"), std::string::npos);
    EXPECT_NE(refusal("D50 0.001; dragcoefficient 1;").find("dragCoefficient"), std::string::npos);
    EXPECT_NE(refusal("D50 0.001; minSlopeFactor 2;").find("minSlopeFactor"), std::string::npos);
    EXPECT_NE(refusal("D50 [kg] 0.001;").find("dimensions"), std::string::npos);
}

TEST(ErosionModel, AnUnknownModelIsRefused)
{
    EXPECT_THROW(ErosionModel::select(Dictionary::parse("erosionModel shields;")), FatalIOError);
}

}  // namespace
