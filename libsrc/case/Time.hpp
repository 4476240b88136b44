// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a run in time, as system/controlDict sets it.
#pragma once
#include "case/TimeControl.hpp"
#include "case/TimeList.hpp"
#include "dictionary/Schema.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

/// The keys of system/controlDict; functions is open, its entries are checked by their family.
Schema controlDictKeys();

enum class TimeFormat { general, fixed, scientific };
/// A time folder's name: "0.05", "0.050000", "5.000000e-02".
std::string timeName(Real value, TimeFormat format, int precision);

/// Time, step and the end of a run. The loop of a solver:
///   while (time.run()) {
///       time.setDeltaT(wanted);        // only with adjustTimeStep
///       time.advance();
///       ...step of size time.deltaT()...
///       if (time.writeTime()) write;
///   }
/// With writeControl adjustableRunTime the wanted step is spread evenly over what is left to the
/// next write time, N = floor(max(r, 1) + 0.99) steps for r wanted ones, so that it grows by 1 % at
/// most and no sliver remains, and the last of them ends at exactly n*writeInterval. All of this
/// follows from value, index and deltaT alone, so a restart from a written time takes the same
/// steps bit for bit.
class Time {
public:
    /// start: of readTimeState. Checks the dictionary. Throws FatalIOError.
    Time(const Dictionary& controlDict, const std::filesystem::path& caseDir,
         const TimeState& start);

    Real value() const { return value_; }  ///< [s]
    int index() const { return index_; }   ///< steps since the case began
    /// Last step, or the next one once setDeltaT chose it [s]
    Real deltaT() const
    {
        return deltaT_;
    }
    /// The step before deltaT(), 0 if there was none [s]
    Real deltaT0() const
    {
        return deltaT0_;
    }
    Real startValue() const { return startValue_; }
    Real endTime() const { return endTime_; }
    std::string name() const;  ///< of the time folder
    TimeState state() const;

    /// False at the end: endTime reached (within half a step), stopAt, or a stop signal was served.
    /// Re-reads controlDict if it changed and runTimeModifiable is on; a file with errors is warned
    /// of and the old settings stay.
    bool run();
    /// The size of the next step, fitted to the times to be met exactly. Throws FatalError unless >
    /// 0.
    void setDeltaT(Real wanted);
    /// One step on; of controlDict's deltaT, fitted, where setDeltaT was not called.
    void advance();
    /// Time folders are to be written after this step.
    bool writeTime() const { return writeTime_; }

    /// Steps shall also end at the multiples of this interval (function objects). [s]
    void alsoMeet(const TimeControl& control);
    /// For TimeControl::due after a step.
    StepInstant instant() const { return {value_, deltaT_, index_, writeTime_}; }

    /// deltaT of controlDict: every step, or with adjustTimeStep the first. [s]
    Real controlDeltaT() const { return fixedDeltaT_; }
    bool adjustTimeStep() const { return adjustTimeStep_; }
    Real maxCo() const { return maxCo_; }
    Real maxDeltaT() const { return maxDeltaT_; }  ///< [s], infinity where it is absent
    int purgeWrite() const { return purgeWrite_; }
    const Dictionary& controlDict() const { return controlDict_; }
    /// How often run() has read controlDict again with success: function objects then follow it.
    int rereads() const { return rereads_; }
    const std::filesystem::path& caseDir() const { return caseDir_; }

    Real progress() const;  ///< share of endTime that is done [%]
    /// Wall time left by the pace of this run so far, 0 before the first step
    Real secondsLeft() const;
    /// 128 + signal after a stop signal, else 0.
    int exitCode() const;

private:
    enum class StopAt { endTime, noWriteNow, writeNow, nextWrite };

    void readControls();
    void requireWayToGo() const;
    void rereadIfModified();
    void fitStep(Real wanted);

    Dictionary controlDict_;
    std::filesystem::path caseDir_;
    std::filesystem::file_time_type modified_{};

    Real value_, startValue_;
    int index_;
    Real deltaT_, deltaT0_;
    Real target_ = 0;  ///< where the fitted step ends; NaN: at value + deltaT
    bool stepIsSet_ = false;
    bool writeTime_ = false;
    bool stopped_ = false;
    int rereads_ = 0;

    StopAt stopAt_ = StopAt::endTime;
    Real endTime_ = 0, fixedDeltaT_ = 0, maxCo_ = 0, maxDeltaT_ = 0;
    bool adjustTimeStep_ = false, modifiable_ = true;
    int purgeWrite_ = 0, precision_ = 6;
    TimeFormat format_ = TimeFormat::general;
    TimeControl writeControl_;
    std::vector<TimeControl> alsoMet_;
    double wallStart_;
};

}  // namespace isph
