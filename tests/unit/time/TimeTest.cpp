// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Time.hpp"

#include "case/StopSignal.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>

namespace isph {
namespace {

const std::string kAdjustable =
    "startFrom startTime; startTime 0; endTime 1; deltaT 1e-3; adjustTimeStep yes; maxCo 0.3;"
    "writeControl adjustableRunTime; writeInterval 0.05;";

Time timeOf(const std::string& controlDict, const TimeState& start = {})
{
    return {Dictionary::parse(controlDict, "controlDict"), "/nonexistent", start};
}

/// A step as a flow would want it: changes all the time, depends on what a restart knows.
Real wantedStep(const Time& time)
{
    const Real limit = 2e-3 * (1.2 + std::sin(40 * time.value()));
    return time.index() == 0 ? 1e-3 : std::min(limit, 1.2 * time.deltaT());
}

struct Step {
    int index;
    Real value, deltaT, deltaT0;
    friend bool operator==(const Step&, const Step&) = default;
};

std::vector<Step> stepsOf(Time& time, std::vector<TimeState>* written = nullptr)
{
    std::vector<Step> steps;
    while (time.run()) {
        if (time.adjustTimeStep()) time.setDeltaT(wantedStep(time));
        time.advance();
        steps.push_back({time.index(), time.value(), time.deltaT(), time.deltaT0()});
        if (written && time.writeTime()) written->push_back(time.state());
    }
    return steps;
}

TEST(Time, AdjustableWriteTimesAreHitExactly)
{
    Time time = timeOf(kAdjustable);
    std::vector<TimeState> written;
    stepsOf(time, &written);
    ASSERT_EQ(written.size(), 20u);
    for (std::size_t n = 0; n < written.size(); ++n) {
        EXPECT_EQ(written[n].value, static_cast<Real>(n + 1) * 0.05);  // the very number
    }
    EXPECT_EQ(written[2].name, "0.15");
    EXPECT_EQ(written.back().name, "1");
}

TEST(Time, TheFittedStepExceedsTheWantedOneByAtMostOnePercentAndIsNoSliver)
{
    Time time = timeOf(kAdjustable);
    while (time.run()) {
        const Real wanted = wantedStep(time), left = 0.05 - std::fmod(time.value() + 1e-12, 0.05);
        time.setDeltaT(wanted);
        EXPECT_LE(time.deltaT(), 1.01 * wanted * (1 + 1e-12));
        EXPECT_GE(time.deltaT(), 0.5 * std::min(wanted, left));  // two halves at worst
        time.advance();
    }
}

TEST(Time, TheStepBeforeTheLastIsKnown)
{
    Time time = timeOf(kAdjustable);
    const std::vector<Step> steps = stepsOf(time);
    EXPECT_EQ(steps[0].deltaT0, 0);
    for (std::size_t n = 1; n < steps.size(); ++n) {
        EXPECT_EQ(steps[n].deltaT0, steps[n - 1].deltaT);
        EXPECT_NEAR(steps[n].value - steps[n - 1].value, steps[n].deltaT,
                    1e-15);  // round-off of 1 s
    }
}

TEST(Time, AFixedStepIsFittedToWriteTimesToo)
{
    Time time =
        timeOf("endTime 0.3; deltaT 0.04; writeControl adjustableRunTime; writeInterval 0.1;");
    std::vector<TimeState> written;
    const std::vector<Step> steps = stepsOf(time, &written);
    EXPECT_EQ(steps.size(), 9u);  // 3 steps of 0.1/3 for 2.5 wanted ones
    ASSERT_EQ(written.size(), 3u);
    EXPECT_EQ(written[2].value, 3 * 0.1);
}

TEST(Time, AStepLongerThanTheIntervalMeetsEveryWriteTime)
{
    Time time = timeOf("endTime 1; deltaT 5; writeControl adjustableRunTime; writeInterval 0.25;");
    EXPECT_EQ(stepsOf(time).size(), 4u);
}

TEST(Time, ARestartFromAnyWrittenTimeTakesTheSameStepsBitForBit)
{
    for (const std::string& control : {kAdjustable,
                                       std::string("endTime 1; deltaT 1e-3; adjustTimeStep yes; "
                                                   "writeControl timeStep; writeInterval 37;"),
                                       std::string("endTime 1; deltaT 1e-3; adjustTimeStep yes; "
                                                   "writeControl runTime; writeInterval 0.07;")}) {
        Time whole = timeOf(control);
        std::vector<TimeState> written;
        const std::vector<Step> steps = stepsOf(whole, &written);
        ASSERT_GT(written.size(), 5u);
        for (std::size_t n = 0; n + 1 < written.size(); ++n) {
            Time again = timeOf(control, written[n]);
            std::vector<TimeState> writtenAgain;
            const std::vector<Step> rest = stepsOf(again, &writtenAgain);
            EXPECT_EQ(rest, std::vector<Step>(steps.begin() + written[n].index, steps.end()));
            EXPECT_EQ(writtenAgain.size(), written.size() - n - 1);
        }
    }
}

TEST(Time, ALaterEndDoesNotChangeTheStepsBeforeIt)
{
    Time shorter = timeOf(kAdjustable);
    Time longer = timeOf(kAdjustable + "endTime 1.37;");
    const std::vector<Step> first = stepsOf(shorter), all = stepsOf(longer);
    ASSERT_GT(all.size(), first.size());
    EXPECT_EQ(first, std::vector<Step>(all.begin(), all.begin() + static_cast<long>(first.size())));
    EXPECT_NEAR(all.back().value, 1.37, 0.5 * all.back().deltaT);
}

TEST(Time, TimesOfFunctionObjectsAreMetAndWriteTimesStayExact)
{
    Time time = timeOf(kAdjustable);
    TimeControl gauge(TimeControl::Kind::adjustableRunTime, 0.01);
    time.alsoMeet(gauge);
    int writes = 0, measurements = 0;
    while (time.run()) {
        time.setDeltaT(0.003);
        time.advance();
        EXPECT_GT(time.deltaT(),
                  0.0015);  // no sliver where 0.15 and 3*0.05 differ in their last bit
        if (gauge.due(time.instant())) ++measurements;
        if (!time.writeTime()) continue;
        EXPECT_EQ(time.value(), ++writes * 0.05);
    }
    EXPECT_EQ(writes, 20);
    EXPECT_EQ(measurements, 100);
}

TEST(Time, RunTimeWritesOncePerIntervalAtTheNearestStep)
{
    Time time = timeOf("endTime 1; deltaT 0.03; writeControl runTime; writeInterval 0.1;");
    std::vector<TimeState> written;
    stepsOf(time, &written);
    ASSERT_EQ(written.size(), 10u);
    for (std::size_t n = 0; n < written.size(); ++n)
        EXPECT_NEAR(written[n].value, 0.1 * static_cast<Real>(n + 1), 0.5 * 0.03 + 1e-12);
}

TEST(Time, WallClockWritesDoNotDependOnTheFlow)
{
    Time time = timeOf("endTime 1e9; deltaT 1; writeControl clockTime; writeInterval 0.01;");
    const auto start = std::chrono::steady_clock::now();
    int writes = 0;
    while (time.run() && writes < 3) {
        time.advance();
        if (time.writeTime()) ++writes;
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_GE(elapsed.count(), 0.03 - 1e-3);
}

TEST(Time, NamesFollowFormatAndPrecisionAndGrowWhereStepsWouldShareOne)
{
    EXPECT_EQ(timeName(0.15000000000000002, TimeFormat::general, 6), "0.15");
    EXPECT_EQ(timeName(0.05, TimeFormat::fixed, 4), "0.0500");
    EXPECT_EQ(timeName(0.05, TimeFormat::scientific, 2), "5.00e-02");
    Time time =
        timeOf("endTime 1; deltaT 1e-4; timePrecision 3; writeControl timeStep; writeInterval 1;",
               {0.1234, "0.1234", 5, 1e-4, 1e-4, {}});
    time.advance();
    EXPECT_EQ(time.name(), "0.1235");
}

TEST(Time, StepZeroOrNegativeOrNotANumberIsAnError)
{
    Time time = timeOf(kAdjustable);
    EXPECT_THROW(time.setDeltaT(0), FatalError);
    EXPECT_THROW(time.setDeltaT(-1e-3), FatalError);
    EXPECT_THROW(time.setDeltaT(std::nan("")), FatalError);
}

TEST(Time, StopAtNextWriteEndsThereAndNoWriteNowAtOnce)
{
    Time next = timeOf(kAdjustable + "stopAt nextWrite;");
    EXPECT_EQ(stepsOf(next).back().value, 0.05);
    Time now = timeOf(kAdjustable + "stopAt noWriteNow;");
    EXPECT_TRUE(stepsOf(now).empty());
    Time write = timeOf(kAdjustable + "stopAt writeNow;");
    std::vector<TimeState> written;
    EXPECT_EQ(stepsOf(write, &written).size(), 1u);
    EXPECT_EQ(written.size(), 1u);
    EXPECT_EQ(write.exitCode(), 0);
}

TEST(Time, AStopSignalWritesTheStateAndGivesTheExitCode)
{
    for (const int signal : {SIGINT, SIGTERM}) {
        catchStopSignals();
        Time time = timeOf(kAdjustable);
        std::vector<TimeState> written;
        for (int step = 0; step < 3 && time.run(); ++step) time.advance();
        std::raise(signal);
        const std::vector<Step> rest = stepsOf(time, &written);
        EXPECT_EQ(rest.size(), 1u);
        ASSERT_EQ(written.size(), 1u);
        EXPECT_EQ(written[0].index, 4);
        EXPECT_EQ(time.exitCode(), 128 + signal);
    }
    catchStopSignals();
}

TEST(Time, ProgressIsTheShareOfEndTime)
{
    Time time = timeOf("endTime 2; deltaT 0.5; writeInterval 1;");
    time.advance();
    EXPECT_DOUBLE_EQ(time.progress(), 25);
    EXPECT_GE(time.secondsLeft(), 0);
}

}  // namespace
}  // namespace isph
