// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "TempFolder.hpp"
#include "dictionary/Schema.hpp"

#include <cstdlib>

namespace isph {
namespace {

using testing::failureOf;
using testing::says;
using Words = std::vector<std::string>;

TEST(Macros, TakeTheValueOfThisOrAnEnclosingDictionary)
{
    const auto dict = Dictionary::parse(
        "H 0.35; s { H 1; t { a $H; b ${H}; c (0 $H 0); } } d $H; word top; open (left $word);");
    const Dictionary& t = dict.subDict("s").subDict("t");
    EXPECT_EQ(t.get<Real>("a"), 1.0) << "the nearest one";
    EXPECT_EQ(t.get<Real>("b"), 1.0);
    EXPECT_EQ(t.get<Vector3>("c"), (Vector3{0, 1, 0}));
    EXPECT_EQ(dict.get<Real>("d"), 0.35);
    EXPECT_EQ(dict.get<Words>("open"), (Words{"left", "top"}));
}

TEST(Macros, SlashSyntaxReachesParentsTheTopAndSubDictionaries)
{
    const auto dict = Dictionary::parse(R"(
        a 1; g { a 2; h { a 3; } }
        s { a 4; t { a 5; up $../a; upup $../../a; top $!a; deep $!g/h/a; below ${g/a}; side $../../g/h/a; } })");
    const Dictionary& t = dict.subDict("s").subDict("t");
    EXPECT_EQ(t.get<int>("up"), 4);
    EXPECT_EQ(t.get<int>("upup"), 1);
    EXPECT_EQ(t.get<int>("top"), 1);
    EXPECT_EQ(t.get<int>("deep"), 3);
    EXPECT_EQ(t.get<int>("below"), 2);
    EXPECT_EQ(t.get<int>("side"), 3);
}

TEST(Macros, DotSyntaxReachesParentsTheTopAndSubDictionaries)
{
    const auto dict = Dictionary::parse(R"(
        a 1; g { a 2; h { a 3; } } alpha.water 6;
        s { a 4; t { a 5; here $.a; up $..a; upup $...a; top $:a; deep $:g.h.a; below ${g.a}; dotted $alpha.water; } })");
    const Dictionary& t = dict.subDict("s").subDict("t");
    EXPECT_EQ(t.get<int>("here"), 5);
    EXPECT_EQ(t.get<int>("up"), 4);
    EXPECT_EQ(t.get<int>("upup"), 1);
    EXPECT_EQ(t.get<int>("top"), 1);
    EXPECT_EQ(t.get<int>("deep"), 3);
    EXPECT_EQ(t.get<int>("below"), 2);
    EXPECT_EQ(t.get<int>("dotted"), 6) << "a dot may belong to the keyword";
}

TEST(Macros, InputSyntaxAllowsOneSpellingOnly)
{
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a 1; #inputSyntax slash\ns { b $..a; }"); }),
                     "\"..a\""));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a 1; #inputSyntax dot\ns { b $../a; }"); }),
                     "\"../a\""));
    EXPECT_EQ(Dictionary::parse("a 1; #inputSyntax dot\ns { b $..a; }").subDict("s").get<int>("b"),
              1);
    EXPECT_EQ(
        Dictionary::parse("a 1; #inputSyntax slash\ns { b $../a; }").subDict("s").get<int>("b"), 1);
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("#inputSyntax comma"); }),
                     "comma is not in enumeration"));
}

TEST(Macros, TheEnvironmentComesAfterTheEntries)
{
    setenv("ISPH_TEST_NUMBER", "0.25", 1);
    setenv("ISPH_TEST_PATH", "/a b/c", 1);
    const auto dict = Dictionary::parse(
        R"(n $ISPH_TEST_NUMBER; p $ISPH_TEST_PATH; f "${ISPH_TEST_PATH}/x.stl"; g "$ISPH_TEST_PATH/y";
        s { ISPH_TEST_NUMBER 3; n $ISPH_TEST_NUMBER; })");
    EXPECT_EQ(dict.get<Real>("n"), 0.25);
    EXPECT_EQ(dict.get<std::string>("p"), "/a b/c");
    EXPECT_EQ(dict.get<std::string>("f"), "/a b/c/x.stl");
    EXPECT_EQ(dict.get<std::string>("g"), "/a b/c/y");
    EXPECT_EQ(dict.subDict("s").get<Real>("n"), 3.0);
}

TEST(Macros, StringsTakeEntriesAndKeepDollarsThatNameNothing)
{
    const auto dict = Dictionary::parse(
        R"--(U0 2; velocity ("$U0*sin(x)" "0" "0"); pattern "(a|b)$"; kept "$nothing ${nothing}";)--");
    EXPECT_EQ(dict.get<Words>("velocity")[0], "2*sin(x)");
    EXPECT_EQ(dict.get<std::string>("pattern"), "(a|b)$");
    EXPECT_EQ(dict.get<std::string>("kept"), "$nothing ${nothing}");
}

