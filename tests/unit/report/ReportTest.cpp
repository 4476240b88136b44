// SPDX-License-Identifier: GPL-3.0-or-later
// The program on a case whose solver is a script.
#include "ReportCase.hpp"

#include "RunLogs.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

using namespace isph;

namespace {

class IsphReport : public test::ReportCase {
protected:
    /// Its exit code; what it printed is in `output`.
    int run(const std::string& options = "")
    {
        const std::string line = std::string(ISPH_REPORT) + " -case " + case_.string() + " " +
                                 options + " > " + (case_ / "output").string() + " 2>&1";
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    bool printed(const std::string& words) const
    {
        return read("output").find(words) != std::string::npos;
    }
    /// Cells of the row of a variant in report.csv, by the names of the columns.
    std::map<std::string, std::string> row(const std::string& variant) const
    {
        std::istringstream csv(read("report/report.csv"));
        std::string names, line;
        std::getline(csv, names);
        while (std::getline(csv, line))
            if (line.starts_with(variant + ",")) break;
        std::map<std::string, std::string> cells;
        std::istringstream heads(names), values(line);
        for (std::string head, value; std::getline(heads, head, ',');) {
            std::getline(values, value, ',');
            cells[head] = value;
        }
        return cells;
    }
    std::size_t solverRuns() const
    {
        const std::string runs = read("report/runs");
        return static_cast<std::size_t>(std::count(runs.begin(), runs.end(), '\n'));
    }
};

const std::string kSpacings = "along spacing; vary { spacing { values (0.4 0.2 0.1); } } ";

}  // namespace

TEST_F(IsphReport, ObservesTheOrderOfASchemeOfSecondOrder)
{
    writeReportDict(kSpacings);
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(row("spacing=0.4")["L2"], "0.16");
    EXPECT_EQ(row("spacing=0.4")["order of L2"], "");
    EXPECT_EQ(row("spacing=0.2")["order of L2"], "2.00");
    EXPECT_EQ(row("base")["order of L2"], "2.00");
    EXPECT_EQ(row("base")["particles"], "12");
    EXPECT_EQ(row("base")["steps"], "2");
    EXPECT_EQ(row("base")["stable"], "yes");
    EXPECT_GT(std::stod(row("base")["memory [MB]"]), 0);
    EXPECT_NE(read("report/report.md").find("| base | 0.1 | 12 | 2 |"), std::string::npos);
    EXPECT_NE(read("report/L2-spacing.svg").find("slope 2.00"), std::string::npos);
    for (const char* plot : {"L2-wallTime.svg", "L2-wallTime.png", "L2-spacing.png"})
        EXPECT_GT(std::filesystem::file_size(case_ / "report" / plot), 1000u) << plot;
}

TEST_F(IsphReport, LeavesTheCaseAsItIsAndDoesNotCopyWhatItComputed)
{
    writeReportDict(kSpacings);
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(read("system/particlesDict"), "spacing 0.1; // d0\n");
    EXPECT_EQ(read("report/spacing=0.2/system/particlesDict"), "spacing 0.2; // d0\n");
    EXPECT_EQ(read("postProcessing/error/0/error.dat"), "of the case itself\n");
    EXPECT_FALSE(std::filesystem::exists(case_ / "report/base/report"));
}

TEST_F(IsphReport, RunsOnlyWhatIsNotFinishedOrHasChanged)
{
    writeReportDict(kSpacings);
    ASSERT_EQ(run(), 0) << read("output");
    ASSERT_EQ(solverRuns(), 3u);
    std::filesystem::remove(case_ / "report/base/reportResult");
    ASSERT_EQ(run(), 0);
    EXPECT_EQ(solverRuns(), 4u);
    EXPECT_TRUE(printed("2 of 3 variants are finished already"));
    writeReportDict("along spacing; vary { spacing { values (0.4 0.2 0.1 0.05); } } ");
    ASSERT_EQ(run(), 0);
    EXPECT_EQ(solverRuns(), 5u);
    EXPECT_EQ(row("spacing=0.05")["order of L2"], "2.00");
    write("constant/soil", "sand { coeffs { D50 [mm] 2; } }\n");
    ASSERT_EQ(run("-list"), 0);
    EXPECT_FALSE(printed("finished"));
    ASSERT_EQ(run("-again"), 0);
    EXPECT_EQ(solverRuns(), 9u);
}

TEST_F(IsphReport, RecordsWhyAVariantIsUnstable)
{
    writeReportDict(
        "parallel 3; vary { kernel { values (wendlandC2 cubicSpline wendlandC4); } }");
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(row("base")["stable"], "yes");
    EXPECT_EQ(row("kernel=cubicSpline")["stable"], "no");
    EXPECT_EQ(row("kernel=cubicSpline")["L2"], "");
    EXPECT_TRUE(printed("kernel=cubicSpline: unstable, it blew up, see 'x' (at time 0.5s)"));
    EXPECT_EQ(row("kernel=wendlandC4")["stable"], "not run");
    EXPECT_EQ(row("kernel=wendlandC4")["why"], "./mySolver ended with exit code 3");
    EXPECT_TRUE(printed("3 variants, 1 of them stable"));
}

/// The limit is long beside what a loaded machine needs to start a script, so that only the
/// variant that does not end meets it.
TEST_F(IsphReport, StopsAVariantAtTheTimeLimit)
{
    writeReportDict(
        "timeLimit 6; parallel 2; vary { kernel { values (wendlandC2 quinticSpline); } }");
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(row("base")["stable"], "yes");
    EXPECT_EQ(row("kernel=quinticSpline")["stable"], "stopped");
    EXPECT_EQ(row("kernel=quinticSpline")["why"], "time limit of 6 s (at time 0.5s)");
}

TEST_F(IsphReport, CallsARunUnstableThatExceedsALimit)
{
    writeReportDict(kSpacings +
                    "limits { error { series \"postProcessing/error\"; column L2; measure last; "
                    "above 0.1; } }");
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(row("spacing=0.4")["stable"], "no");
    EXPECT_EQ(row("spacing=0.4")["why"], "error 0.16 is above 0.1");
    EXPECT_EQ(row("spacing=0.2")["stable"], "yes");
}

TEST_F(IsphReport, TakesErrorsFromTheLinesOfACheck)
{
    write("system/reportDict",
          "commands (\"./mySolver\"); vary { spacing { values (0.1); } }\n"
          "check \"echo slip 0.5 mm bound 1 ok; echo run time 3 s; echo drift -2e-3 % bound 1e-3 "
          "FAIL\";");
    ASSERT_EQ(run(), 0) << read("output");
    EXPECT_EQ(row("base")["slip"], "0.5");
    EXPECT_EQ(row("base")["drift"], "0.002");
}

TEST_F(IsphReport, DrawsAMapForAGridOfTwoKeys)
{
    writeReportDict(
        "mode grid; vary { spacing { values (0.2 0.1); } kernel { values (wendlandC2 "
        "cubicSpline); } }");
    ASSERT_EQ(run(), 0) << read("output");
    const std::string map = read("report/L2-map.gnuplot");
    EXPECT_NE(map.find("$good << EOD\n0 0 0.04\n1 0 0.01\nEOD"), std::string::npos) << map;
    EXPECT_NE(map.find("$bad << EOD\n0 1\n1 1\nEOD"), std::string::npos) << map;
    EXPECT_GT(std::filesystem::file_size(case_ / "report/L2-map.png"), 1000u);
}

TEST_F(IsphReport, WithAnErrorInReportDictSaysSoOnceAndRunsNothing)
{
    writeReportDict("vary { kernl { values (cubicSpline); } }");
    EXPECT_EQ(run(), 1);
    EXPECT_TRUE(printed("Did you mean 'kernel'?"));
    EXPECT_TRUE(printed("system/reportDict at line 3"));
    const std::string text = read("output");
    EXPECT_EQ(text.find("FOAM FATAL"), text.rfind("FOAM FATAL"));
    EXPECT_FALSE(std::filesystem::exists(case_ / "report"));
}

TEST_F(IsphReport, StopsAtASignalAndGoesOnLater)
{
    writeReportDict(
        "vary { spacing { values (0.1); } kernel { values (wendlandC2 quinticSpline); } }");
    // --foreground: one signal, to the program alone; a second one ends it at once.
    const std::string line = "timeout --foreground -s TERM 2 " + std::string(ISPH_REPORT) +
                             " -case " + case_.string() + " > " + (case_ / "output").string() +
                             " 2>&1";
    ASSERT_NE(std::system(line.c_str()), 0);
    EXPECT_TRUE(printed("Stopped by signal 15")) << read("output");
    EXPECT_EQ(solverRuns(), 2u);
    EXPECT_TRUE(std::filesystem::exists(case_ / "report/base/reportResult"));
    EXPECT_FALSE(std::filesystem::exists(case_ / "report/kernel=quinticSpline/reportResult"));
    ASSERT_EQ(run("-list"), 0);
    EXPECT_TRUE(printed("finished   base"));
    EXPECT_TRUE(printed("to run     kernel=quinticSpline"));
}

TEST(RunLogs, TheLastProgressIsThatOfTheEnd)
{
    const auto file = std::filesystem::temp_directory_path() / "isphReportProgress.log";
    std::ofstream(file) << "Progress = 10.00 %  time left\n"
                        << std::string(9000, 'x') << "\nProgress = 42.50 %  time left = 3 s\nTime";
    EXPECT_NEAR(lastProgress(file), 0.425, 1e-15);
    std::filesystem::remove(file);
}
