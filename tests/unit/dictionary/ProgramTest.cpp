// SPDX-License-Identifier: GPL-3.0-or-later
// The program isphDictionary, run as a user runs it.
#include "TempFolder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <memory>

namespace isph {
namespace {

struct Result {
    int exitCode;
    std::string output;
};

Result runProgram(const std::string& arguments)
{
    const std::string command = std::string(ISPH_DICTIONARY_PROGRAM) + " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    Result result{-1, ""};
    std::array<char, 4096> block{};
    for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
        result.output.append(block.data(), n);
    const int status = pclose(pipe);
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

class IsphDictionary : public ::testing::Test {
protected:
    IsphDictionary()
    {
        folder_.write("system/more", "included 5;\n");
        folder_.write("system/controlDict", kText);
        case_ = "-case " + folder_.path().string() + " system/controlDict ";
    }
    static constexpr const char* kText =
        "endTime 2; // [s]\nH 0.35;\ns\n{\n    x #calc \"2 * $H\";\n    name \"a b\";\n}\n#include "
        "\"more\"\n";
    testing::TempFolder folder_;
    std::string case_;
};

TEST_F(IsphDictionary, PrintsTheFileAndItsEntriesAsWritten)
{
    EXPECT_EQ(runProgram(case_).output, kText);
    EXPECT_EQ(runProgram(case_ + "-entry s/x").output, "x #calc \"2 * $H\";\n");
    EXPECT_EQ(runProgram(case_ + "-entry endTime -value").output, "2\n");
    EXPECT_EQ(runProgram(case_ + "-keywords").output, "endTime\nH\ns\n");
    EXPECT_EQ(runProgram(case_ + "-entry s -keywords").output, "x\nname\n");
}

TEST_F(IsphDictionary, ExpandResolvesEverythingInCanonicalForm)
{
    const Result whole = runProgram(case_ + "-expand");
    EXPECT_EQ(whole.exitCode, 0);
    EXPECT_EQ(whole.output,
              "endTime         2;\nH               0.35;\ns\n{\n    x               0.7;\n    name "
              "           \"a b\";\n}\nincluded        5;\n");
    EXPECT_EQ(runProgram(case_ + "-expand -entry s/x -value").output, "0.7\n");
    EXPECT_EQ(runProgram(case_ + "-expand -entry included").output, "included        5;\n");
    EXPECT_EQ(runProgram(case_ + "-expand -entry s").output,
              "s\n{\n    x               0.7;\n    name            \"a b\";\n}\n");
    EXPECT_EQ(runProgram(case_ + "-expand -keywords").output, "endTime\nH\ns\nincluded\n");
}

TEST_F(IsphDictionary, ChangesTheFileInPlace)
{
    EXPECT_EQ(runProgram(case_ + "-entry endTime -set 3").exitCode, 0);
    EXPECT_EQ(runProgram(case_ + "-entry s/v -add '(0 0 -1)'").exitCode, 0);
    EXPECT_EQ(runProgram(case_ + "-entry s/name -remove").exitCode, 0);
    EXPECT_EQ(folder_.read("system/controlDict"),
              "endTime 3; // [s]\nH 0.35;\ns\n{\n    x #calc \"2 * $H\";\n    v               (0 0 "
              "-1);\n}\n#include \"more\"\n");
}

TEST_F(IsphDictionary, ANegativeValueIsNoOption)
{
    EXPECT_EQ(runProgram(case_ + "-entry endTime -set -1.5").exitCode, 0);
    EXPECT_EQ(runProgram(case_ + "-entry endTime -value").output, "-1.5\n");
}

TEST_F(IsphDictionary, ErrorsHaveExitCodeOneAndOpenFoamsWords)
{
    const auto fails = [&](const std::string& arguments, const std::string& part) {
        const Result result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 1) << arguments;
        EXPECT_NE(result.output.find(part), std::string::npos) << arguments << "\n"
                                                               << result.output;
    };
    fails(case_ + "-entry endTme -value", "Did you mean 'endTime'?");
    fails(case_ + "-expand -entry s/y", "keyword y is undefined in dictionary");
    fails(case_ + "-entry endTime -add 3", "--> FOAM FATAL IO ERROR:");
    fails(case_ + "-set 3", "need -entry");
    fails(case_ + "-entry endTime -set 3 -remove", "Only one of");
    fails(case_ + "-entri endTime", "Invalid option: -entri");
    fails("/nowhere/dict", "cannot open file");
    fails("", "Wrong number of arguments");
    folder_.write("system/controlDict", "a 1;\ns\n{\n b 2;\n");
    fails(case_ + "-expand", "at line 3.");
    fails(case_ + "-entry a -set 2", "at line");
    EXPECT_EQ(folder_.read("system/controlDict"), "a 1;\ns\n{\n b 2;\n")
        << "a failed change leaves the file";
}

}  // namespace
}  // namespace isph
