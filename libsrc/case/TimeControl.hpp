// SPDX-License-Identifier: GPL-3.0-or-later
// When something recurs: OpenFOAM's writeControl and executeControl.
#pragma once
#include "core/Types.hpp"
#include "dictionary/Dictionary.hpp"

#include <string>
#include <vector>

namespace isph {

/// What a control decides by, after a step.
struct StepInstant {
    Real value = 0;          ///< time [s]
    Real deltaT = 0;         ///< the step that led there [s]
    int index = 0;           ///< steps since the case began
    bool writeTime = false;  ///< time folders are written now
};

/// Every n-th step or every `interval` seconds, at multiples that do not depend on the start time:
///   timeStep           index = n interval
///   runTime            the first step past value = n interval (as OpenFOAM: past it by dt/2 at
///   most) adjustableRunTime  value = n interval; Time fits its steps so that they meet it
///   clockTime, cpuTime seconds of wall or processor time since the control was made
///   writeTime          whenever time folders are written;  none  never
class TimeControl {
public:
    enum class Kind { timeStep, runTime, adjustableRunTime, clockTime, cpuTime, writeTime, none };

    /// Reads <prefix>Control and <prefix>Interval ("write", "execute"); `otherwise` where the
    /// control is absent. Throws FatalIOError: unknown control, interval missing, not positive or,
    /// with timeStep, no whole number.
    static TimeControl read(const Dictionary& dict, const std::string& prefix,
                            Kind otherwise = Kind::timeStep, Real otherwiseInterval = 0);
    static std::vector<std::string> kindNames();

    TimeControl() = default;  ///< none
    TimeControl(Kind kind, Real interval);

    Kind kind() const { return kind_; }
    Real interval() const { return interval_; }

    /// The times before and at a start are done: they are not due again.
    void startAt(const StepInstant& start);
    /// True if the step that led here is one of the control's. Ask once a step.
    bool due(const StepInstant& now);
    /// The first multiple of the interval after `value` for adjustableRunTime, else infinity.
    Real nextTime(Real value) const;

private:
    Kind kind_ = Kind::none;
    Real interval_ = 0;
    Real origin_ = 0;        ///< wall or processor seconds when the control was made
    std::int64_t done_ = 0;  ///< multiples of the interval that lie behind

    bool passed(Real amount);
};

}  // namespace isph
