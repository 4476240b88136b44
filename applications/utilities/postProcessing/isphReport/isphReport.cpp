// SPDX-License-Identifier: GPL-3.0-or-later
// isphReport: error against run time, and where a case is stable, over variants of it.
#include "Plots.hpp"
#include "Process.hpp"
#include "Runner.hpp"

#include "case/StopSignal.hpp"
#include "core/Error.hpp"
#include "core/Log.hpp"
#include "selection/CommandLine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

using namespace isph;
namespace fs = std::filesystem;

namespace {

constexpr const char* kDescription =
    "Runs variants of a case, as system/reportDict asks for, each in report/<variant>, and writes\n"
    "report/report.csv, report/report.md and plots (SVG, PNG) of error against wall time, error\n"
    "against spacing, and for two keys a map of stability. Finished variants are not run again, "
    "so\n"
    "a report that was stopped goes on where it was. docs/report.md tells the keys of reportDict.";

void writeText(const fs::path& file, const std::string& text)
{
    std::ofstream out(file);
    out << text << std::flush;
    if (!out) throw FatalError(fmt::format("Cannot write {}", file.string()));
}

int list(const std::vector<VariantCase>& all)
{
    for (const VariantCase& one : all)
        info("{:<10} {}", one.finished() ? "finished" : "to run", one.variant().name);
    return 0;
}

void summarise(const std::vector<Result>& results)
{
    std::size_t unstable = 0;
    for (const Result& result : results) {
        if (result.outcome.state == Outcome::State::stable) continue;
        ++unstable;
        info("{}: {}, {}", result.variant->name,
             result.outcome.state == Outcome::State::unstable ? "unstable"
                                                              : describe(result.outcome.state),
             result.outcome.why);
    }
    info("{} variants, {} of them stable", results.size(), results.size() - unstable);
}

int makeReport(const CommandLine& line)
{
    const Report report = readReport(line.caseDir());
    const std::vector<Variant> variants = variantsOf(report);
    std::vector<VariantCase> cases;
    for (const Variant& variant : variants) cases.emplace_back(report, variant, line.caseDir());
    if (line.has("list")) return list(cases);
    const fs::path folder = line.caseDir() / "report";
    fs::create_directories(folder);
    catchStopSignals();
    if (!runVariants(cases, report.parallel, line.has("again"))) {
        info("Stopped by signal {}; started again, the report goes on from there", stopSignal());
        return 128 + stopSignal();
    }
    std::vector<Result> results;
    for (std::size_t k = 0; k < cases.size(); ++k)
        results.push_back({&variants[k], cases[k].outcome()});
    writeText(folder / "report.csv", csvTable(report, results));
    writeText(folder / "report.md", markdownTable(report, results));
    summarise(results);
    info("{}", (folder / "report.md").string());
    for (const std::string& plot : makePlots(report, results, folder))
        info("{}", (folder / (plot + ".svg")).string());
    const bool anyRan = std::any_of(results.begin(), results.end(), [](const Result& result) {
        return result.outcome.state != Outcome::State::notRun;
    });
    if (!anyRan) throw FatalError("No variant could be run: " + results.front().outcome.why);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        CommandLine line("isphReport", kDescription);
        line.flag("list", "lists the variants and whether they are finished, and ends")
            .flag("again", "runs finished variants again");
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
        findOwnPrograms();
        return makeReport(line);
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