TEST(Macros, AnUndefinedOneNamesItsLineAndTheNearest)
{
    const auto failure = failureOf([] { Dictionary::parse("height 1;\n\nb $hieght;", "f"); });
    EXPECT_EQ(failure.line, 3);
    EXPECT_TRUE(says(
        failure,
        "Illegal dictionary entry or environment variable name \"hieght\" in dictionary \"f\""));
    EXPECT_TRUE(says(failure, "Did you mean '$height'?"));
}

TEST(Macros, ASubDictionaryIsMergedInAndCanBeOverridden)
{
    const auto dict = Dictionary::parse(R"(base { type box; min (0 0 0); sub { x 1; y 1; } }
        b { type sphere; $base; min (1 1 1); sub { y 2; } } c $base; c { type box2; })",
                                        "f");
    const Dictionary& b = dict.subDict("b");
    EXPECT_EQ(b.get<std::string>("type"), "box") << "the later one counts";
    EXPECT_EQ(b.get<Vector3>("min"), (Vector3{1, 1, 1}));
    EXPECT_EQ(b.subDict("sub").get<int>("x"), 1);
    EXPECT_EQ(b.subDict("sub").get<int>("y"), 2);
    EXPECT_EQ(b.subDict("sub").name(), "f/b/sub");
    EXPECT_EQ(dict.subDict("c").get<std::string>("type"), "box2");
    EXPECT_EQ(dict.subDict("base").get<std::string>("type"), "box") << "the source is untouched";
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a 1; $a;"); }), "'a' is none"));
}

TEST(Macros, MergingKeepsWhatTheSubDictionariesHoldAlready)
{
    const auto dict = Dictionary::parse(
        "base { sub { x 1; y 1; } } b { sub { y 2; z 2; } $base; } sub { z 3; } sub $!base/sub;");
    EXPECT_EQ(dict.subDict("b").subDict("sub").keywords(), (Words{"y", "z", "x"}));
    EXPECT_EQ(dict.subDict("b").subDict("sub").get<int>("y"), 1);
    EXPECT_EQ(dict.subDict("sub").keywords(), (Words{"z", "x", "y"}));
}

TEST(Macros, NothingStandsAboveTheTop)
{
    for (const char* text : {"a 1; s { b $../../a; }", "a 1; s { b $...a; }"})
        EXPECT_TRUE(says(failureOf([&] { Dictionary::parse(text); }), "Illegal dictionary entry"))
            << text;
}

TEST(Macros, KeywordsAndNestedNamesCanBeVariables)
{
    const auto dict = Dictionary::parse(
        R"--(name left; $name 1; n 2; wall2 3; v ${wall$n}; "${name}.*" 4; outer { $name { z 5; } })--");
    EXPECT_EQ(dict.get<int>("left"), 1);
    EXPECT_EQ(dict.get<int>("v"), 3);
    EXPECT_EQ(dict.get<int>("left12"), 4);
    EXPECT_EQ(dict.subDict("outer").subDict("left").get<int>("z"), 5);
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("n (1 2); $n 3;"); }), "a keyword is one word"));
}

TEST(Macros, ADictionaryInAListBringsItsEntries)
{
    const auto dict = Dictionary::parse("common { type box; n 2; } shapes ( a { $common; } );");
    EXPECT_NE(dict.toString().find("(a { type box; n 2; })"), std::string::npos) << dict.toString();
}

TEST(Macros, ADictionaryInAValueMeansAMissingSemicolon)
{
    for (const char* text :
         {"s { x 1; }\na 2\n$s;", "s { x 1; }\n\na $s 2;", "s { x 1; }\n\na (1 $s);"}) {
        const auto failure = failureOf([&] { Dictionary::parse(text); });
        EXPECT_EQ(failure.line, 3) << text;
        EXPECT_TRUE(says(failure, "'$s' in the value of 'a' is a dictionary")) << text;
    }
}

TEST(Macros, AnotherFilesEntryIsNamedByFileAndPath)
{
    const testing::TempFolder folder;
    folder.write("constant/zones", "rubble { D50 0.02; }");
    const auto file = folder.write("system/particlesDict", "d ${../constant/zones!rubble/D50};");
    EXPECT_EQ(Dictionary::read(file).get<Real>("d"), 0.02);
}

TEST(Macros, TheirSourcesAreNoUnknownKeysToASchema)
{
    const Schema schema{Key::scalar("nu", "Viscosity.")};
    EXPECT_EQ(failureOf([&] { schema.check(Dictionary::parse("factor 2; nu $factor;")); }).line,
              -1);
    EXPECT_EQ(failureOf([&] {
                  schema.check(Dictionary::parse("factor 2; nu #calc \"3*$factor\";"));
              }).line,
              -1);
    EXPECT_TRUE(says(failureOf([&] { schema.check(Dictionary::parse("factor 2; nu 3;")); }),
                     "Unknown keyword factor"));
}

}  // namespace
}  // namespace isph
