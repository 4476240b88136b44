// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TimeList.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <limits>

namespace isph {
namespace {

class TimeList : public ::testing::Test {
protected:
    void SetUp() override
    {
        case_ =
            std::filesystem::temp_directory_path() / ("isph_times_" + std::to_string(::getpid()));
        for (const char* name :
             {"0", "0.35", "1e-05", "0.75", "10", "2", "constant", "0.orig", "nan", "-case"})
            std::filesystem::create_directories(case_ / name);
        std::ofstream(case_ / "3") << "a file is no time folder";
    }
    void TearDown() override { std::filesystem::remove_all(case_); }

    std::string select(const std::string& selection) const
    {
        std::string names;
        for (const TimeFolder& folder : selectTimes(timeFolders(case_), selection))
            names += folder.name + " ";
        return names;
    }
    std::string startError(const std::string& dict) const
    {
        try {
            startFolder(Dictionary::parse(dict, "controlDict"), case_);
        } catch (const FatalIOError& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path case_;
};

TEST_F(TimeList, FoldersWithNumericNamesAreListedInTheOrderOfTime)
{
    EXPECT_EQ(select(":"), "0 1e-05 0.35 0.75 2 10 ");
}

TEST_F(TimeList, SelectionsTakeTimesRangesAndWords)
{
    EXPECT_EQ(select("0.35,0.75"), "0.35 0.75 ");
    EXPECT_EQ(select("0.36"), "0.35 ");  // the nearest, as OpenFOAM
    EXPECT_EQ(select("0.5:, firstTime"), "0.75 2 10 0 ");
    EXPECT_EQ(select(":0.5"), "0 1e-05 0.35 ");
    EXPECT_EQ(select("latestTime,10"), "10 ");
    EXPECT_THROW(select("3:4"), FatalError);
    EXPECT_THROW(select("last"), FatalError);
    EXPECT_THROW(select(""), FatalError);
}

TEST_F(TimeList, TheStartIsTheFirstTheLatestOrTheGivenTime)
{
    const auto start = [&](const std::string& dict) {
        return startFolder(Dictionary::parse(dict, "controlDict"), case_).name;
    };
    EXPECT_EQ(start(""), "10");
    EXPECT_EQ(start("startFrom firstTime;"), "0");
    EXPECT_EQ(start("startFrom startTime; startTime 0.75;"), "0.75");
    EXPECT_NE(startError("startFrom startTime; startTime 0.7;").find("0.75"), std::string::npos);
    EXPECT_NE(startError("startFrom startTime;").find("startTime"), std::string::npos);
    std::filesystem::remove_all(case_);
    EXPECT_NE(startError("").find("createParticles"), std::string::npos);
}

TEST_F(TimeList, TheStateOfARunIsReadBackBitForBit)
{
    const TimeState state{0.35 + 1e-10 / 3, "0.35", 123456, std::numeric_limits<Real>::denorm_min(),
                          0.1,     {}};
    std::filesystem::create_directories(case_ / "0.35" / "uniform");
    std::ofstream(case_ / "0.35" / "uniform" / "time") << timeStateText(state);
    const TimeState read = readTimeState({0.35, "0.35", case_ / "0.35"});
    EXPECT_EQ(read.value, state.value);
    EXPECT_EQ(read.name, state.name);
    EXPECT_EQ(read.index, state.index);
    EXPECT_EQ(read.deltaT, state.deltaT);
    EXPECT_EQ(read.deltaT0, state.deltaT0);
}

TEST_F(TimeList, AFolderThatWasCutOffIsNamedWithWhatItLacks)
{
    const TimeFolder folder{0.35, "0.35", case_ / "0.35"};
    const auto error = [&] {
        try {
            readTimeState(folder);
        } catch (const FatalIOError& thrown) {
            EXPECT_EQ(thrown.file(), folder.path.string());
            return std::string(thrown.what());
        }
        return std::string();
    };
    EXPECT_NE(error().find("uniform/time is missing"), std::string::npos);
    std::filesystem::create_directories(folder.path / "uniform");
    std::ofstream(folder.path / "uniform" / "time")
        << timeStateText({0.35, "0.35", 7, 1e-3, 1e-3, {"water", "walls"}});
    std::ofstream(folder.path / "walls.vtp") << "";
    EXPECT_NE(error().find("water.vtp is missing"), std::string::npos);
    std::ofstream(folder.path / "water.vtp") << "";
    EXPECT_EQ(error(), "");
    EXPECT_EQ(readTimeState({0, "0", case_ / "0"}).index, 0);  // as createParticles leaves it
}

}  // namespace
}  // namespace isph
