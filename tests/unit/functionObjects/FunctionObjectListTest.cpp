// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObjectList.hpp"

#include "TestFlow.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

using namespace isph;
using namespace isph::test;
namespace fs = std::filesystem;

namespace {

constexpr Real kStep = 0.03;

StepInstant instant(int index)
{
    return {index * kStep, index == 0 ? 0 : kStep, index, index % 10 == 0};
}

class FunctionObjectListTest : public testing::Test {
protected:
    void SetUp() override
    {
        case_ = fs::temp_directory_path() / ("isphFunctionObjects." + std::to_string(::getpid()));
        fs::remove_all(case_);
        flow_ = emptyTank({});
        addWater(flow_, {0, 0, 0}, {0.2, 0.1, 0});
    }
    void TearDown() override { fs::remove_all(case_); }

    FunctionObjectList list(const std::string& functions, int startIndex = 0) const
    {
        const StepInstant start = instant(startIndex);
        return {Dictionary::parse("functions {" + functions + "}", "controlDict"),
                {case_, fmt::format("{:g}", start.value), start}};
    }
    /// Steps from..to as a solver takes them; how often the flow was asked for.
    int run(FunctionObjectList& functions, int from, int to)
    {
        int asked = 0;
        for (int k = from; k <= to; ++k) {
            if (!functions.due(instant(k))) continue;
            ++asked;
            setVelocity(flow_, [&](const Vector3&) { return Vector3{0.1 * k, 0, 0}; });
            functions.execute(flow_);
        }
        return asked;
    }
    std::vector<std::vector<Real>> rows(const std::string& name) const
    {
        return readAllStarts(case_ / "postProcessing" / name).rows;
    }
    std::vector<int> steps(const std::string& name) const
    {
        std::vector<int> all;
        for (const auto& row : rows(name))
            all.push_back(static_cast<int>(std::lround(row[0] / kStep)));
        return all;
    }
    std::string failure(const std::string& functions, int line) const
    {
        try {
            list(functions);
        } catch (const FatalIOError& error) {
            EXPECT_EQ(error.line(), line);
            return error.what();
        }
        return "no error";
    }

    fs::path case_;
    FlowView flow_;
};

std::string energy(const std::string& name, const std::string& keys)
{
    return name + " { type energy; " + keys + " }\n";
}

using Steps = std::vector<int>;

}  // namespace

