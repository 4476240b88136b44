// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TimeControl.hpp"

#include "core/Timers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph {

namespace {

/// Of an interval: times that are nearer to a multiple than this are that multiple. Far above the
/// round-off of n*interval, far below any step.
constexpr Real kSameTime = 1e-6;

const std::vector<std::string> kNames = {
    "timeStep", "runTime", "adjustableRunTime", "clockTime", "cpuTime", "writeTime", "none"};

std::int64_t wholeIntervals(Real amount, Real interval)
{
    return static_cast<std::int64_t>(std::floor(amount / interval));
}

}  // namespace

std::vector<std::string> TimeControl::kindNames()
{
    return kNames;
}

TimeControl TimeControl::read(const Dictionary& dict, const std::string& prefix, Kind otherwise,
                              Real otherwiseInterval)
{
    const std::string control = prefix + "Control", interval = prefix + "Interval";
    const std::string name =
        dict.getChoice(control, kNames, kNames[static_cast<std::size_t>(otherwise)]);
    const auto kind =
        static_cast<Kind>(std::find(kNames.begin(), kNames.end(), name) - kNames.begin());
    if (kind == Kind::none || kind == Kind::writeTime) return {kind, 0};
    const Dimensions units = kind == Kind::timeStep ? dims::none : dims::time;
    const Real value = otherwiseInterval > 0
                           ? dict.getOrDefault<Real>(interval, otherwiseInterval, units)
                           : dict.get<Real>(interval, units);
    if (!(value > 0)) dict.fail(interval, interval + " must be greater than 0");
    if (kind == Kind::timeStep && value != std::floor(value))
        dict.fail(interval, interval + " counts steps with " + control +
                                " timeStep: a whole number, 1 or more");
    return {kind, value};
}

TimeControl::TimeControl(Kind kind, Real interval) : kind_(kind), interval_(interval)
{
    if (kind_ == Kind::clockTime) origin_ = wallSeconds();
    if (kind_ == Kind::cpuTime) origin_ = cpuSeconds();
}

void TimeControl::startAt(const StepInstant& start)
{
    if (kind_ == Kind::runTime) done_ = wholeIntervals(start.value + 0.5 * start.deltaT, interval_);
}

bool TimeControl::passed(Real amount)
{
    const std::int64_t multiples = wholeIntervals(amount, interval_);
    if (multiples <= done_) return false;
    done_ = multiples;
    return true;
}

bool TimeControl::due(const StepInstant& now)
{
    switch (kind_) {
        case Kind::timeStep:
            return now.index % static_cast<std::int64_t>(interval_) == 0;
        case Kind::runTime:
            return passed(now.value + 0.5 * now.deltaT);
        case Kind::adjustableRunTime: {
            const Real miss = std::abs(now.value - std::round(now.value / interval_) * interval_);
            return miss < std::min(kSameTime * interval_,
                                   0.5 * now.deltaT);  // once, however small the step
        }
        case Kind::clockTime:
            return passed(wallSeconds() - origin_);
        case Kind::cpuTime:
            return passed(cpuSeconds() - origin_);
        case Kind::writeTime:
            return now.writeTime;
        case Kind::none:
            break;
    }
    return false;
}

Real TimeControl::nextTime(Real value) const
{
    if (kind_ != Kind::adjustableRunTime) return std::numeric_limits<Real>::infinity();
    return (std::floor(value / interval_ + kSameTime) + 1) * interval_;
}

}  // namespace isph
