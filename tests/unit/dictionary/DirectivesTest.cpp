// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "TempFolder.hpp"
#include "dictionary/Dictionary.hpp"

#include <cmath>
#include <cstdlib>

namespace isph {
namespace {

using testing::failureOf;
using testing::says;
using testing::TempFolder;
using Words = std::vector<std::string>;

double calc(const std::string& expression)
{
    return Dictionary::parse("a 3; b -2; r #calc \"" + expression + "\";").get<Real>("r");
}

TEST(Calc, EvaluatesWithTheVariablesPutIn)
{
    EXPECT_EQ(calc("$a / $b"), -1.5);
    EXPECT_EQ(calc("$a/2"), 1.5) << "no entry is called a/2";
    EXPECT_EQ(calc("$b^2"), 4.0) << "a negative value keeps together";
    EXPECT_EQ(calc("1 - $b"), 3.0);
    EXPECT_EQ(calc("${a}*2"), 6.0);
    EXPECT_EQ(calc("$a > 2 && $b < 0 ? 10 : 20"), 10.0);
    EXPECT_EQ(calc("1/3"), 1.0 / 3) << "all digits, and no integer division";
}

TEST(Calc, KnowsTheUsualFunctions)
{
    EXPECT_DOUBLE_EQ(calc("pow(2, 0.5)"), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(calc("sin(pi/6) + sin(degToRad(30))"), 1.0);
    EXPECT_DOUBLE_EQ(calc("log(exp(2))"), 2.0) << "the natural logarithm, as in C++";
    EXPECT_DOUBLE_EQ(calc("sqr(3) + mag(-1) + floor(1.5) + ceil(1.5) + max(1, 2) + hypot(3, 4)"),
                     20.0);
    EXPECT_DOUBLE_EQ(calc("radToDeg(pi())"), 180.0);
}

TEST(Calc, StandsInListsInBracesAndInVerbatimBlocks)
{
    const auto dict = Dictionary::parse(
        "a 2; v (0 #calc \"$a + 1\" 0); e #eval{ $a * 2 }; f #eval \"$a*3\"; g #calc #{ $a\n * 4 "
        "#}; h 1;");
    EXPECT_EQ(dict.get<Vector3>("v"), (Vector3{0, 3, 0}));
    EXPECT_EQ(dict.get<Real>("e"), 4.0);
    EXPECT_EQ(dict.get<Real>("f"), 6.0);
    EXPECT_EQ(dict.get<Real>("g"), 8.0);
    EXPECT_EQ(dict.location("h").line, 2);
}

TEST(Calc, WhatMuParserDoesNotUnderstandIsRefusedWithTheLine)
{
    for (const char* bad :
         {"vector(1, 2, 3)", "1, 2", "sqrt(-1)", "1/0", "foo + 1", "1 +", "Foam::sqrt(2)", ""}) {
        const auto failure =
            failureOf([&] { Dictionary::parse(std::string("\nr #calc \"") + bad + "\";", "f"); });
        EXPECT_EQ(failure.line, 2) << bad;
        EXPECT_TRUE(says(failure, "cannot be evaluated")) << bad;
    }
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("r #calc \"$x + 1\";"); }), "variable name \"x\""));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("r #calc 3;"); }),
                     "expected an expression in quotes"));
}

TEST(Neg, NegatesNumbersAndVectors)
{
    const auto dict = Dictionary::parse(
        "a 3; v (0 1 -2); p #neg $a; q #neg $v; r (0 #neg $a 0); s #neg -4; t #neg +5; u #neg (1 2 "
        "3);");
    EXPECT_EQ(dict.get<Real>("p"), -3.0);
    EXPECT_EQ(dict.get<Vector3>("q"), (Vector3{-0.0, -1, 2}));
    EXPECT_EQ(dict.get<Vector3>("r")[1], -3.0);
    EXPECT_EQ(dict.get<Real>("s"), 4.0);
    EXPECT_EQ(dict.get<Real>("t"), -5.0);
    EXPECT_EQ(dict.get<Vector3>("u"), (Vector3{-1, -2, -3}));
    EXPECT_EQ(Dictionary::parse(dict.toString()).get<Real>("p"), -3.0) << "the text is negated too";
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("p #neg word;"); }), "expected numbers"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("p #neg (1 2;"); }), "#neg"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("p #neg (1 ] 2);"); }), "expected numbers"));
}

