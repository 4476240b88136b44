// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Time.hpp"

#include "case/StopSignal.hpp"
#include "core/Log.hpp"
#include "core/Timers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace isph {

namespace {

const std::vector<std::string> kStopAt = {"endTime", "noWriteNow", "writeNow", "nextWrite"};
const std::vector<std::string> kFormats = {"general", "fixed", "scientific"};
const std::vector<std::string> kWriteControls = {"timeStep", "runTime", "adjustableRunTime",
                                                 "clockTime", "cpuTime"};

template <class Enum>
Enum choice(const Schema& keys, const Dictionary& dict, const std::string& key,
            const std::vector<std::string>& names)
{
    const auto name = keys.get<std::string>(dict, key);
    return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Steps left for the distance to a target that is `steps` wanted steps away (OpenFOAM 10's rule).
Real stepsLeft(Real steps)
{
    return std::floor(std::max(steps, 1.0) + 0.99);
}

}  // namespace

Schema controlDictKeys()
{
    return {
        Key::word("application", "Program that runs the case.").mayBeAbsent(),
        Key::word("startFrom", "Time folder to start from.")
            .oneOf({"startTime", "firstTime", "latestTime"})
            .byDefault("latestTime"),
        Key::scalar("startTime", "Time to start from with startFrom startTime.")
            .units(dims::time)
            .mayBeAbsent(),
        Key::word(
            "stopAt",
            "When to stop: at endTime; at once without or with writing; at the next write time.")
            .oneOf(kStopAt)
            .byDefault("endTime"),
        Key::scalar("endTime", "Time at which the run ends.").units(dims::time),
        Key::scalar("deltaT", "Step; with adjustTimeStep the first one.")
            .units(dims::time)
            .above(0),
        Key::logical("adjustTimeStep",
                     "Choose the step by maxCo and the limits of viscosity and force.")
            .byDefault("no"),
        Key::scalar("maxCo", "Largest Courant number, step times speed over local spacing.")
            .above(0)
            .byDefault("0.2"),
        Key::scalar("maxDeltaT", "Largest step.").units(dims::time).above(0).mayBeAbsent(),
        Key::word("writeControl",
                  "What writeInterval counts: steps, seconds of the flow (adjustableRunTime: met "
                  "exactly), "
                  "of wall time or of processor time.")
            .oneOf(kWriteControls)
            .byDefault("timeStep"),
        Key::scalar("writeInterval", "Steps or seconds between time folders.").above(0),
        Key::integer("purgeWrite",
                     "Time folders of this run that are kept, the latest; 0 keeps all.")
            .atLeast(0)
            .byDefault("0"),
        Key::word("timeFormat", "Form of the names of time folders.")
            .oneOf(kFormats)
            .byDefault("general"),
        Key::integer("timePrecision", "Digits of the names of time folders.")
            .atLeast(1)
            .atMost(17)
            .byDefault("6"),
        Key::logical("runTimeModifiable", "Read this file again when it changes during the run.")
            .byDefault("yes"),
        Key::list("libs", "Libraries with models of the user's.").mayBeAbsent(),
        Key::dictionary("functions",
                        "Function objects, each a dictionary with a name of the user's.")
            .mayBeAbsent(),
    };
}

std::string timeName(Real value, TimeFormat format, int precision)
{
    switch (format) {
        case TimeFormat::fixed:
            return fmt::format("{:.{}f}", value, precision);
        case TimeFormat::scientific:
            return fmt::format("{:.{}e}", value, precision);
        case TimeFormat::general:
            break;
    }
    return fmt::format("{:.{}g}", value, precision);
}

Time::Time(const Dictionary& controlDict, const std::filesystem::path& caseDir,
           const TimeState& start)
    : controlDict_(controlDict),
      caseDir_(caseDir),
      value_(start.value),
      startValue_(start.value),
      index_(start.index),
      deltaT_(start.deltaT),
      deltaT0_(start.deltaT0),
      wallStart_(wallSeconds())
{
    readControls();
    requireWayToGo();
    writeControl_.startAt(instant());
    std::error_code absent;  // a dictionary of a test has no file
    modified_ = std::filesystem::last_write_time(caseDir_ / "system" / "controlDict", absent);
}

void Time::readControls()
{
    const Schema keys = controlDictKeys();
    keys.check(controlDict_);
    const TimeControl control = TimeControl::read(controlDict_, "write");
    if (control.kind() != writeControl_.kind() || control.interval() != writeControl_.interval()) {
        writeControl_ = control;
        writeControl_.startAt(instant());
    }
    stopAt_ = choice<StopAt>(keys, controlDict_, "stopAt", kStopAt);
    endTime_ = keys.get<Real>(controlDict_, "endTime");
    fixedDeltaT_ = keys.get<Real>(controlDict_, "deltaT");
    adjustTimeStep_ = keys.get<bool>(controlDict_, "adjustTimeStep");
    maxCo_ = keys.get<Real>(controlDict_, "maxCo");
    maxDeltaT_ = controlDict_.getOrDefault<Real>("maxDeltaT", std::numeric_limits<Real>::infinity(),
                                                 dims::time);
    purgeWrite_ = keys.get<int>(controlDict_, "purgeWrite");
    format_ = choice<TimeFormat>(keys, controlDict_, "timeFormat", kFormats);
    precision_ = keys.get<int>(controlDict_, "timePrecision");
    modifiable_ = keys.get<bool>(controlDict_, "runTimeModifiable");
}

/// Of a start: endTime lies ahead (or was reached within the half step that run() allows), and a
/// first step of fixed size does not pass it.
void Time::requireWayToGo() const
{
    const Real step = std::max(deltaT_, adjustTimeStep_ ? 0 : fixedDeltaT_);
    const Real rounding = 1e-6 * std::abs(value_);
    if (endTime_ < value_ - 0.5 * step - rounding)
        controlDict_.fail(
            "endTime",
            fmt::format("endTime {} s lies before the start of the run, {} s. Choose another "
                        "endTime, or the start by startFrom and startTime.",
                        endTime_, value_));
    const bool fitted =
        adjustTimeStep_ || writeControl_.kind() == TimeControl::Kind::adjustableRunTime;
    if (index_ == 0 && !fitted && endTime_ > value_ &&
        fixedDeltaT_ > (endTime_ - value_) * (1 + 1e-6))
        controlDict_.fail("deltaT",
                          fmt::format("deltaT {} s is longer than the whole run, {} s to {} s",
                                      fixedDeltaT_, value_, endTime_));
}

void Time::rereadIfModified()
{
    if (!modifiable_) return;
    const std::filesystem::path file = caseDir_ / "system" / "controlDict";
    std::error_code absent;
    const auto modified = std::filesystem::last_write_time(file, absent);
    if (absent || modified == modified_) return;  // absent: an editor is saving it
    modified_ = modified;
    info("Re-reading object controlDict from file \"{}\"", file.string());
    const Dictionary before = controlDict_;
    try {
        controlDict_ = Dictionary::read(file);
        readControls();
        ++rereads_;
    } catch (const FatalError& error) {
        const auto* place = dynamic_cast<const FatalIOError*>(&error);
        warning("{}\n{} line {}: the settings before the change stay", error.what(),
                place ? place->file() : file.string(), place ? place->line() : 0);
        controlDict_ = before;
        readControls();
    }
}

std::string Time::name() const
{
    // Two steps may not share a name: where the precision is too small for the step, digits are
    // added.
    constexpr int most = 17;
    int precision = precision_;
    while (precision < most &&
           timeName(value_, format_, precision) == timeName(value_ - deltaT_, format_, precision) &&
           deltaT_ > 0)
        ++precision;
    return timeName(value_, format_, precision);
}

TimeState Time::state() const
{
    return {value_, name(), index_, deltaT_, deltaT0_, {}};
}

bool Time::run()
{
    if (!stopped_) rereadIfModified();
    if (stopAt_ == StopAt::noWriteNow) stopped_ = true;
    return !stopped_ && value_ < endTime_ - 0.5 * deltaT_;
}

void Time::setDeltaT(Real wanted)
{
    if (!(wanted > 0) || !std::isfinite(wanted))
        throw FatalError(fmt::format("the step after time {} would be {} s long", value_, wanted));
    fitStep(wanted);
}

void Time::fitStep(Real wanted)
{
    if (!stepIsSet_) deltaT0_ = deltaT_;
    stepIsSet_ = true;

    Real next = writeControl_.nextTime(value_);
    for (const TimeControl& control : alsoMet_) {
        const Real other = control.nextTime(value_);
        if (other < next - 1e-6 * control.interval())
            next = other;  // else it is the write time itself
    }
    const Real steps = std::isfinite(next) ? stepsLeft((next - value_) / wanted) : 0;
    deltaT_ = steps > 0 ? (next - value_) / steps : wanted;
    target_ = steps == 1 ? next : std::numeric_limits<Real>::quiet_NaN();
}

void Time::advance()
{
    if (!stepIsSet_) fitStep(fixedDeltaT_);
    stepIsSet_ = false;
    value_ = std::isnan(target_) ? value_ + deltaT_ : target_;
    ++index_;

    writeTime_ = false;
    const bool scheduled = writeControl_.due(instant());
    const bool stopNow = stopSignal() != 0 || stopAt_ == StopAt::writeNow;
    writeTime_ = scheduled || stopNow;
    stopped_ = stopNow || (scheduled && stopAt_ == StopAt::nextWrite);
}

void Time::alsoMeet(const TimeControl& control)
{
    if (control.kind() == TimeControl::Kind::adjustableRunTime) alsoMet_.push_back(control);
}

Real Time::progress() const
{
    return endTime_ > 0 ? std::clamp(100 * value_ / endTime_, 0.0, 100.0) : 100;
}

Real Time::secondsLeft() const
{
    const Real done = value_ - startValue_;
    return done > 0 ? (wallSeconds() - wallStart_) * std::max(endTime_ - value_, 0.0) / done : 0;
}

int Time::exitCode() const
{
    return stopped_ && stopSignal() != 0 ? 128 + stopSignal() : 0;
}

}  // namespace isph