TEST_F(FunctionObjectListTest, MeasuresAtTheStepsThatTheControlsName)
{
    FunctionObjectList functions =
        list(energy("every", "") + energy("third", "writeControl timeStep; writeInterval 3;") +
             energy("folders", "writeControl writeTime;") +
             energy("seconds", "writeControl runTime; writeInterval 0.1;") +
             energy("never", "writeControl none;") + energy("off", "enabled no;") +
             energy("window", "startTime 0.06; endTime 0.12;"));
    run(functions, 0, 10);
    EXPECT_EQ(steps("every"), (Steps{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    EXPECT_EQ(steps("third"), (Steps{0, 3, 6, 9}));
    EXPECT_EQ(steps("folders"), (Steps{0, 10}));
    EXPECT_EQ(steps("seconds"), (Steps{0, 3, 7, 10}));  // the steps nearest to 0.1, 0.2 and 0.3 s
    EXPECT_EQ(steps("window"), (Steps{2, 3, 4}));
    EXPECT_FALSE(fs::exists(case_ / "postProcessing/never"));
    EXPECT_FALSE(fs::exists(case_ / "postProcessing/off"));
}

TEST_F(FunctionObjectListTest, MeasuresErrorsAtTheEndOfTheRunOnce)
{
    const std::string norms = " { type errorNorms; field p; expression \"0\"; ";
    FunctionObjectList functions =
        list("third" + norms + "writeInterval 3; }" + "off" + norms + "enabled no; }" + "early" +
             norms + "writeInterval 4; endTime 0.2; }" + energy("energy", "writeInterval 4;"));
    run(functions, 0, 10);
    EXPECT_TRUE(functions.dueAtEnd(instant(10)));
    functions.execute(flow_);
    EXPECT_FALSE(functions.dueAtEnd(instant(10)));
    EXPECT_EQ(steps("third"), (Steps{0, 3, 6, 9, 10}));
    EXPECT_EQ(steps("early"), (Steps{0, 4}));
    EXPECT_EQ(steps("energy"), (Steps{0, 4, 8}));
    FunctionObjectList again = list("third" + norms + "writeInterval 3; }", 10);
    EXPECT_FALSE(again.dueAtEnd(instant(10))) << "a restart that takes no step";
}

TEST_F(FunctionObjectListTest, AsksForTheFlowOnlyInStepsThatNeedIt)
{
    FunctionObjectList functions =
        list(energy("third", "writeInterval 3;") + energy("fifth", "writeInterval 5;"));
    EXPECT_EQ(run(functions, 0, 30),
              15);  // of 31: multiples of 3 (11) and of 5 (7), less those of both (3)
    FunctionObjectList none;
    EXPECT_EQ(run(none, 0, 30), 0);
    EXPECT_TRUE(none.empty());
}

TEST_F(FunctionObjectListTest, ARestartMeasuresTheSameRowsAndKeepsTheOldFiles)
{
    const std::string objects =
        energy("third", "writeInterval 3;") +
        energy("seconds", "writeControl runTime; writeInterval 0.1;") +
        energy("folders", "writeControl writeTime;") +
        energy("window", "writeControl runTime; writeInterval 0.07; startTime 0.5;");
    const std::vector<std::string> names{"third", "seconds", "folders", "window"};
    FunctionObjectList whole = list(objects);
    run(whole, 0, 40);
    std::vector<std::vector<std::vector<Real>>> expected;
    for (const std::string& name : names) expected.push_back(rows(name));
    for (const int restart : {10, 17, 20}) {
        fs::remove_all(case_);
        FunctionObjectList before = list(objects);
        run(before, 0, restart);
        const auto first = rows("third");
        FunctionObjectList after = list(objects, restart);
        run(after, restart == 20 ? 21 : restart, 40);  // whether or not the first state is offered
        for (std::size_t k = 0; k < names.size(); ++k)
            EXPECT_EQ(rows(names[k]), expected[k]) << names[k] << restart;
        EXPECT_EQ(readDataTable(case_ / "postProcessing/third/0/third.dat").rows, first);
        for (const std::string& name : names) {
            const std::string folder = fmt::format("{:g}", instant(restart).value);
            const DataTable again =
                readDataTable(case_ / "postProcessing" / name / folder / (name + ".dat"));
            EXPECT_GT(again.rows.front()[0], instant(restart).value) << name;
        }
    }
}

TEST_F(FunctionObjectListTest, ExecutionBetweenWritesPrintsButAddsNoRow)
{
    FunctionObjectList functions = list(
        energy("watch", "log yes; writeInterval 4; executeControl timeStep; executeInterval 2;"));
    testing::internal::CaptureStdout();
    EXPECT_EQ(run(functions, 0, 4), 3);
    const std::string log = testing::internal::GetCapturedStdout();
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 3) << log;
    EXPECT_EQ(log.substr(0, 24), "energy watch: kinetic = ");
    EXPECT_EQ(steps("watch"), (Steps{0, 4}));
}

TEST_F(FunctionObjectListTest, TimeStepsMeetTheTimesOfAdjustableRunTime)
{
    const Dictionary dict = Dictionary::parse(
        "endTime 0.5; deltaT 0.03; writeInterval 1000; functions {" +
            energy("met", "writeControl adjustableRunTime; writeInterval 0.1;") + "}",
        "controlDict");
    Time time(dict, case_, {});
    FunctionObjectList functions(dict, {case_, time.name(), time.instant()});
    functions.meet(time);
    if (functions.due(time.instant())) functions.execute(flow_);
    while (time.run()) {
        time.advance();
        if (functions.due(time.instant())) functions.execute(flow_);
    }
    const auto measured = rows("met");
    ASSERT_EQ(measured.size(), 6u);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(measured[k][0], 0.1 * k, 1e-15);
}

TEST_F(FunctionObjectListTest, RereadingGoesOnWithWhatIsUnchangedAndBeginsAnewWithTheRest)
{
    const std::string same = energy("same", "");
    FunctionObjectList functions =
        list(same + energy("edited", "writeInterval 2;") + energy("removed", ""));
    run(functions, 0, 4);
    const auto read = [&](const std::string& text) {
        functions.reread(Dictionary::parse("functions {" + text + "}", "controlDict"),
                         {case_, "0.12", instant(4)});
    };
    EXPECT_THROW(read(energy("same", "typo 1;")), FatalIOError);
    EXPECT_EQ(functions.names().size(), 3u);
    read(same + energy("edited", "writeInterval 3;"));
    run(functions, 5, 9);
    EXPECT_EQ(steps("same").size(), 10u);
    EXPECT_FALSE(fs::exists(case_ / "postProcessing/same/0.12"));
    EXPECT_EQ(steps("edited"), (Steps{0, 2, 4, 6, 9}));
    EXPECT_EQ(steps("removed").size(), 5u);
}

TEST_F(FunctionObjectListTest, RefusesWrongKeysWithTheirLineAndWhatIsAllowed)
{
    EXPECT_NE(
        failure("\na { type energy;\n writeIntervall 3; }", 3).find("Did you mean 'writeInterval'"),
        std::string::npos);
    EXPECT_NE(failure("\na { type enrgy; }", 2)
                  .find("Unknown functionObject type enrgy, did you mean energy?"),
              std::string::npos);
    EXPECT_NE(failure("a { }", 1).find("keyword type is undefined"), std::string::npos);
    EXPECT_NE(failure(energy("a", "writeControl runTime;"), 1).find("writeInterval is undefined"),
              std::string::npos);
    EXPECT_NE(failure(energy("a", "writeControl hourly;"), 1).find("hourly is not in enumeration"),
              std::string::npos);
    EXPECT_NE(failure(energy("a", "writeInterval 2.5;"), 1).find("whole number"),
              std::string::npos);
    EXPECT_NE(
        failure(energy("a", "writeControl writeTime; writeInterval 2;"), 1).find("leave it out"),
        std::string::npos);
    EXPECT_NE(failure(energy("a", "startTime 2; endTime 1;"), 1).find("lies before startTime"),
              std::string::npos);
    EXPECT_NE(failure("a 3;", 1).find("is not a sub-dictionary"), std::string::npos);
}

TEST_F(FunctionObjectListTest, RefusesALibraryThatIsNotThere)
{
    EXPECT_THROW(list(energy("a", "libs (\"libnothing.so\");")), FatalError);
}

TEST_F(FunctionObjectListTest, WritesTheHeaderOfTheModelAboveItsColumns)
{
    FunctionObjectList functions =
        list("gauge { type waterLevel; line { start (0.05 0 0); end (0.15 0 0); n 3; } }");
    run(functions, 0, 2);
    const DataTable table = readDataTable(case_ / "postProcessing/gauge/0/gauge.dat");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"Time", "level_0", "level_1", "level_2"}));
    EXPECT_EQ(table.header.at("x"), (std::vector<Real>{0.05, 0.1, 0.15}));
    EXPECT_EQ(table.rows.size(), 3u);
}