TEST(If, ReadsTheBranchThatHolds)
{
    const auto read = [](const std::string& condition) {
        return Dictionary::parse(
            "yes2 yes; n 0; #if " + condition +
            "\n a 1; s { #if no\n x 1; #else\n x 2; #endif\n }\n#else\n a 2;\n#endif\nlast 1;");
    };
    for (const char* holds :
         {"yes", "true", "on", "1", "-2", "$yes2", "#calc \"$n < 1\"", "#eval{ 2 > 1 }"}) {
        EXPECT_EQ(read(holds).get<int>("a"), 1) << holds;
        EXPECT_EQ(read(holds).subDict("s").get<int>("x"), 2) << holds;
    }
    for (const char* fails : {"no", "false", "off", "0", "$n", "#calc \"$n > 1\""})
        EXPECT_EQ(read(fails).get<int>("a"), 2) << fails;
    EXPECT_EQ(read("no").get<int>("last"), 1);
    EXPECT_FALSE(read("no").found("s"));
}

TEST(If, EqualComparesWordsStringsAndNumbers)
{
    const auto equal = [](const std::string& pair) {
        return Dictionary::parse("k cubic; n 1; #ifeq " + pair + "\n r yes; #else\n r no; #endif")
            .get<bool>("r");
    };
    EXPECT_TRUE(equal("$k cubic"));
    EXPECT_TRUE(equal("$k \"cubic\""));
    EXPECT_TRUE(equal("$n 1.0"));
    EXPECT_FALSE(equal("$k quintic"));
    EXPECT_FALSE(equal("$n 2"));
}

TEST(If, SkippedTextIsNotResolvedAndNestedBranchesAreSkippedWhole)
{
    const auto dict = Dictionary::parse(
        "#if no\n a $missing;\n#if yes\n b 1;\n#else\n c 1;\n#endif\n d 1;\n#endif\n e 1;");
    EXPECT_EQ(dict.keywords(), Words{"e"});
}

TEST(If, UnpairedOnesAreRefusedAtTheirLine)
{
    EXPECT_EQ(failureOf([] { Dictionary::parse("\n#if yes\na 1;"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("\n#if no\na 1;"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("a 1;\n#endif"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("a 1;\n#else"); }).line, 2);
    EXPECT_EQ(failureOf([] { Dictionary::parse("#if yes\n#else\n#else\n#endif"); }).line, 3);
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("#if perhaps\n#endif"); }), "expected a switch"));
}

TEST(Remove, TakesWordsListsAndPatterns)
{
    const auto dict = Dictionary::parse(
        "a 1; b 2; c1 3; c2 4; d { x 1; y 2; #remove x\n } #remove a\n #remove (b absent)\n "
        "#remove \"c.*\"\n e 5;");
    EXPECT_EQ(dict.keywords(), (Words{"d", "e"}));
    EXPECT_EQ(dict.subDict("d").keywords(), Words{"y"});
    const auto failure = failureOf([] { Dictionary::parse("\n#remove \"(a\"\n"); });
    EXPECT_EQ(failure.line, 2) << "no regular expression";
}

TEST(InputMode, SaysWhatASecondEntryOfAKeywordDoes)
{
    const auto read = [](const std::string& mode) {
        return Dictionary::parse("a 1; s { x 1; y 1; } #inputMode " + mode +
                                 "\n a 2; s { x 2; } new 3;");
    };
    for (const char* mode : {"merge", "default"}) {
        EXPECT_EQ(read(mode).get<int>("a"), 2);
        EXPECT_EQ(read(mode).subDict("s").keywords(), (Words{"x", "y"}));
        EXPECT_EQ(read(mode).subDict("s").get<int>("x"), 2);
    }
    EXPECT_EQ(read("overwrite").subDict("s").keywords(), Words{"x"});
    for (const char* mode : {"protect", "warn"}) {
        EXPECT_EQ(read(mode).get<int>("a"), 1);
        EXPECT_EQ(read(mode).subDict("s").get<int>("x"), 1);
        EXPECT_EQ(read(mode).get<int>("new"), 3);
    }
    EXPECT_TRUE(
        says(failureOf([&] { read("error"); }), "keyword a of dictionary \"text\" is set again"));
    EXPECT_TRUE(says(failureOf([&] { read("mix"); }), "mix is not in enumeration"));
}

