// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/CsvFile.hpp"

#include "core/Error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

using namespace isph;

namespace {

class CsvFileTest : public testing::Test {
protected:
    void SetUp() override
    {
        file_ = std::filesystem::temp_directory_path() /
                ("isphCsv." + std::to_string(::getpid()) + ".csv");
    }
    void TearDown() override { std::filesystem::remove(file_); }
    CsvTable read(const std::string& text)
    {
        std::ofstream(file_) << text;
        return readCsv(file_);
    }
    std::string failure(const std::string& text)
    {
        try {
            read(text);
        } catch (const FatalError& error) {
            return error.what();
        }
        return "no error";
    }
    std::filesystem::path file_;
};

using Row = std::vector<Real>;

}  // namespace

TEST_F(CsvFileTest, ReadsNamesAndRowsPastComments)
{
    const CsvTable table = read("# source\r\n y , u/U\n\n1, 2e-3\n# more\n-0.5 ,4\r\n");
    EXPECT_EQ(table.names, (std::vector<std::string>{"y", "u/U"}));
    EXPECT_EQ(table.rows, (std::vector<Row>{{1, 2e-3}, {-0.5, 4}}));
    EXPECT_EQ(table.column("u/U"), 1u);
    EXPECT_EQ(table.column("2"), 1u);
    EXPECT_THROW(table.column("v"), FatalError);
    EXPECT_THROW(table.column("0"), FatalError);
    EXPECT_THROW(table.column("3"), FatalError);
}

TEST_F(CsvFileTest, MayHaveNoNames)
{
    EXPECT_EQ(read("1,2\n3,4").rows.size(), 2u);
}

TEST_F(CsvFileTest, SaysWhatIsNoTable)
{
    EXPECT_NE(failure("a,b\n1,x\n").find("'1,x'"), std::string::npos);
    EXPECT_NE(failure("1,2\n3\n").find("1 numbers, where the lines before have 2"),
              std::string::npos);
    EXPECT_NE(failure("a,b\n1\n").find("1 numbers, where the lines before have 2"),
              std::string::npos);
    EXPECT_NE(failure("# nothing\n").find("holds no row"), std::string::npos);
}

TEST_F(CsvFileTest, ACurveIsLinearBetweenRowsInAnyOrder)
{
    const CsvCurve curve(read("2,10\n0,0\n1,4\n"), 0, 1);
    EXPECT_DOUBLE_EQ(curve(0.5), 2);
    EXPECT_DOUBLE_EQ(curve(1.5), 7);
    EXPECT_DOUBLE_EQ(curve(1), 4);
    EXPECT_EQ(curve(-1), 0);
    EXPECT_EQ(curve(9), 10);
    EXPECT_THROW(CsvCurve(read("1,2\n1,3\n"), 0, 1), FatalError);
}
