// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "dictionary/Dictionary.hpp"

namespace isph {
namespace {

using testing::failureOf;
using testing::says;
using Words = std::vector<std::string>;

TEST(Values, NumbersOfAllSpellings)
{
    const auto dict = Dictionary::parse("a -1.5e-3; b +.5; c 5.; d 12; e -0; f 1e6;");
    EXPECT_EQ(dict.get<Real>("a"), -1.5e-3);
    EXPECT_EQ(dict.get<Real>("b"), 0.5);
    EXPECT_EQ(dict.get<Real>("c"), 5.0);
    EXPECT_EQ(dict.get<int>("d"), 12);
    EXPECT_EQ(dict.get<int>("e"), 0);
    EXPECT_EQ(dict.get<int>("f"), 1000000);
}

TEST(Values, SwitchesAreTheSixWords)
{
    const auto dict = Dictionary::parse("a yes; b on; c true; d no; e off; f false; g maybe; h 1;");
    for (const char* key : {"a", "b", "c"}) EXPECT_TRUE(dict.get<bool>(key)) << key;
    for (const char* key : {"d", "e", "f"}) EXPECT_FALSE(dict.get<bool>(key)) << key;
    EXPECT_TRUE(says(failureOf([&] { dict.get<bool>("g"); }), "yes, no, on, off, true or false"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<bool>("h"); }), "expected a switch"));
}

TEST(Values, VectorsHaveThreeComponentsAndPointsOfListsMayHaveTwo)
{
    const auto dict = Dictionary::parse("g (0 -9.81 0); p ((0 0) (1 2) (3 4 5)); two (1 2);");
    EXPECT_EQ(dict.get<Vector3>("g"), (Vector3{0, -9.81, 0}));
    EXPECT_EQ(dict.get<std::vector<Vector3>>("p"),
              (std::vector<Vector3>{{0, 0, 0}, {1, 2, 0}, {3, 4, 5}}));
    EXPECT_TRUE(says(failureOf([&] { dict.get<Vector3>("two"); }), "expected a vector (x y z)"));
}

TEST(Values, ListsOfExpressionsTakeNumbersAsText)
{
    const auto dict = Dictionary::parse(R"--(velocity ("sin(x)" 0 -1.5);)--");
    EXPECT_EQ(dict.get<Words>("velocity"), (Words{"sin(x)", "0", "-1.5"}));
}

TEST(Values, AWrongTypeNamesKeyDictionaryValueAndWhatIsExpected)
{
    const auto dict = Dictionary::parse(
        "\nnu abc;\nn 1.5;\nl 3(1 2);\nv 1 2;\ns { }\nw (1 2);\nbig 3000000000;", "case/x");
    const auto failure = failureOf([&] { dict.get<Real>("nu"); });
    EXPECT_EQ(failure.line, 2);
    EXPECT_EQ(failure.file, "case/x");
    EXPECT_TRUE(says(failure,
                     "keyword nu in dictionary \"case/x\" has the value 'abc': expected a number"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<int>("n"); }), "expected a whole number"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<int>("big"); }), "expected a whole number"));
    EXPECT_TRUE(
        says(failureOf([&] { dict.get<std::vector<Real>>("l"); }), "has 2 elements, not the 3"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<Real>("v"); }), "'2' follows the value"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<Real>("s"); }), "is a sub-dictionary"));
    EXPECT_TRUE(
        says(failureOf([&] { dict.get<std::string>("w"); }), "expected a word or a string"));
    EXPECT_TRUE(says(failureOf([&] { dict.subDict("nu"); }), "is not a sub-dictionary"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<std::vector<Real>>("nu"); }), "expected a list"));
}

TEST(Values, AMissingSemicolonIsSuspectedWhereTheValueGoesOnInTheNextLine)
{
    const auto dict = Dictionary::parse("a 1\nb 2;");
    EXPECT_TRUE(
        says(failureOf([&] { dict.get<Real>("a"); }), "Is a ';' missing before 'b' in line 2?"));
}

TEST(Values, AnUndefinedKeywordIsReportedInOpenFoamsWordsWithTheNearest)
{
    const auto dict = Dictionary::parse("\nendTme 2;", "case/system/controlDict");
    const auto failure = failureOf([&] { dict.get<Real>("endTime"); });
    EXPECT_TRUE(
        says(failure, "keyword endTime is undefined in dictionary \"case/system/controlDict\""));
    EXPECT_TRUE(says(failure, "Did you mean 'endTme' (line 2)?"));
    EXPECT_EQ(dict.getOrDefault<Real>("endTime", 3.0), 3.0);
}