TEST(InputMode, WarnNamesBothPlaces)
{
    ::testing::internal::CaptureStdout();
    Dictionary::parse("a 1;\n#inputMode warn\na 2;", "f");
    const std::string text = ::testing::internal::GetCapturedStdout();
    EXPECT_NE(text.find("--> FOAM Warning :"), std::string::npos) << text;
    EXPECT_NE(text.find("set in f at line 1"), std::string::npos) << text;
    EXPECT_NE(text.find("file: f at line 3"), std::string::npos) << text;
}

TEST(Include, ReadsFilesBesideThisOneAndKeepsTheirLines)
{
    const TempFolder folder;
    folder.write("system/parts/a", "x $H;\n\ny 2;\n#include \"b\"\n");
    folder.write("system/parts/b", "z 3;");
    folder.write("system/points", "(0 0) (1 $H)");
    const auto file = folder.write(
        "system/dict", "H 7; s { #include \"parts/a\"\n } list ( #include \"points\"\n );");
    const auto dict = Dictionary::read(file);
    EXPECT_EQ(dict.subDict("s").get<int>("x"), 7) << "macros see the including file";
    EXPECT_EQ(dict.subDict("s").get<int>("z"), 3) << "relative to the file that includes";
    EXPECT_EQ(dict.subDict("s").location("y").line, 3);
    EXPECT_EQ(dict.subDict("s").location("y").file, (folder.path() / "system/parts/a").string());
    EXPECT_EQ(dict.get<std::vector<Vector3>>("list")[1], (Vector3{1, 7, 0}));
}

TEST(Include, BracketsLeftOpenInAnIncludedValueAreAnError)
{
    const TempFolder folder;
    folder.write("open", "\n(1 2");
    folder.write("closed", "\n1 2)");
    const auto open =
        failureOf([&] { Dictionary::read(folder.write("a", "x #include \"open\"\n;")); });
    EXPECT_TRUE(says(open, "A ')' is missing in entry 'x'"));
    const auto closed =
        failureOf([&] { Dictionary::read(folder.write("b", "x #include \"closed\"\n;")); });
    EXPECT_TRUE(says(closed, "Unexpected ')' in entry 'x'"));
    EXPECT_EQ(closed.file, (folder.path() / "closed").string());
    EXPECT_EQ(closed.line, 2);
}

TEST(Include, FilesMayBeNamedByVariables)
{
    const TempFolder folder;
    folder.write("parts/a", "x 1;");
    setenv("ISPH_TEST_FOLDER", folder.path().c_str(), 1);
    EXPECT_EQ(Dictionary::parse("#include \"$ISPH_TEST_FOLDER/parts/a\"").get<int>("x"), 1);
    EXPECT_EQ(
        Dictionary::parse("part a; #include \"${ISPH_TEST_FOLDER}/parts/$part\"").get<int>("x"), 1);
}

TEST(Include, AMissingFileIsFatalUnlessItMayBeMissing)
{
    const TempFolder folder;
    const auto failure =
        failureOf([&] { Dictionary::read(folder.write("d", "\n#include \"absent\"\n")); });
    EXPECT_EQ(failure.line, 2);
    EXPECT_TRUE(says(failure, "Cannot open include file"));
    EXPECT_TRUE(says(failure, "absent"));
    EXPECT_EQ(Dictionary::read(
                  folder.write("e", "#includeIfPresent \"absent\"\n#sinclude \"absent\"\na 1;"))
                  .keywords(),
              Words{"a"});
    folder.write("present", "b 1;");
    EXPECT_TRUE(Dictionary::read(folder.write("g", "#includeIfPresent \"present\"\n")).found("b"));
    EXPECT_TRUE(Dictionary::read(folder.write("h", "#sinclude \"present\"\n")).found("b"));
}

TEST(Include, AFileThatIncludesItselfIsRefused)
{
    const TempFolder folder;
    folder.write("b", "#include \"./a\"");
    EXPECT_TRUE(says(failureOf([&] { Dictionary::read(folder.write("a", "#include \"b\"")); }),
                     "includes itself"));
    EXPECT_EQ(failureOf([&] {
                  folder.write("twice", "x 1;");
                  Dictionary::read(folder.write("c", "#include \"twice\"\n#include \"twice\"\n"));
              }).line,
              -1);
}

