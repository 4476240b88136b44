// SPDX-License-Identifier: GPL-3.0-or-later
#include "Comparison.hpp"

#include "core/Error.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

using namespace isph;
namespace fs = std::filesystem;

namespace {

struct Outcome {
    int code;
    std::string text;  ///< stdout and stderr
};

class Compare : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("isphCompare." + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        writeText("speed.dat", "# energy e\n# Time maxSpeed other\n0 0 1\n1 -3 1\n2 2 1\n3 1 1\n");
        // A surface that falls by 0.1 m/s everywhere, 0.3 - 0.1 t - 0.2 x at x = 0 .. 1
        writeText("gauge/0/gauge.dat",
                  "# waterLevel gauge\n# x 0 0.5 1\n# Time level_0 level_1 level_2\n"
                  "0 0.3 0.2 0.1\n1 0.2 0.1 0\n");
        writeText("gauge/1/gauge.dat",
                  "# x 0 0.5 1\n# Time level_0 level_1 level_2\n2 0.1 0 -0.1\n");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void writeText(const fs::path& file, const std::string& text) const
    {
        fs::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file) << text;
    }
    Source series(const std::string& columns) const
    {
        Source source = anyTime();
        source.series = folder_ / "speed.dat";
        source.columns = columns;
        return source;
    }
    Source profile() const
    {
        Source source = anyTime();
        source.profile = folder_ / "gauge";
        return source;
    }
    Outcome run(const std::string& options) const
    {
        const std::string command =
            std::string(ISPH_COMPARE) + " -case '" + folder_.string() + "' " + options + " 2>&1";
        FILE* pipe = popen(command.c_str(), "r");
        std::string text;
        std::array<char, 256> part{};
        while (fgets(part.data(), part.size(), pipe)) text += part.data();
        return {WEXITSTATUS(pclose(pipe)), text};
    }

    fs::path folder_;

private:
    static Source anyTime()
    {
        Source source;
        source.from = -std::numeric_limits<Real>::infinity();
        source.to = std::numeric_limits<Real>::infinity();
        return source;
    }
};

}  // namespace

TEST_F(Compare, MeasuresAreWhatTheirNamesSay)
{
    const std::vector<Sample> all = samples(series("maxSpeed"), {});  // 0 -3 2 1
    EXPECT_DOUBLE_EQ(measure("last", all), 1);
    EXPECT_DOUBLE_EQ(measure("mean", all), 0);
    EXPECT_DOUBLE_EQ(measure("max", all), 3);
    EXPECT_DOUBLE_EQ(measure("min", all), 0);
    EXPECT_DOUBLE_EQ(measure("rms", all), std::sqrt(14.0 / 4));
    EXPECT_DOUBLE_EQ(measure("range", all), 5);
}

TEST_F(Compare, ASeriesIsCutToItsTimesAndPooledOverColumns)
{
    Source source = series("max* other");
    source.from = 2;
    EXPECT_EQ(samples(source, {}).size(), 4u);
    source.to = 2.5;
    EXPECT_DOUBLE_EQ(measure("mean", samples(source, {1, {}})), 0.5);  // of 2 and 1 less 1
    source.times = {0.5, 2.25};
    source.columns = "maxSpeed";
    const std::vector<Sample> between = samples(source, {});
    EXPECT_DOUBLE_EQ(between[0].measured, -1.5);
    EXPECT_DOUBLE_EQ(between[1].measured, 1.75);
}

TEST_F(Compare, AReferenceThatBeganLaterIsFoundWithinTheGivenDelay)
{
    writeText("late.csv", "t,speed\n1.25,-3\n2.25,2\n");
    const std::string options =
        "-name v -bound 0.1 -series speed.dat -column maxSpeed -reference late.csv -measure rms";
    EXPECT_EQ(run(options).code, 1);
    const Outcome found = run(options + " -delay 0.5");
    EXPECT_EQ(found.code, 0);
    EXPECT_NE(found.text.find("v(delay=0.25s) 0 - bound 0.1 ok"), std::string::npos) << found.text;
    EXPECT_EQ(run(options + " -delay 0.1").code, 1);   // not beyond what is allowed
    EXPECT_EQ(run("-name v -bound 9 -series speed.dat -column maxSpeed -delay 1").code, 1);
}

TEST_F(Compare, ASeriesIsHeldAgainstAReferenceAtItsTimes)
{
    writeText("ref.csv", "# experiment\nt_s,v\n0.5,-1.4\n2,2.3\n");
    const std::vector<Sample> all = samples(series("maxSpeed"), {0, folder_ / "ref.csv"});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(measure("max", all), 0.3, 1e-15);
    EXPECT_NEAR(measure("max", inPerCent(all)), 100 * 0.3 / 2.3, 1e-12);
}

TEST_F(Compare, ABandLeavesOutWhatLiesWithinIt)
{
    // The speed falls to -3 at 1 s and rises to 2 at 2 s: 5 m/s in a second; the band is -2 to 0,
    // then 1 to 3.
    writeText("band.csv", "t,speed,low,high\n1,-1,-2,0\n1.5,-1,-2,0\n1.500001,2,1,3\n2,2,1,3\n");
    const Expectation band{0, folder_ / "band.csv", true};
    const std::vector<Sample> all = samples(series("maxSpeed"), band);
    // Outside until -2 is reached at 1.2 s, within until 1.5 s, outside until 1 is reached at 1.8
    // s.
    EXPECT_NEAR(measure("outside", all), 50, 0.2);
    EXPECT_NEAR(measure("max", all), 1.5, 0.01);
    Source late = series("maxSpeed");
    late.from = 1.8;
    EXPECT_NEAR(measure("outside", samples(late, band)), 0, 0.5);
    // From 2 to 3 s it falls from 2 to 1.
    writeText("below.csv", "t,speed,low,high\n2,1,0,1.5\n3,1,0,1.5\n");
    const Expectation below{0, folder_ / "below.csv", true};
    EXPECT_NEAR(measure("outside", samples(series("maxSpeed"), below)), 50, 0.2);
}

