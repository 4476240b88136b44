// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

using namespace isph;
using namespace isph::test;

namespace {

enum Column { L1, L2, Linf, bias, samples };

/// 20 x 10 particles in a tank without walls' influence on what is measured.
FlowView block(const std::function<Real(const Vector3&)>& p)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    setPressure(flow, p);
    return flow;
}

std::vector<Real> norms(const FlowView& flow, const std::string& keys)
{
    auto object = make("type errorNorms; " + keys);
    const std::vector<Real> row = object->measure(flow);
    EXPECT_EQ(row.size(), object->columns().size());
    return row;
}

std::string failure(const FlowView& flow, const std::string& keys)
{
    try {
        norms(flow, keys);
    } catch (const FatalError& error) {
        return error.what();
    }
    return "no error";
}

/// A case folder with a csv in it, named by FOAM_CASE while it lives.
class ReferenceFile {
public:
    explicit ReferenceFile(const std::string& text)
        : folder_(std::filesystem::temp_directory_path() /
                  ("isphErrorNorms." + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
        std::ofstream(folder_ / "ref.csv") << text;
        setenv("FOAM_CASE", folder_.c_str(), 1);
    }
    ~ReferenceFile()
    {
        unsetenv("FOAM_CASE");
        std::filesystem::remove_all(folder_);
    }

private:
    std::filesystem::path folder_;
};

}  // namespace

TEST(ErrorNorms, OfAFieldThatIsAsExpectedAreZero)
{
    FlowView flow = block([](const Vector3& x) { return 3 + 2 * x[0] - x[1]; });
    const std::vector<Real> row = norms(flow, "field p; expression \"3 + 2*x - y\";");
    for (const Column c : {L1, L2, Linf, bias})
        EXPECT_NEAR(row[c], 0, 1e-14) << c;  // rounding of 3
    EXPECT_EQ(row[samples], 200);
}

TEST(ErrorNorms, OfTwoValuesHaveTheirExactMeans)
{
    // Half of the water is off by +3, half by -1: |e| 3 and 1, e^2 9 and 1.
    const FlowView flow = block([](const Vector3& x) { return x[0] < 0.1 ? 3 : -1; });
    const std::vector<Real> row = norms(flow, "field p; expression \"0\";");
    EXPECT_NEAR(row[L1], 2, 1e-13);
    EXPECT_NEAR(row[L2], std::sqrt(5), 1e-13);
    EXPECT_EQ(row[Linf], 3);
    EXPECT_NEAR(row[bias], 1, 1e-13);
}

TEST(ErrorNorms, UpToAConstantLeaveTheBiasOut)
{
    const FlowView flow = block([](const Vector3& x) { return x[0] < 0.1 ? 3 : -1; });
    const std::vector<Real> row = norms(flow, "field p; expression \"0\"; upToConstant yes;");
    for (const Column c : {L1, L2, Linf}) EXPECT_NEAR(row[c], 2, 1e-13) << c;
    EXPECT_NEAR(row[bias], 1, 1e-13);
}

TEST(ErrorNorms, WeighAParticleInSoilByTheSpaceThatItOccupies)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.1, 0.1, 0});          // 100 particles, p = 0
    addWater(flow, {0.1, 0, 0}, {0.2, 0.1, 0}, 0.25);  // 25 of four times the space
    for (std::size_t i = 100; i < 125; ++i) flow.scalars["p"][i] = 2;
    const std::vector<Real> row = norms(flow, "field p; expression \"0\";");
    EXPECT_NEAR(row[L1], 1, 1e-13);
    EXPECT_NEAR(row[L2], std::sqrt(2), 1e-13);
    EXPECT_EQ(row[samples], 125);
}

TEST(ErrorNorms, OfAVectorAreThoseOfItsLength)
{
    FlowView flow = block([](const Vector3&) { return 0; });
    setVelocity(flow, [](const Vector3& x) { return Vector3{-x[1] + 3, x[0] - 4, 0}; });
    for (const char* z : {"", " \"0\""}) {
        const std::vector<Real> row =
            norms(flow, std::string("field U; expressions (\"-y\" \"x\"") + z + ");");
        for (const Column c : {L1, L2, Linf}) EXPECT_NEAR(row[c], 5, 1e-13) << c;
        EXPECT_NEAR(row[3], 3, 1e-13);
        EXPECT_NEAR(row[4], -4, 1e-13);
    }
    EXPECT_NEAR(norms(flow, "field U.y; expression \"x\";")[bias], -4, 1e-13);
    const std::vector<Real> speed =
        norms(flow, "field \"mag(U)\"; expression \"hypot(3 - y, x - 4)\";");
    EXPECT_NEAR(speed[Linf], 0, 1e-14);
}

TEST(ErrorNorms, KnowTimeAndConstantsAndDivideByTheScale)
{
    FlowView flow = block([](const Vector3&) { return 0; });
    flow.time = 2;
    const std::string keys =
        "field p; expression \"-A*exp(-b*t)\"; constants { A 4; twice \"2*A\"; b \"twice/16\"; } ";
    EXPECT_NEAR(norms(flow, keys)[bias], 4 * std::exp(-1), 1e-13);
    EXPECT_NEAR(norms(flow, keys + "scale \"A*exp(-b*t)\";")[Linf], 1, 1e-14);
    EXPECT_NEAR(norms(flow, keys + "scale largest;")[Linf], 1, 1e-14);
}