TEST(Include, ABraceLeftOpenInAnIncludedFileIsThatFilesError)
{
    const TempFolder folder;
    folder.write("b", "\ns {");
    const auto failure =
        failureOf([&] { Dictionary::read(folder.write("a", "#include \"b\"\n}")); });
    EXPECT_EQ(failure.line, 2);
    EXPECT_EQ(failure.file, (folder.path() / "b").string());
}

struct ProjectFolder : TempFolder {
    ProjectFolder()
        : before_(std::getenv("ISPH_PROJECT_DIR") ? std::getenv("ISPH_PROJECT_DIR") : "")
    {
        setenv("ISPH_PROJECT_DIR", path().c_str(), 1);
    }
    ~ProjectFolder() { setenv("ISPH_PROJECT_DIR", before_.c_str(), 1); }
    std::string before_;
};

TEST(Include, EtcIsSoughtInTheProject)
{
    const ProjectFolder project;
    project.write("etc/caseDicts/water", "nu 1e-6;");
    EXPECT_EQ(Dictionary::parse("#includeEtc \"caseDicts/water\"").get<Real>("nu"), 1e-6);
    const auto failure = failureOf([] { Dictionary::parse("\n#includeEtc \"caseDicts/oil\""); });
    EXPECT_EQ(failure.line, 2);
    EXPECT_TRUE(says(failure, (project.path() / "etc").string()));
}

TEST(Include, FuncBringsAConfiguredFunctionObject)
{
    const ProjectFolder project;
    project.write("etc/caseDicts/postProcessing/probes/probes",
                  "type probes; fields (p); writeInterval 1;");
    project.write("case/system/gauge", "type waterLevel; x 0.5;");
    const auto file = project.write(
        "case/system/controlDict",
        "functions { #includeFunc gauge\n #includeFunc probes(U, p, writeInterval=2)\n"
        "#includeFunc probes (U, funcName=more, points=((0 0 0) (1 0 0))) }");
    const Dictionary functions = Dictionary::read(file).subDict("functions");
    EXPECT_EQ(functions.keywords(), (Words{"gauge", "probes", "more"}));
    EXPECT_EQ(functions.subDict("gauge").get<Real>("x"), 0.5);
    EXPECT_EQ(functions.subDict("probes").get<Words>("fields"), (Words{"U", "p"}));
    EXPECT_EQ(functions.subDict("probes").get<int>("writeInterval"), 2);
    EXPECT_EQ(functions.subDict("more").get<std::vector<Vector3>>("points").size(), 2u);
    EXPECT_EQ(functions.subDict("more").get<Words>("fields"), Words{"U"});
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("# note"); }), "Comments begin with //"));
    EXPECT_TRUE(says(failureOf([] { Dictionary::parse("#includeFunc nothing"); }),
                     "#includeFunc cannot find \"nothing\""));
}

TEST(Directives, CodeIsRefusedAndUnknownOnesNameTheNearest)
{
    const auto code =
        failureOf([] { Dictionary::parse("\na #codeStream { code #{ return 1; #}; };"); });
    EXPECT_EQ(code.line, 2);
    EXPECT_TRUE(says(code, "#codeStream is refused"));
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("#includ \"x\""); }), "Did you mean #include?"));
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("a #calk \"1\";"); }), "Did you mean #calc?"));
    EXPECT_TRUE(
        says(failureOf([] { Dictionary::parse("#calc \"1\""); }), "stands after a keyword"));
}

TEST(Header, AFileWithAHeaderNamesFormatClassAndObject)
{
    const TempFolder folder;
    EXPECT_EQ(Dictionary::read(
                  folder.write("a", "FoamFile { format ascii; class dictionary; object a; } x 1;"))
                  .get<int>("x"),
              1);
    EXPECT_TRUE(says(failureOf([&] {
                         Dictionary::read(
                             folder.write("b", "FoamFile { format ascii; class dictionary; }"));
                     }),
                     "keyword object is undefined"));
    EXPECT_TRUE(says(failureOf([&] {
                         Dictionary::read(folder.write(
                             "c", "FoamFile { format xml; class dictionary; object c; }"));
                     }),
                     "xml is not in enumeration"));
}

}  // namespace
}  // namespace isph
