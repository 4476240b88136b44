// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Time.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

namespace isph {
namespace {

std::string errorOf(const std::string& controlDict)
{
    try {
        Time(Dictionary::parse(controlDict, "controlDict"), "/nonexistent", {});
    } catch (const FatalIOError& error) {
        return error.what();
    }
    return "";
}

TEST(ControlDict, ErrorsNameTheKeyAndWhatIsAllowed)
{
    const auto mentions = [](const std::string& dict, const std::string& text) {
        const std::string error = errorOf(dict);
        EXPECT_NE(error.find(text), std::string::npos) << error;
    };
    mentions("endTime 1; deltaT 1e-3; writeInterval 0.5;", "whole number");
    mentions("endTime 1; deltaT 1e-3; writeControl adjustable; writeInterval 1;",
             "adjustableRunTime");
    mentions("endTime 1; deltaT 0; writeInterval 1;", "deltaT");
    mentions("endTme 1; deltaT 1; writeInterval 1;", "endTime");
    mentions("deltaT 1; writeInterval 1;", "endTime");
    mentions("endTime 1; deltaT 1e-3;", "writeInterval");
    mentions("endTime 1; deltaT 1e-3; writeInterval 1; purgeWrite -1;", "purgeWrite");
}

TEST(ControlDict, AHeaderFunctionsAndLibrariesBelongToIt)
{
    EXPECT_EQ(
        errorOf("FoamFile { format ascii; class dictionary; object controlDict; } application "
                "isphPorousFoam; endTime 1; deltaT 1e-3; writeInterval 1; libs (\"libmy.so\"); "
                "functions { gauge { type waterLevel; anything 1; } }"),
        "");
}

/// A case folder with a controlDict whose time of modification is set by hand.
class ModifiableCase : public ::testing::Test {
protected:
    void SetUp() override
    {
        case_ =
            std::filesystem::temp_directory_path() / ("isph_time_" + std::to_string(::getpid()));
        std::filesystem::create_directories(case_ / "system");
    }
    void TearDown() override { std::filesystem::remove_all(case_); }

    void writeControlDict(const std::string& text)
    {
        const std::filesystem::path file = case_ / "system" / "controlDict";
        std::ofstream(file) << text;
        std::filesystem::last_write_time(file, stamp_);
        stamp_ += std::chrono::seconds(1);
    }
    Time open() const { return {Dictionary::read(case_ / "system" / "controlDict"), case_, {}}; }

    std::filesystem::path case_;

private:
    std::filesystem::file_time_type stamp_ = std::filesystem::file_time_type::clock::now();
};

TEST_F(ModifiableCase, AChangedControlDictIsReadAgainWithOpenFoamsWords)
{
    const std::string base = "endTime 1; deltaT 0.1; writeControl timeStep; writeInterval 100;";
    writeControlDict(base);
    Time time = open();
    ASSERT_TRUE(time.run());
    time.advance();
    writeControlDict(base + "stopAt writeNow; maxCo 0.7;");
    ::testing::internal::CaptureStdout();
    ASSERT_TRUE(time.run());
    std::fflush(stdout);
    const std::string said = ::testing::internal::GetCapturedStdout();
    EXPECT_NE(said.find("Re-reading object controlDict from file \"" + case_.string()),
              std::string::npos)
        << said;
    EXPECT_EQ(time.maxCo(), 0.7);
    time.advance();
    EXPECT_TRUE(time.writeTime());
    EXPECT_FALSE(time.run());
}

TEST_F(ModifiableCase, AMistakeWhileRunningIsWarnedOfAndTheOldSettingsStay)
{
    const std::string base = "endTime 1; deltaT 0.1; writeControl timeStep; writeInterval 3;";
    writeControlDict(base);
    Time time = open();
    writeControlDict("endTime 0.2; deltaT 0.1; writeControl timeStep; writeIntervall 3;");
    ::testing::internal::CaptureStdout();
    ASSERT_TRUE(time.run());
    std::fflush(stdout);
    EXPECT_NE(::testing::internal::GetCapturedStdout().find("writeIntervall"), std::string::npos);
    EXPECT_EQ(time.endTime(), 1);
    writeControlDict("endTime 0.2; deltaT 0.1; writeControl timeStep; writeInterval 3;");
    EXPECT_TRUE(time.run());
    EXPECT_EQ(time.endTime(), 0.2);
}

TEST_F(ModifiableCase, RunTimeModifiableOffLeavesTheFileAlone)
{
    const std::string base = "endTime 1; deltaT 0.1; writeInterval 3; runTimeModifiable no;";
    writeControlDict(base);
    Time time = open();
    writeControlDict("endTime 0.1; deltaT 0.1; writeInterval 3;");
    EXPECT_TRUE(time.run());
    EXPECT_EQ(time.endTime(), 1);
}

}  // namespace
}  // namespace isph
