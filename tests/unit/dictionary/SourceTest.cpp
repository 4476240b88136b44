// SPDX-License-Identifier: GPL-3.0-or-later
#include "Expect.hpp"
#include "TempFolder.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/DictionarySource.hpp"

namespace isph {
namespace {

using testing::failureOf;
using testing::says;
using Words = std::vector<std::string>;

const std::string kText = R"(/* head */
FoamFile { format ascii; class dictionary; object controlDict; }

endTime     2;      // [s]
stopAt      endTime;
H           0.35;
"wall.*"    { type box; }
functions   /* gauges */
{
    // the first
    gauge
    {
        type    waterLevel;
        x       $H;   // at the gate
    }
    #includeFunc probes
}
short { a 1; b 2; }
#include "more"

// ************************************************************************* //
)";

/// The text with one part replaced, which is what an edit should make of it.
std::string with(const std::string& part, const std::string& replacement)
{
    std::string text = kText;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), replacement);
}

std::string afterSet(const std::string& path, const std::string& value)
{
    DictionarySource source(kText, "system/controlDict");
    source.set(path, value);
    return source.text();
}

std::string afterRemove(const std::string& path)
{
    DictionarySource source(kText, "system/controlDict");
    source.remove(path);
    return source.text();
}

TEST(Source, ShowsEntriesAsTheyAreWritten)
{
    const DictionarySource source(kText, "system/controlDict");
    EXPECT_EQ(source.keywords(""),
              (Words{"FoamFile", "endTime", "stopAt", "H", "\"wall.*\"", "functions", "short"}));
    EXPECT_EQ(source.keywords("functions/gauge"), (Words{"type", "x"}));
    EXPECT_EQ(source.valueText("endTime"), "2");
    EXPECT_EQ(source.valueText("functions/gauge/x"), "$H") << "macros stay";
    EXPECT_EQ(source.entryText("stopAt"), "stopAt      endTime;");
    EXPECT_EQ(source.entryText("short"), "short { a 1; b 2; }");
    EXPECT_EQ(source.valueText("wallLeft"), "{ type box; }") << "by its pattern";
    const auto failure = failureOf([&] { source.valueText("functions/gauge/tipe"); });
    EXPECT_TRUE(says(failure, "Cannot find entry functions/gauge/tipe"));
    EXPECT_TRUE(says(failure, "Did you mean 'type'?"));
    EXPECT_TRUE(
        says(failureOf([&] { source.keywords("endTime"); }), "'endTime' is not a dictionary"));
}

TEST(Source, SettingAnEntryChangesItsValueAndNothingElse)
{
    EXPECT_EQ(afterSet("endTime", "3.5"), with("2;      // [s]", "3.5;      // [s]"));
    EXPECT_EQ(afterSet("stopAt", " writeNow; "), with("endTime;\nH", "writeNow;\nH"));
    EXPECT_EQ(afterSet("functions/gauge/x", "(0 #calc \"$H * 2\" 0)"),
              with("$H;", "(0 #calc \"$H * 2\" 0);"));
    EXPECT_EQ(afterSet("short/b", "\"a; b\""), with("b 2;", "b \"a; b\";"));
    EXPECT_EQ(afterSet("short", "{ c 3; }"), with("{ a 1; b 2; }", "{ c 3; }"));
    EXPECT_EQ(afterSet("\"wall.*\"/type", "sphere"), with("type box;", "type sphere;"));
}

TEST(Source, AValueMayBecomeADictionaryAndBack)
{
    EXPECT_EQ(afterSet("endTime", "{ a 1; }"), with("endTime     2;", "endTime\n{ a 1; }"));
    EXPECT_EQ(afterSet("short", "yes"), with("short { a 1; b 2; }", "short           yes;"));
}

TEST(Source, NewEntriesGoToTheEndOfTheirDictionaryInItsLayout)
{
    EXPECT_EQ(afterSet("functions/gauge/y", "1"),
              with("// at the gate\n", "// at the gate\n        y               1;\n"));
    EXPECT_EQ(afterSet("functions/new/deep/z", "1"),
              with("    #includeFunc probes\n",
                   "    #includeFunc probes\n    new\n    {\n        deep\n        {\n            "
                   "z               1;\n        }\n    }\n"));
    EXPECT_EQ(afterSet("short/c", "3"), with("b 2; }", "b 2; c 3; }"));
    EXPECT_EQ(afterSet("short/c/d", "3"), with("b 2; }", "b 2; c { d 3; } }"));
    EXPECT_EQ(afterSet("last", "1"),
              with("#include \"more\"\n", "#include \"more\"\nlast            1;\n"))
        << "before the footer";
    EXPECT_EQ(afterSet("wallLeft", "1"),
              with("#include \"more\"\n", "#include \"more\"\nwallLeft        1;\n"))
        << "beside the pattern";
}

