// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "dictionary/Dictionary.hpp"

namespace isph {
namespace {

using testing::failureOf;
using testing::says;
using Words = std::vector<std::string>;

TEST(Parser, ReadsWordsNumbersStringsListsAndSubDictionaries)
{
    const auto dict = Dictionary::parse(R"(
        FoamFile { format ascii; class dictionary; object x; }
        kernel wendlandC2;   // to the end of the line ; {
        /* over
           two lines } */
        nu 1e-6; scheme div(phi,U);  file "a b.stl";
        walls { tank { min (0 0 0); open (top left); } }
    )");
    EXPECT_EQ(dict.keywords(), (Words{"FoamFile", "kernel", "nu", "scheme", "file", "walls"}));
    EXPECT_EQ(dict.get<std::string>("kernel"), "wendlandC2");
    EXPECT_EQ(dict.get<Real>("nu"), 1e-6);
    EXPECT_EQ(dict.get<std::string>("scheme"), "div(phi,U)");
    EXPECT_EQ(dict.get<std::string>("file"), "a b.stl");
    EXPECT_EQ(dict.subDict("walls").subDict("tank").get<Words>("open"), (Words{"top", "left"}));
}

TEST(Parser, CountsAndRepeatedElementsMakeLists)
{
    const auto dict =
        Dictionary::parse("a 3(1 2 3); b 2{0.5}; c 2{(0 0 1)}; d 0(); e List<scalar> 2(1 2);");
    EXPECT_EQ(dict.get<std::vector<Real>>("a"), (std::vector<Real>{1, 2, 3}));
    EXPECT_EQ(dict.get<std::vector<Real>>("b"), (std::vector<Real>{0.5, 0.5}));
    EXPECT_EQ(dict.get<std::vector<Vector3>>("c"), (std::vector<Vector3>{{0, 0, 1}, {0, 0, 1}}));
    EXPECT_TRUE(dict.get<std::vector<Real>>("d").empty());
    EXPECT_EQ(dict.get<std::vector<Real>>("e").size(), 2u);
}

TEST(Parser, VerbatimBlocksKeepTheirText)
{
    const auto dict =
        Dictionary::parse("code #{ if (a < b) { return \"x;\"; } // no comment\n #}; next 1;");
    EXPECT_EQ(dict.get<std::string>("code"), " if (a < b) { return \"x;\"; } // no comment\n ");
    EXPECT_EQ(dict.location("next").line, 2);
}

TEST(Parser, StringsKeepBackslashesButNotThoseOfQuotesAndLineEnds)
{
    const auto dict = Dictionary::parse("a \"say \\\"hi\\\"\"; b \"x\\.y\"; c \"one\\\ntwo\";");
    EXPECT_EQ(dict.get<std::string>("a"), "say \"hi\"");
    EXPECT_EQ(dict.get<std::string>("b"), "x\\.y");
    EXPECT_EQ(dict.get<std::string>("c"), "onetwo");
}

TEST(Parser, EveryEntryKnowsItsFileAndLine)
{
    const auto dict = Dictionary::parse(
        "a 1;\n\n/* x\n */ b\n{\n    c \"s\";\n    d (1\n 2);\n}\ne 1;", "case/system/x");
    EXPECT_EQ(dict.location("a").line, 1);
    EXPECT_EQ(dict.location("b").line, 4);
    EXPECT_EQ(dict.subDict("b").location("c").line, 6);
    EXPECT_EQ(dict.location("e").line, 10);
    EXPECT_EQ(dict.location("e").file, "case/system/x");
    EXPECT_EQ(dict.subDict("b").name(), "case/system/x/b");
    EXPECT_EQ(dict.subDict("b").scopeName(), "b");
    EXPECT_EQ(dict.subDict("b").location("absent").line, 4) << "where the dictionary begins";
}

TEST(Parser, LaterEntriesOverrideAndDuplicateSubDictionariesMerge)
{
    const auto dict =
        Dictionary::parse("a 1; s { x 1; y 1; t { u 1; } } b 2; s { y 2; t { v 2; } } a 3;");
    EXPECT_EQ(dict.get<int>("a"), 3);
    EXPECT_EQ(dict.keywords(), (Words{"a", "s", "b"}));
    EXPECT_EQ(dict.subDict("s").get<int>("x"), 1);
    EXPECT_EQ(dict.subDict("s").get<int>("y"), 2);
    EXPECT_EQ(dict.subDict("s").subDict("t").keywords(), (Words{"u", "v"}));
}

TEST(Parser, AnExactKeyGoesBeforePatternsAndTheLastPatternWins)
{
    const auto dict = Dictionary::parse(R"--("p.*" 1; "(p|q)" 2; p 3; "z\.[0-9]+" 4;)--");
    EXPECT_EQ(dict.get<int>("p"), 3);
    EXPECT_EQ(dict.get<int>("pp"), 1);
    EXPECT_EQ(dict.get<int>("q"), 2);
    EXPECT_EQ(dict.get<int>("z.12"), 4);
    EXPECT_FALSE(dict.found("zz12")) << "the dot is escaped";
    EXPECT_FALSE(dict.found("aq")) << "a pattern matches the whole keyword";
    EXPECT_EQ(dict.keywords(), (Words{"\"p.*\"", "\"(p|q)\"", "p", "\"z\\.[0-9]+\""}));
    const auto again = Dictionary::parse(R"("a.*" 1; "a" 2; "a.*" 3;)");
    EXPECT_EQ(again.get<int>("a"), 3) << "written again, a pattern is the last";
    EXPECT_EQ(again.keywords(), (Words{"\"a\"", "\"a.*\""}));
}

TEST(Parser, AMissingBraceNamesTheLineOfTheOpenOne)
{
    const auto failure =
        failureOf([] { Dictionary::parse("a 1;\nwalls\n{\n    tank { b 2; }\n", "f"); });
    EXPECT_EQ(failure.line, 3);
    EXPECT_TRUE(says(failure, "opened in line 3"));
    EXPECT_TRUE(says(failure, "walls"));
}

TEST(Parser, AMissingInnerBraceIsFoundByTheIndentation)
{
    const auto failure =
        failureOf([] { Dictionary::parse("a\n{\n    b\n    {\n        c 1;\n}\nd 1;\n", "f"); });
    EXPECT_EQ(failure.line, 2) << "by counting braces, the outer one is open";
    EXPECT_TRUE(says(failure, "the '}' in line 6 does not belong to the '{' in line 4"));
}

TEST(Parser, UnbalancedAndUnfinishedTextIsRefusedWithItsLine)
{
    EXPECT_EQ(failureOf([] { Dictionary::parse("a 1;\n}\n"); }).line, 2);
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a 1;\n}\n"); }), "found '}'"));
    EXPECT_EQ(failureOf([] { Dictionary::parse("\na (1 2;\nb 3;\n"); }).line, 2);
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a (1 2];"); }), "Unexpected ']'"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a 1\n"); }), "';' is missing"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("s { a 1 }"); }), "';' is missing"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("a b\nc { d 1; }"); }),
                     "';' is missing before line 2"));
    EXPECT_EQ(failureOf([] { Dictionary::parse("\n/* a"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("\na \"b\nc\";"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("\na #{ b;"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("\n\"(a\" 1;"); }).line, 2)
        << "no regular expression";
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("3 4;"); }), "Expected a keyword, found '3'"));
}

