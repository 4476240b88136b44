// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Error.hpp"
#include "selection/CommandLine.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace isph {
namespace {

using ::testing::internal::CaptureStderr;
using ::testing::internal::CaptureStdout;
using ::testing::internal::GetCapturedStderr;
using ::testing::internal::GetCapturedStdout;

CommandLine sample()
{
    CommandLine line("isphSample", "Does nothing.");
    line.argument("file", "file to read")
        .option("entry", "path", "entry to print")
        .flag("expand", "expands macros");
    return line;
}

std::optional<int> parse(CommandLine& line, std::vector<const char*> words)
{
    words.insert(words.begin(), "isphSample");
    return line.parse(static_cast<int>(words.size()), words.data());
}

TEST(CommandLine, ReadsSingleDashOptionsValuesAndArgumentsInAnyOrder)
{
    CommandLine line = sample();
    EXPECT_FALSE(parse(line, {"-entry", "a/b", "file.txt", "-expand"}).has_value());
    EXPECT_EQ(line.value("entry"), "a/b");
    EXPECT_EQ(line.value("file"), "file.txt");
    EXPECT_TRUE(line.has("expand"));
    EXPECT_FALSE(line.has("version"));
    EXPECT_TRUE(line.functionObjects());
    EXPECT_EQ(line.value("libs", "none"), "none");
}

TEST(CommandLine, AValueMayBeginWithADashOrHoldSpacesAndBraces)
{
    CommandLine line = sample();
    EXPECT_FALSE(parse(line, {"x", "-entry", "-1.5"}).has_value());
    EXPECT_EQ(line.number("entry", 0), -1.5);
    CommandLine other = sample();
    EXPECT_FALSE(parse(other, {"x", "-entry", "{ a (0 0 -1); }"}).has_value());
    EXPECT_EQ(other.value("entry"), "{ a (0 0 -1); }");
}

TEST(CommandLine, AnUnknownOptionIsNamedWithTheUsageAndExitCodeOne)
{
    CommandLine line = sample();
    CaptureStderr();
    EXPECT_EQ(parse(line, {"x", "-exapnd"}), 1);
    const std::string text = GetCapturedStderr();
    EXPECT_NE(text.find("Invalid option: -exapnd\nDid you mean -expand?"), std::string::npos)
        << text;
    EXPECT_NE(text.find("Usage: isphSample [OPTIONS] <file>"), std::string::npos) << text;
}

TEST(CommandLine, AnAbbreviatedOptionIsInvalid)
{
    CommandLine line = sample();
    CaptureStderr();
    EXPECT_EQ(parse(line, {"x", "-exp"}), 1);
    EXPECT_NE(GetCapturedStderr().find("Invalid option: -exp\n"), std::string::npos);
    CommandLine twoDashes = sample();
    CaptureStderr();
    EXPECT_EQ(parse(twoDashes, {"x", "--exp"}), 1);
    EXPECT_NE(GetCapturedStderr().find("Invalid option: -exp\n"), std::string::npos);
}

TEST(CommandLine, MissingValuesAndArgumentsAreRefused)
{
    CommandLine line = sample();
    CaptureStderr();
    EXPECT_EQ(parse(line, {"x", "-entry"}), 1);
    EXPECT_NE(GetCapturedStderr().find("Option -entry needs a value"), std::string::npos);
    CommandLine none = sample();
    CaptureStderr();
    EXPECT_EQ(parse(none, {}), 1);
    EXPECT_NE(GetCapturedStderr().find("Wrong number of arguments, expected 1 found 0"),
              std::string::npos);
    CommandLine two = sample();
    CaptureStderr();
    EXPECT_EQ(parse(two, {"a", "b"}), 1);
    EXPECT_NE(GetCapturedStderr().find("expected 1 found 2"), std::string::npos);
}

TEST(CommandLine, HelpNamesAllOptionsAndEndsWithZero)
{
    CommandLine line = sample();
    CaptureStdout();
    EXPECT_EQ(parse(line, {"-help"}), 0);
    const std::string text = GetCapturedStdout();
    for (const char* option : {"-case <dir>", "-libs '(", "-noFunctionObjects", "-help", "-version",
                               "-entry <path>", "-expand", "Does nothing."})
        EXPECT_NE(text.find(option), std::string::npos) << option << text;
}

TEST(CommandLine, TheCaseIsAbsoluteAndKnownToDictionaries)
{
    CommandLine line = sample();
    EXPECT_FALSE(parse(line, {"x", "-case", "/tmp/."}).has_value());
    EXPECT_EQ(line.caseDir(), "/tmp");
    EXPECT_STREQ(std::getenv("FOAM_CASE"), "/tmp");
    CommandLine absent = sample();
    EXPECT_THROW(parse(absent, {"x", "-case", "/no/such/case"}), FatalError);
}

TEST(CommandLine, LibrariesThatCannotBeLoadedAreFatal)
{
    CommandLine line = sample();
    EXPECT_THROW(parse(line, {"x", "-libs", "(\"libisphNowhere.so\")"}), FatalError);
    CommandLine list = sample();
    EXPECT_THROW(parse(list, {"x", "-libs", "libisphNowhere.so"}), FatalIOError) << "not a list";
}

TEST(CommandLine, ANumberThatIsNoneIsRefused)
{
    CommandLine line = sample();
    EXPECT_FALSE(parse(line, {"x", "-entry", "1a"}).has_value());
    EXPECT_THROW(line.number("entry", 0), FatalError);
    EXPECT_EQ(line.number("case", 2.5), 2.5);
}

TEST(CommandLine, TheBannerSaysWhatRunsWhere)
{
    CommandLine line = sample();
    EXPECT_FALSE(parse(line, {"x", "-case", "/tmp"}).has_value());
    CaptureStdout();
    line.printBanner();
    const std::string text = GetCapturedStdout();
    for (const char* part :
         {"Build  : ", "Exec   : isphSample x -case /tmp\n",
          "Date   : ", "Time   : ", "Host   : ", "PID    : ", "Case   : /tmp\n", "nProcs : 1"})
        EXPECT_NE(text.find(part), std::string::npos) << part << text;
}

}  // namespace
}  // namespace isph
