// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/DataFile.hpp"

#include "core/Error.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

using namespace isph;
namespace fs = std::filesystem;

namespace {

class DataFile : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("isphDataFile." + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    void writeText(const fs::path& file, const std::string& text)
    {
        fs::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file) << text;
    }
    fs::path folder_;
};

}  // namespace

TEST_F(DataFile, GivesBackTheBitsThatWereWritten)
{
    const std::vector<Real> values{1.0 / 3, -1e-300, 0.1 + 0.2, std::nextafter(1.0, 2.0), 5};
    {
        DataWriter writer(folder_ / "0/g.dat", {"gauge g", "x 0.1 0.25"},
                          {"a", "b", "c", "d", "e"});
        writer.write(std::nextafter(0.35, 1), values);
    }
    const DataTable table = readDataTable(folder_ / "0/g.dat");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"Time", "a", "b", "c", "d", "e"}));
    EXPECT_EQ(table.header.at("x"), (std::vector<Real>{0.1, 0.25}));
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0][0], std::nextafter(0.35, 1));
    EXPECT_TRUE(std::equal(values.begin(), values.end(), table.rows[0].begin() + 1));
}

TEST_F(DataFile, ShowsARowToOtherReadersAsSoonAsItIsWritten)
{
    DataWriter writer(folder_ / "g.dat", {}, {"a"});
    writer.write(0, {1});
    EXPECT_EQ(readDataTable(folder_ / "g.dat").rows.size(), 1u);
}

TEST_F(DataFile, KeepsAFileThatStandsInItsPlace)
{
    for (int run = 0; run < 3; ++run) DataWriter(folder_ / "g.dat", {}, {"a"}).write(run, {0});
    EXPECT_EQ(readDataTable(folder_ / "g.dat.1").rows[0][0], 0);
    EXPECT_EQ(readDataTable(folder_ / "g.dat.2").rows[0][0], 1);
    EXPECT_EQ(readDataTable(folder_ / "g.dat").rows[0][0], 2);
}

TEST_F(DataFile, JoinsTheStartsOfARunAndTheLaterStartCounts)
{
    writeText("g/0/g.dat", "# Time a\n0 1\n0.5 2\n1 3\n");
    writeText("g/0.7/g.dat", "# Time a\n1 30\n1.5 40\n");
    const DataTable table = readAllStarts(folder_ / "g/");
    ASSERT_EQ(table.rows.size(), 4u);
    EXPECT_EQ(table.rows[2], (std::vector<Real>{1, 30}));
    writeText("g/2/g.dat", "# Time b\n2 1\n");
    EXPECT_THROW(readAllStarts(folder_ / "g"), FatalIOError);
    EXPECT_THROW(readAllStarts(folder_ / "nothing"), FatalError);
}

TEST_F(DataFile, LeavesOutALastLineThatWasCutOffAndNamesTheLineOfAWrongOne)
{
    writeText("cut.dat", "# Time a b\n0 1 2\n1 1");
    EXPECT_EQ(readDataTable(folder_ / "cut.dat").rows.size(), 1u);
    writeText("short.dat", "# Time a b\n0 1 2\n1 1\n");
    writeText("word.dat", "# Time a b\n0 1 2\n1 1 x\n");
    for (const std::string file : {"short.dat", "word.dat"}) {
        try {
            readDataTable(folder_ / file);
            FAIL() << file;
        } catch (const FatalIOError& error) {
            EXPECT_EQ(error.line(), 3);
        }
    }
    writeText("bare.dat", "0 1 2\n");
    EXPECT_THROW(readDataTable(folder_ / "bare.dat"), FatalError);
}