TEST_F(Compare, AMovingAverageIsThatOfTheLinesBetweenTheRows)
{
    // Rows 0, -3, 2, 1: over one second about 1 s the mean is that of -1.5 .. -3 and -3 .. -0.5.
    Source source = series("maxSpeed");
    source.average = 1;
    const std::vector<Sample> all = samples(source, {});
    ASSERT_EQ(all.size(), 4U);
    EXPECT_NEAR(all[1].measured, (0.5 * -2.25 + 0.5 * -1.75), 1e-12);
    EXPECT_NEAR(all[0].measured, -0.75, 1e-12);   // half of it lies before the first row
    source.average = 1e-9;
    EXPECT_NEAR(samples(source, {})[1].measured, -3, 1e-6);
}

TEST_F(Compare, AProfileIsInterpolatedInPlaceAndTimeAcrossARestart)
{
    // 10 mm above the exact surface at one point, 20 mm below it at the other; a third time is not
    // asked for
    writeText("ref.csv", "t_s,x_m,z_m\n0.5,0.25,0.21\n1.5,0.75,-0.02\n2,0.5,99\n");
    Source source = profile();
    source.times = {0.5, 1.5};
    const std::vector<Sample> all = samples(source, {0, folder_ / "ref.csv"});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(measure("rms", all), std::sqrt((1e-4 + 4e-4) / 2), 1e-15);
    source.times = {0.7};
    EXPECT_THROW(samples(source, {0, folder_ / "ref.csv"}), FatalError);
}

TEST_F(Compare, TheFrontIsWhereTheProfileLastFallsThroughTheLevel)
{
    Source source = profile();
    source.front = 0.05;
    const std::vector<Sample> all = samples(source, {});  // x = (0.25 - 0.1 t)/0.2, inside 0 .. 1
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NEAR(all[0].measured, 1, 1e-15);
    EXPECT_NEAR(all[1].measured, 0.75, 1e-15);
    EXPECT_NEAR(all[2].measured, 0.25, 1e-15);
}

TEST_F(Compare, RefusesPlacesAndTimesThatWereNotMeasured)
{
    Source source = profile();
    writeText("far.csv", "0.5,1.2,0.1\n");
    EXPECT_THROW(samples(source, {0, folder_ / "far.csv"}), FatalError);
    writeText("late.csv", "9,0.5,0.1\n");
    EXPECT_THROW(samples(source, {0, folder_ / "late.csv"}), FatalError);
    writeText("word.csv", "t,x,z\n0.5,0.5,0.1\n0.5,x,0.1\n");
    try {
        samples(source, {0, folder_ / "word.csv"});
        FAIL() << "no error";
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.line(), 3);
    }
    EXPECT_THROW(samples(series("speed"), {}), FatalError);
    source = series("maxSpeed");
    source.from = 10;
    EXPECT_THROW(samples(source, {}), FatalError);
}

TEST_F(Compare, TheProgramPrintsOneLineAndItsExitCodeIsTheVerdict)
{
    const std::string speed = "-name maxU -unit m/s -series speed.dat -column maxSpeed ";
    Outcome outcome = run(speed + "-bound 3.5");
    EXPECT_EQ(outcome.text, "maxU 3 m/s bound 3.5 ok\n");
    EXPECT_EQ(outcome.code, 0);
    outcome = run(speed + "-bound 2 -measure last -expect -2");
    EXPECT_EQ(outcome.text, "maxU 3 m/s bound 2 FAIL\n");
    EXPECT_EQ(outcome.code, 1);
    outcome = run("-name solids -value 12.6 -expect 12.5 -relative -bound 1");
    EXPECT_EQ(outcome.text, "solids 0.8 % bound 1 ok\n");
    outcome = run("-name volume -unit % -value -0.013 -scale 100 -bound 1");
    EXPECT_EQ(outcome.text, "volume 1.3 % bound 1 FAIL\n");
    outcome = run("-name x -value nan -bound 1");
    EXPECT_EQ(outcome.code, 1);
}

TEST_F(Compare, TheProgramRefusesOptionsThatDoNotGoTogether)
{
    for (const std::string options :
         {"-name x -value 1", "-name x -bound 1",
          "-name x -bound 1 -value 1 -series speed.dat -column other",
          "-name x -bound 1 -series speed.dat", "-name x -bound 1 -series nothing.dat -column a",
          "-name x -bound 1 -value 1 -measure median", "-name x -bound 1 -profile gauge",
          "-name x -bound 1 -value 1 -from 2", "-name x -bound 1 -value 1 -relative",
          "-name x -bound 1 -series speed.dat -column other -times 'soon'"}) {
        const Outcome outcome = run(options);
        EXPECT_EQ(outcome.code, 1) << options;
        EXPECT_NE(outcome.text.find("--> FOAM FATAL"), std::string::npos)
            << options << outcome.text;
    }
}