TEST(ErrorNorms, TakeConstantsInSiUnitsFromAFileOfTheCase)
{
    const FlowView flow = block([](const Vector3&) { return 0; });
    const std::string zone =
        "sand { porousModel akbari; akbariCoeffs { D50 [mm] 5; porosity 0.4; } names (a b); }";
    EXPECT_NEAR(norms(flow, "field p; expression \"-D50/porosity - c\"; constants { " + zone +
                                " nu [0 2 -1 0 0 0 0] 1e-6; c \"2*nu\"; }")[bias],
                0.0125 + 2e-6, 1e-15);
}

TEST(ErrorNorms, CountOnlyTheParticlesOfTheRegion)
{
    const FlowView flow = block([](const Vector3& x) { return x[0] < 0.1 ? 3 : -1; });
    const std::vector<Real> row = norms(
        flow, "field p; expression \"0\"; region { type box; min (0 0 0); max (0.1 0.05 0); }");
    EXPECT_EQ(row[samples], 50);
    EXPECT_NEAR(row[bias], 3, 1e-13);
}

TEST(ErrorNorms, AtPointsAreExactForALinearFieldOnJitteredParticles)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    jitter(flow, 0.2);
    setPressure(flow, [](const Vector3& x) { return 1 + x[0] - 2 * x[1]; });
    const std::vector<Real> row = norms(flow,
                                        "field p; expression \"x - 2*y\"; at points; "
                                        "points ((0.1 0.05) (0 0.03) (0.1 0.5) (0.1 0));");
    EXPECT_EQ(row[samples], 3);  // one of them is in the air
    for (const Column c : {L1, L2, Linf, bias}) EXPECT_NEAR(row[c], 1, 1e-12) << c;
}

TEST(ErrorNorms, AgainstAProfileInterpolateItsRows)
{
    const ReferenceFile file("# y, value\ny,u,p\n0.2,5,0.4\n0.05,0,0.1\n0,7,0\n");  // p = 2 y
    FlowView flow = block([](const Vector3& x) { return 2 * x[1] + 0.5; });
    const std::string reference =
        "field p; reference { file \"ref.csv\"; along y; coordinate y; value p; }";
    const std::vector<Real> row = norms(flow, reference);
    EXPECT_EQ(row[samples], 200);
    for (const Column c : {L1, L2, Linf, bias}) EXPECT_NEAR(row[c], 0.5, 1e-13) << c;
    const std::vector<Real> rows = norms(flow, reference + "at profile; through (0.1 0 0);");
    EXPECT_EQ(rows[samples], 2);  // one of three is in the air
    EXPECT_NEAR(rows[Linf], 0.5, 1e-12);
}

TEST(ErrorNorms, AgainstATimeSeriesTakeTheValueOfTheTime)
{
    const ReferenceFile file("0,0\n4,8\n");
    FlowView flow = block([](const Vector3&) { return 5; });
    flow.time = 1;
    const std::string keys = "field p; reference { file \"ref.csv\"; along t; }";
    EXPECT_NEAR(norms(flow, keys)[bias], 3, 1e-13);
    flow.time = 5;  // beyond the data
    EXPECT_NE(failure(flow, keys).find("within the reference"), std::string::npos);
}

TEST(ErrorNorms, SayWhatIsWrongWithTheirDictionary)
{
    const FlowView flow = block([](const Vector3&) { return 0; });
    const auto says = [&](const std::string& keys, const std::string& words) {
        const std::string text = failure(flow, keys);
        EXPECT_NE(text.find(words), std::string::npos) << keys << "\n" << text;
    };
    says("field p;", "needs one of expression");
    says("field p; expression \"2*(x\";", "2*(x");
    says("field q; expression \"0\";", "Unknown field q");
    says("field p.x; expression \"0\";", "Unknown vector field p");
    says("field U; expression \"0\";", "has 2 components, but 1");
    says("field p; expression \"0\"; at points;", "points belongs to at points; it is missing");
    says("field p; expression \"0\"; through (0 0 0);",
         "through belongs to at profile; it is here");
    says("field p; reference { file \"gone.csv\"; along y; }", "gone.csv");
    says("field p; expression \"0\"; scale \"t\";", "errors cannot be divided by it");
    says("field p; expression \"0\"; region { type box; min (5 5 5); max (6 6 6); }",
         "no particle or point");
}

TEST(ErrorNorms, OfAFieldThatIsNoNumberAreNone)
{
    const FlowView flow = block([](const Vector3& x) { return x[0] < 0.1 ? 1 : std::nan(""); });
    const std::vector<Real> row = norms(flow, "field p; expression \"0\";");
    for (const Column c : {L1, L2, Linf}) EXPECT_TRUE(std::isnan(row[c])) << c;
}

TEST(WaterExtent, OfABlockThatTurnsIsThatOfItsLattice)
{
    FlowView flow = emptyTank({});
    addWater(flow, {0, 0, 0}, {0.2, 0.1, 0});
    setVelocity(flow, [](const Vector3& x) { return Vector3{7 - 2 * x[1], 3 + 2 * x[0], 0}; });
    const std::vector<Real> row = make("type waterExtent;")->measure(flow);
    ASSERT_EQ(row.size(), make("type waterExtent;")->columns().size());
    // 20 x 10 points 0.01 apart: the variance of n points is (n^2 - 1)/12 of the spacing's square.
    const Real varX = 1e-4 * 399 / 12, varY = 1e-4 * 99 / 12;
    const std::vector<Real> expected{0.005,
                                     0.195,
                                     0.1,
                                     std::sqrt(varX),
                                     0.005,
                                     0.095,
                                     0.05,
                                     std::sqrt(varY),
                                     20 * 2 * (varX + varY),
                                     0.02,
                                     200};
    for (std::size_t k = 0; k < row.size(); ++k) EXPECT_NEAR(row[k], expected[k], 1e-13) << k;
}
