// SPDX-License-Identifier: GPL-3.0-or-later
// Free-surface flow, seepage and scour by incompressible SPH.
#include "PostProcess.hpp"
#include "Run.hpp"

#include "case/StopSignal.hpp"
#include "core/Log.hpp"
#include "erosion/ErosionModel.hpp"
#include "functionObjects/FunctionObject.hpp"
#include "selection/CommandLine.hpp"

namespace {

using namespace isph;

/// -listKernels and its like: prints the names of a family. True if one was asked for.
bool listModels(const CommandLine& line)
{
    bool listed = false;
    const auto list = [&](const char* option, const auto& names) {
        if (!line.has(option)) return;
        writeInfo(listOf(names()));
        listed = true;
    };
    list("listKernels", [] { return Kernel::table().names(); });
    list("listPorousModels", [] { return PorousModel::table().names(); });
    list("listErosionModels", [] { return ErosionModel::table().names(); });
    list("listTurbulenceModels", [] { return TurbulenceModel::table().names(); });
    list("listPressureSolvers", [] { return PressureSolver::table().names(); });
    list("listFunctionObjects", [] { return FunctionObject::table().names(); });
    return listed;
}

void requirePostProcess(const CommandLine& line)
{
    for (const char* option : {"time", "latestTime"})
        if (line.has(option) && !line.has("postProcess"))
            throw FatalError(fmt::format(
                "The option -{} belongs to -postProcess; a run starts where startFrom in "
                "system/controlDict says.",
                option));
    if (line.has("time") && line.has("latestTime"))
        throw FatalError("Give -time or -latestTime, not both.");
}

void loadCaseLibraries(const Dictionary& controlDict)
{
    if (!controlDict.found("libs")) return;
    for (const std::string& name : controlDict.get<std::vector<std::string>>("libs"))
        loadLibrary(name);
}

int run(int argc, char** argv)
{
    CommandLine line("isphPorousFoam",
                     "Free-surface flow, seepage and scour by incompressible SPH.");
    line.flag("dryRun", "read and check everything, print what is active and left out, and end");
    line.flag("postProcess",
              "run the function objects over the time folders that are there, and end");
    line.option("time", "times",
                "times of -postProcess: '0.35,0.75', ranges '0.5:1' (default: all)");
    line.flag("latestTime", "of -postProcess: only the latest time");
    for (const char* family : {"Kernels", "PorousModels", "ErosionModels", "TurbulenceModels",
                               "PressureSolvers", "FunctionObjects"})
        line.flag(std::string("list") + family, "print the names that may be chosen");
    if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
    if (listModels(line)) return 0;
    requirePostProcess(line);
    line.printBanner();
    info("Create time\n");
    catchStopSignals();
    const Dictionary controlDict = Dictionary::read(line.caseDir() / "system" / "controlDict");
    loadCaseLibraries(controlDict);
    const CaseFiles files(line.caseDir());
    if (line.has("postProcess")) {
        const std::string times = line.has("latestTime") ? "latestTime" : line.value("time", ":");
        return files.dimension() == 2 ? postProcess<2>(files, controlDict, times)
                                      : postProcess<3>(files, controlDict, times);
    }
    const RunOptions options{line.functionObjects(), line.has("dryRun")};
    return files.dimension() == 2 ? runCase<2>(files, controlDict, options)
                                  : runCase<3>(files, controlDict, options);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        return isph::reportFatal(error);
    }
}