TEST(Source, NewEntriesInEmptyDictionariesAndFiles)
{
    const auto after = [](const std::string& text, const std::string& path) {
        DictionarySource source(text, "f");
        source.set(path, "1");
        return source.text();
    };
    EXPECT_EQ(after("", "a"), "a               1;\n");
    EXPECT_EQ(after("// only\n", "a"), "// only\na               1;\n");
    EXPECT_EQ(after("b 1;", "a"), "b 1;\na               1;\n");
    EXPECT_EQ(after("s {}", "s/a"), "s { a 1; }");
    EXPECT_EQ(after("s { }", "s/a"), "s { a 1; }");
    EXPECT_EQ(after("s\n{\n}\n", "s/a"), "s\n{\n    a               1;\n}\n");
    EXPECT_EQ(after("s\n{\n    // none\n}\n", "s/a"),
              "s\n{\n    // none\n    a               1;\n}\n");
    EXPECT_EQ(after("s\n{\n    b 1; }\n", "s/a"), "s\n{\n    b 1;\n    a               1; }\n");
    EXPECT_EQ(after("b 1; /* a\n comment */\n", "a"),
              "b 1;\na               1; /* a\n comment */\n");
}

TEST(Source, AddingRefusesWhatIsThere)
{
    DictionarySource source(kText, "system/controlDict");
    const auto failure = failureOf([&] { source.add("endTime", "3"); });
    EXPECT_EQ(failure.line, 4);
    EXPECT_TRUE(says(failure, "is there already"));
    EXPECT_EQ(source.text(), kText);
    source.add("deltaT", "1e-3");
    EXPECT_EQ(source.valueText("deltaT"), "1e-3");
}

TEST(Source, RemovingTakesTheEntryAndTheCommentOfItsLine)
{
    EXPECT_EQ(afterRemove("endTime"), with("endTime     2;      // [s]\n", ""));
    EXPECT_EQ(afterRemove("short/a"), with("a 1; ", ""));
    EXPECT_EQ(afterRemove("short/b"), with("b 2; ", ""));
    EXPECT_EQ(afterRemove("functions/gauge"),
              with("    gauge\n    {\n        type    waterLevel;\n        x       $H;   // at the "
                   "gate\n    }\n",
                   ""));
    DictionarySource source(kText, "f");
    EXPECT_TRUE(says(failureOf([&] { source.remove("endTme"); }), "Did you mean 'endTime'?"));
}

TEST(Source, AnEntryThatStandsTwiceIsChangedWhereItCountsAndRemovedEverywhere)
{
    const std::string text =
        "s { a 1; }\ns { a 2; b 1; }\n#if no\nk 1;\n#else\nk 2;\n#endif\n#ifeq 1 1\nm 1;\n#else\nm "
        "2;\n#endif\n";
    DictionarySource source(text, "f");
    source.set("s/a", "3");
    source.set("k", "4");
    source.set("m", "5");
    EXPECT_EQ(source.text(),
              "s { a 1; }\ns { a 3; b 1; }\n#if no\nk 1;\n#else\nk 4;\n#endif\n#ifeq 1 1\nm "
              "5;\n#else\nm 2;\n#endif\n");
    EXPECT_EQ(Dictionary::parse(source.text()).get<int>("m"), 5);
    DictionarySource line("a 1; a 2;", "f");
    line.set("a", "3");
    EXPECT_EQ(line.text(), "a 1; a 3;") << "in one line, too";
    source.remove("s/a");
    EXPECT_FALSE(Dictionary::parse(source.text()).subDict("s").found("a"));
}

TEST(Source, AValueThatIsMoreOrLessThanOneIsRefused)
{
    for (const char* bad : {"1; b 2", "1 }", "(1 2", "{ a 1;", "} x {", "\"open"}) {
        DictionarySource source(kText, "f");
        EXPECT_NE(failureOf([&] { source.set("endTime", bad); }).line, -1) << bad;
        EXPECT_EQ(source.text(), kText) << bad;
    }
    DictionarySource source("a $b;\nb { }", "f");
    EXPECT_TRUE(
        says(failureOf([&] { source.set("a/x", "1"); }), "'a' is not a dictionary in this file"));
}

TEST(Source, WritingReplacesTheFileWholeAndKeepsPermissionsAndLinks)
{
    namespace fs = std::filesystem;
    const testing::TempFolder folder;
    const fs::path file = folder.write("dict", kText), link = folder.path() / "link";
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("dict", link);
    DictionarySource source = DictionarySource::read(link);
    source.set("endTime", "9");
    source.write(link);
    EXPECT_EQ(folder.read("dict"), with("2;      // [s]", "9;      // [s]"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2)
        << "no temporary file stays";
    EXPECT_TRUE(
        says(failureOf([&] { source.write("/no/such/folder/dict"); }), "cannot write file"));
}

TEST(Source, TextThatIsNoDictionaryIsRefusedWithItsLine)
{
    EXPECT_EQ(failureOf([] { DictionarySource("\na {", "f"); }).line, 2);
    EXPECT_EQ(failureOf([] { DictionarySource("a 1;\n}", "f"); }).line, 2);
    EXPECT_EQ(failureOf([] { DictionarySource("a 1;\nb 2", "f"); }).line, 2);
    EXPECT_EQ(failureOf([] { DictionarySource("a 1;\nb c\nd { e 1; }", "f"); }).line, 2);
    EXPECT_EQ(failureOf([] { DictionarySource("a 2{0.5};\nb #eval{ 1 + 2 };", "f"); }).line, -1);
}

}  // namespace
}  // namespace isph