TEST(Parser, AFileThatIsNotThereIsNamed)
{
    const auto failure = failureOf([] { Dictionary::read("/nowhere/system/controlDict"); });
    EXPECT_EQ(failure.file, "/nowhere/system/controlDict");
    EXPECT_TRUE(says(failure, "cannot open file"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::read("/"); }), "cannot open file"));
}

TEST(Parser, TheCanonicalFormReadsBackAsTheSameDictionary)
{
    const std::string text = R"(a 1;b(1 2 (3 4));c "x \"y\" \.z";d 3(a b c);e 2{0.5};f [m^2/s] 1;
        "w.*" {g yes;h{}} k #{ a; #}; l ( p {type x;} ); m;)";
    const auto dict = Dictionary::parse(text);
    const std::string canonical = dict.toString();
    EXPECT_EQ(Dictionary::parse(canonical).toString(), canonical);
    EXPECT_EQ(Dictionary::parse(canonical).get<std::string>("c"), dict.get<std::string>("c"));
    EXPECT_NE(canonical.find("b               (1 2 (3 4));\n"), std::string::npos) << canonical;
    EXPECT_NE(canonical.find("d               3(a b c);\n"), std::string::npos) << canonical;
    EXPECT_NE(canonical.find("\"w.*\"\n{\n    g               yes;\n    h\n    {\n    }\n}\n"),
              std::string::npos)
        << canonical;
}

TEST(Dictionary, SetsMakesAndRemovesEntriesByPath)
{
    auto dict = Dictionary::parse("a 1;\ns { b 2; t { c 3; } }", "f");
    dict.set("a", "(1 2 3)");
    dict.set("s/t/c", "5");
    dict.set("s/t/d", "{ e 6; }");
    dict.set("new/sub/x", "7");
    EXPECT_EQ(dict.get<Vector3>("a"), (Vector3{1, 2, 3}));
    EXPECT_EQ(dict.subDict("s").subDict("t").get<int>("c"), 5);
    EXPECT_EQ(dict.subDict("s").subDict("t").subDict("d").get<int>("e"), 6);
    EXPECT_EQ(dict.subDict("new").subDict("sub").get<int>("x"), 7);
    EXPECT_EQ(dict.subDict("s").subDict("t").subDict("d").name(), "f/s/t/d");
    dict.remove("s/t");
    EXPECT_EQ(dict.subDict("s").keywords(), Words{"b"});
    EXPECT_EQ(dict.subDict("s").get<int>("b"), 2);
    EXPECT_TRUE(says(failureOf([&] { dict.remove("s/t"); }),
                     "keyword t is undefined in dictionary \"f/s\""));
}

TEST(Dictionary, ACopyIsIndependentOfItsOriginal)
{
    auto dict = Dictionary::parse("s { a 1; }");
    const Dictionary copy = dict;
    dict.set("s/a", "2");
    EXPECT_EQ(copy.subDict("s").get<int>("a"), 1);
    EXPECT_EQ(dict.subDict("s").get<int>("a"), 2);
}

}  // namespace
}  // namespace isph
