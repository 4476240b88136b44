// SPDX-License-Identifier: GPL-3.0-or-later
// The function objects of a run: controlDict's functions { }, when they are due, and their files.
#pragma once
#include "case/Time.hpp"
#include "functionObjects/DataFile.hpp"
#include "functionObjects/FunctionObject.hpp"

#include <memory>
#include <optional>

namespace isph {

/// Where and when this program began to measure.
struct MeasureStart {
    std::filesystem::path caseDir;
    std::string timeName;  ///< of the folder under postProcessing/<name>: "0", "0.35"
    StepInstant instant;   ///< index > 0: a restart
};

/// In the solver:
///     FunctionObjectList functions(time.controlDict(), {time.caseDir(), time.name(),
///     time.instant()}); functions.meet(time);
/// and before the first step and after every step
///     if (functions.due(time.instant())) functions.execute(makeFlowView(...));
/// and after the last one so with dueAtEnd().
/// The initial state (index 0) is due for every control but none. The first state of a restart is
/// not: the run that wrote it has measured it. From there on the measurements have the times that
/// the uninterrupted run would give them, the wall-clock controls excepted.
class FunctionObjectList {
public:
    /// Measures nothing (-noFunctionObjects).
    FunctionObjectList() = default;
    /// Throws FatalIOError or FatalError for unknown types, unknown or wrong keys, missing
    /// libraries.
    FunctionObjectList(const Dictionary& controlDict, const MeasureStart& start);

    /// controlDict was edited while the program runs: function objects whose dictionary is
    /// unchanged go on as they are, the others begin anew at `start`. Where it throws, everything
    /// stays as it was.
    void reread(const Dictionary& controlDict, const MeasureStart& start);
    /// Asks for steps that end at the times of those with adjustableRunTime. Without it they
    /// measure only where a step happens to end at such a time. Again after reread().
    void meet(Time& time);

    bool empty() const { return entries_.empty(); }
    std::vector<std::string> names() const;

    /// Whether any function object needs to see the flow now. To be asked once a step, in every
    /// step.
    bool due(const StepInstant& now);
    /// The same after the last step of a run: those that measure at its end and have not done so.
    bool dueAtEnd(const StepInstant& now);
    /// Every enabled one that is not past its endTime or before its startTime, whatever its
    /// controls: of a state that was written, measured afterwards.
    bool dueAll(const StepInstant& now);
    /// Measures and writes what the last due() or dueAtEnd() found.
    void execute(const FlowView& flow);

private:
    struct Entry {
        std::string name, type;
        std::string text;  ///< its dictionary, to see whether it was edited
        std::unique_ptr<FunctionObject> object;
        TimeControl writing, executing;
        Real startTime = 0, endTime = 0;
        bool enabled = true, log = false;
        MeasureStart start;
        bool met = false;                 ///< known to Time
        bool write = false, run = false;  ///< found by due()
        int written = -1;                 ///< index of the step of the last row
        std::optional<DataWriter> file{};

        void ask(const StepInstant& now);
        bool inside(const StepInstant& now) const;  ///< between startTime and endTime
    };
    static Entry makeEntry(const Dictionary& dict, const MeasureStart& start);
    static void resume(Entry& entry);
    static void openFile(Entry& entry);

    std::vector<Entry> entries_;
    Real time_ = 0;
    int index_ = 0;  ///< of the step that due() was asked about
};

}  // namespace isph
