// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "dictionary/Schema.hpp"

namespace isph {
namespace {

using testing::failureOf;
using testing::says;

Schema drag()
{
    return {Key::scalar("porosity", "Share of pores in the volume.").above(0).below(1),
            Key::scalar("D50", "Median grain size.").units(dims::length).above(0),
            Key::scalar("alphaC", "Factor of the linear term.").byDefault("1000").atLeast(0),
            Key::word("law", "How it is averaged.")
                .byDefault("harmonic")
                .oneOf({"harmonic", "arithmetic"}),
            Key::integer("order", "Order.").mayBeAbsent().atMost(4),
            Key::logical("log", "Prints.").byDefault("no"),
            Key::vector("axis", "Axis.").mayBeAbsent(),
            Key::list("fields", "Fields.").mayBeAbsent().oneOf({"U", "p"}),
            Key::dictionary("coeffs", "Coefficients.").mayBeAbsent()};
}

testing::Failure check(const std::string& text)
{
    return failureOf([&] { drag().check(Dictionary::parse(text, "case/constant/porousZones")); });
}

const std::string kGood = "porosity 0.4;\nD50 [mm] 20;\n";

TEST(Schema, AcceptsADictionaryThatFollowsIt)
{
    EXPECT_EQ(check(kGood).line, -1);
    EXPECT_EQ(
        check(kGood + "law arithmetic; order 4; log on; axis (0 0 1); fields (U p); coeffs { }")
            .line,
        -1);
    EXPECT_EQ(check("FoamFile { object x; } " + kGood).line, -1);
}

TEST(Schema, AnUnknownKeyNamesFileLineNearestKeyAndTheValidOnes)
{
    const auto failure = check(kGood + "alphac 3;");
    EXPECT_EQ(failure.file, "case/constant/porousZones");
    EXPECT_EQ(failure.line, 3);
    EXPECT_TRUE(says(failure, "Unknown keyword alphac"));
    EXPECT_TRUE(says(failure, "Did you mean 'alphaC'?"));
    EXPECT_TRUE(says(failure, "9\n(\n    D50\n    alphaC\n"));
}

TEST(Schema, AMissingKeyIsNamedWithItsMeaning)
{
    const auto failure = check("porosity 0.4;");
    EXPECT_TRUE(
        says(failure, "keyword D50 is undefined in dictionary \"case/constant/porousZones\""));
    EXPECT_TRUE(says(failure, "Median grain size."));
}

TEST(Schema, ValuesAtAndBeyondTheEndsOfTheRangeAreRefused)
{
    for (const char* value : {"0", "1", "1.2", "-0.1"}) {
        const auto failure = check(std::string("D50 1;\nporosity ") + value + ";");
        EXPECT_EQ(failure.line, 2) << value;
        EXPECT_TRUE(says(failure, "allowed: porosity > 0 and < 1")) << value;
    }
    EXPECT_EQ(check(kGood + "alphaC 0;").line, -1) << "atLeast includes its end";
    EXPECT_TRUE(says(check(kGood + "order 5;"), "allowed: order <= 4"));
}

TEST(Schema, WrongTypesDimensionsAndWordsAreRefused)
{
    EXPECT_TRUE(says(check("porosity 0.4; D50 [s] 1;"), "do not match the required dimensions"));
    EXPECT_TRUE(says(check(kGood + "law median;"), "median is not in enumeration"));
    EXPECT_TRUE(says(check(kGood + "fields (U T);"), "T is not in enumeration"));
    EXPECT_TRUE(says(check(kGood + "fields U;"), "expected a list"));
    EXPECT_TRUE(says(check(kGood + "fields [m] (U);"), "do not match the required dimensions"));
    EXPECT_TRUE(says(check(kGood + "order 1.5;"), "whole number"));
    EXPECT_TRUE(says(check(kGood + "log perhaps;"), "switch"));
    EXPECT_TRUE(says(check(kGood + "axis 1;"), "vector"));
    EXPECT_TRUE(says(check(kGood + "coeffs 1;"), "not a sub-dictionary"));
}

TEST(Schema, PatternsAreKnownWhereTheyMatchAKey)
{
    EXPECT_EQ(check(kGood + "\"(alpha|beta)C\" 3;").line, -1);
    EXPECT_EQ(check(kGood + "\"gamma.*\" 3;").line, 3);
}

TEST(Schema, AnOpenSchemaTakesTheUsersNames)
{
    Schema zones = Schema{Key::scalar("n", "N.").byDefault("1")}.open();
    EXPECT_EQ(failureOf([&] { zones.check(Dictionary::parse("rubble { }")); }).line, -1);
}

TEST(Schema, GivesTheValueOrTheDefault)
{
    const auto dict = Dictionary::parse(kGood + "alphaC 5;");
    EXPECT_DOUBLE_EQ(drag().get<Real>(dict, "D50"), 0.02);
    EXPECT_EQ(drag().get<Real>(dict, "alphaC"), 5);
    EXPECT_EQ(drag().get<std::string>(dict, "law"), "harmonic");
    EXPECT_FALSE(drag().get<bool>(dict, "log"));
    EXPECT_TRUE(
        says(failureOf([&] { drag().get<int>(dict, "order"); }), "keyword order is undefined"));
}

TEST(Schema, TheAnnotatedDictionaryHasTheDefaultsAndExplainsEveryKey)
{
    const Schema schema = drag();
    const std::string text = schema.annotated();
    const auto dict = Dictionary::parse(text);
    EXPECT_EQ(dict.keywords(), (std::vector<std::string>{"alphaC", "law", "log"}))
        << "keys without a default are comments";
    EXPECT_EQ(dict.get<Real>("alphaC"), 1000);
    for (const Key& key : schema.keys()) {
        EXPECT_NE(text.find(key.name + " "), std::string::npos) << key.name;
        EXPECT_NE(text.find(key.description), std::string::npos) << key.name;
    }
    EXPECT_NE(text.find("[0 1 0 0 0 0 0], > 0, required: Median grain size."), std::string::npos)
        << text;
}

}  // namespace
}  // namespace isph