TEST(Values, AChoiceOutsideTheListIsReportedInOpenFoamsWords)
{
    const auto dict = Dictionary::parse("startFrom latstTime;");
    const Words allowed{"startTime", "firstTime", "latestTime"};
    const auto failure = failureOf([&] { dict.getChoice("startFrom", allowed); });
    EXPECT_TRUE(says(failure,
                     "latstTime is not in enumeration: 3\n(\n    firstTime\n    latestTime\n    "
                     "startTime\n)\n"));
    EXPECT_TRUE(says(failure, "Did you mean 'latestTime'?"));
    EXPECT_EQ(dict.getChoice("stopAt", {"endTime"}, "endTime"), "endTime");
}

TEST(Dimensions, AreReadAsSetsAsUnitsAndInTheOldForm)
{
    const auto dict = Dictionary::parse(
        R"(a [0 2 -1 0 0 0 0] 1e-6; b [m^2/s] 1e-6; c nu [0 2 -1 0 0] 1e-6; d 1e-6;
        rho [kg m^-3] 1000; mu [Pa s] 1e-3; mu2 [kg/(m s)] 1e-3; g [m s^-2] (0 -9.81 0); n [] 0.4; m [-] 0.4; r [1/s] 2;)");
    for (const char* key : {"a", "b", "c", "d"})
        EXPECT_EQ(dict.get<Real>(key, dims::kinematicViscosity), 1e-6) << key;
    EXPECT_EQ(dict.get<Real>("rho", dims::density), 1000);
    EXPECT_EQ(dict.get<Real>("mu", dims::pressure * dims::time), 1e-3);
    EXPECT_EQ(dict.get<Real>("mu2", dims::pressure * dims::time), 1e-3);
    EXPECT_EQ(dict.get<Vector3>("g", dims::acceleration)[1], -9.81);
    EXPECT_EQ(dict.get<Real>("n"), 0.4);
    EXPECT_EQ(dict.get<Real>("m"), 0.4);
    EXPECT_EQ(dict.get<Real>("r", dims::rate), 2);
}

TEST(Dimensions, PrefixesAndUnitsOutsideTheSiScaleTheValue)
{
    const auto dict = Dictionary::parse(
        "d [mm] 15.9; p [kPa] 2; t [h] 0.5; l [cm] (1 2 3); a [mm^2] 1; rho [g/cm^3] 1;");
    EXPECT_DOUBLE_EQ(dict.get<Real>("d", dims::length), 15.9e-3);
    EXPECT_DOUBLE_EQ(dict.get<Real>("p", dims::pressure), 2000);
    EXPECT_DOUBLE_EQ(dict.get<Real>("t", dims::time), 1800);
    EXPECT_DOUBLE_EQ(dict.get<std::vector<Real>>("l", dims::length)[2], 0.03);
    EXPECT_DOUBLE_EQ(dict.get<Real>("a", dims::area), 1e-6);
    EXPECT_NEAR(dict.get<Real>("rho", dims::density), 1000, 1000 * 1e-15);  // one pow, one product
}

TEST(Dimensions, AMismatchIsFatalInOpenFoamsWords)
{
    const auto dict = Dictionary::parse("\nnu [m/s] 1e-6;\nx [furlong] 1;\ny [0 1] 2;");
    const auto failure = failureOf([&] { dict.get<Real>("nu", dims::kinematicViscosity); });
    EXPECT_TRUE(says(failure,
                     "The dimensions [0 1 -1 0 0 0 0] provided do not match the required "
                     "dimensions [0 2 -1 0 0 0 0]"));
    EXPECT_EQ(failure.line, 2);
    EXPECT_TRUE(
        says(failureOf([&] { dict.get<Real>("nu"); }), "required dimensions [0 0 0 0 0 0 0]"));
    EXPECT_TRUE(
        says(failureOf([&] { dict.get<Real>("x", dims::length); }), "'[furlong]' is neither"));
    EXPECT_TRUE(says(failureOf([&] { dict.get<Real>("y", dims::length); }), "'[0 1]' is neither"));
}

}  // namespace
}  // namespace isph
