// SPDX-License-Identifier: GPL-3.0-or-later
#include "PostProcess.hpp"

#include "FlowViews.hpp"
#include "case/Time.hpp"
#include "core/Log.hpp"
#include "functionObjects/FunctionObjectList.hpp"
#include "integrator/DragImplicitStep.hpp"

#include <algorithm>

namespace isph {

namespace {

/// Measures one state; the first one decides the folder of the results.
template <int Dim>
void measure(const CaseFiles& files, const TimeFolder& folder, FunctionObjectList& functions)
{
    const TimeState state = readTimeState(folder);
    info("Time = {}s\n", fmt::format("{:.10g}", state.value));
    if (!functions.dueAll({state.value, state.deltaT, state.index, true})) return;
    Scene<Dim> scene = readScene<Dim>(files, folder);
    Timers timers;
    DragImplicitStep<Dim> step(scene, timers);   // any: its look is that of all
    step.look();
    functions.execute(flowView(scene, step.fields(), state.value));
}

}  // namespace

template <int Dim>
int postProcess(const CaseFiles& files, const Dictionary& controlDict, const std::string& times)
{
    controlDictKeys().check(controlDict);
    std::vector<TimeFolder> folders = selectTimes(timeFolders(files.caseDir), times);
    std::sort(folders.begin(), folders.end(),
              [](const auto& a, const auto& b) { return a.value < b.value; });
    const TimeState first = readTimeState(folders.front());
    FunctionObjectList functions(controlDict, {files.caseDir, folders.front().name,
                                               {first.value, first.deltaT, first.index, true}});
    if (functions.empty())
        throw FatalIOError("There are no function objects: functions { } is empty or missing.",
                           (files.caseDir / "system" / "controlDict").string(), 0);
    for (const TimeFolder& folder : folders) measure<Dim>(files, folder, functions);
    info("End\n");
    return 0;
}

template int postProcess<2>(const CaseFiles&, const Dictionary&, const std::string&);
template int postProcess<3>(const CaseFiles&, const Dictionary&, const std::string&);

}  // namespace isph
