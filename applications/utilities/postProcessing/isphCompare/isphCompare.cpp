// SPDX-License-Identifier: GPL-3.0-or-later
// isphCompare: one line that says whether a measured quantity lies within its bound.
#include "Comparison.hpp"

#include "core/Error.hpp"
#include "core/Log.hpp"
#include "selection/CommandLine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace isph;

namespace {

constexpr const char* kDescription =
    "Compares what function objects measured with a number or with reference data, prints\n"
    "    <quantity> <value> <unit> bound <bound> ok|FAIL\n"
    "and ends with exit code 1 at FAIL. Examples, from the folder of a case:\n"
    "  free surface against an experiment, all points pooled\n"
    "    isphCompare -name surface -unit m -bound 0.012 -profile postProcessing/gauge\n"
    "        -reference reference/surface.csv -times '0.35 0.75' -measure rms\n"
    "  front of a dam break against t,x of an experiment\n"
    "    isphCompare -name front -unit m -bound 0.02 -profile postProcessing/gauge -front 0.005\n"
    "        -reference reference/front.csv -measure max\n"
    "  hydrostatic pressure, in per cent of what it should be, from 1 s on\n"
    "    isphCompare -name pressure -bound 1 -series postProcessing/probes -column p_0 -from 1\n"
    "        -expect 1962 -relative\n"
    "  largest speed; discharge against its exact value; volume against the particles' in per "
    "cent\n"
    "    isphCompare -name maxU -unit m/s -bound 0.02 -series postProcessing/energy -column "
    "maxSpeed\n"
    "    isphCompare -name discharge -bound 2 -series postProcessing/probes -column 'UDarcy_y_*'\n"
    "        -from 5 -measure mean -expect 0.0139 -relative\n"
    "    isphCompare -name volume -unit % -bound 2 -series postProcessing/volume -column "
    "difference\n"
    "        -scale 100\n"
    "  a gauge, averaged over 5 ms, at most 20 % of the time outside a measured band t,p,low,high\n"
    "    isphCompare -name gauge -unit % -bound 20 -series postProcessing/gauge -column p_0\n"
    "        -average 0.005 -reference reference/gauge.csv -band -measure outside\n"
    "  a number that a script found\n"
    "    isphCompare -name solids -unit kg -bound 1e-9 -value $mass -expect 12.5";

void declare(CommandLine& line)
{
    line.option("name", "quantity", "first word of the line that is printed")
        .option("bound", "number", "largest value that is ok")
        .option("unit", "unit", "of value and bound; - where absent, % with -relative")
        .option("value", "number", "the measured value itself")
        .option("series", "path",
                "file of a function object, or postProcessing/<name> for all starts of a run")
        .option("column", "names", "columns of the series, pooled; * and ? stand for any letters")
        .option("profile", "path", "file or folder of a waterLevel along a line")
        .option("along", "x|y|z", "coordinate of the profile's points; x where absent")
        .option("front", "level",
                "takes from a profile the largest coordinate where it stands above this level")
        .option("times", "'t1 t2 ...'", "compares at these times, between rows linearly")
        .option("from", "time", "leaves out earlier rows (or points of a series' reference)")
        .option("to", "time", "leaves out later ones")
        .option("expect", "number", "what is subtracted; 0 where absent")
        .option("reference", "csv",
                "what is subtracted: t,value of a series; t,x,value of a profile")
        .option(
            "delay", "most",
            "a series' reference may have begun later than the run, by up to this time [s]: the "
            "delay that fits best counts and is printed")
        .option("average", "width", "takes the moving average of a series over this time [s]")
        .flag("band",
              "the reference of a series is t,value,low,high, and nothing is subtracted but what "
              "lies beyond")
        .option(
            "measure", "name",
            "last, mean, max (where absent), min or rms of the deviations, range of the values, or "
            "outside: the share of those that deviate [%]")
        .option("scale", "factor", "multiplies measured and expected values")
        .flag("relative", "in per cent of what is expected, the largest of a reference");
}

std::vector<Real> numbers(const std::string& option, const std::string& text)
{
    std::vector<Real> all;
    std::istringstream in(text);
    for (Real value; in >> value;) all.push_back(value);
    if (!in.eof() || all.empty())
        throw FatalError("-" + option + " '" + text + "' is no list of numbers");
    return all;
}

/// What the command line asks for makes sense as a whole.
void checkCombination(const CommandLine& line)
{
    for (const char* needed : {"name", "bound"})
        if (!line.has(needed)) throw FatalError(fmt::format("-{} is missing", needed));
    if (line.has("value") + line.has("series") + line.has("profile") != 1)
        throw FatalError("exactly one of -value, -series and -profile must be given");
    const auto only = [&](const char* option, bool allowed, const char* where) {
        if (line.has(option) && !allowed) throw FatalError(fmt::format("-{} {}", option, where));
    };
    const bool series = line.has("series") || line.has("front");
    only("column", line.has("series"), "belongs to -series");
    only("front", line.has("profile"), "belongs to -profile");
    only("along", line.has("profile"), "belongs to -profile");
    only("times", !line.has("value") && !(series && line.has("reference")),
         "does not go with -value, nor with a series' -reference, which has its own times");
    only("from", series && !line.has("times"), "belongs to a series without -times");
    only("to", series && !line.has("times"), "belongs to a series without -times");
    only("reference", !line.has("value"), "does not go with -value");
    only("delay", series && line.has("reference"), "belongs to a series' -reference");
    only("band", series && line.has("reference"), "belongs to a series' -reference");
    only("average", line.has("series"), "belongs to -series");
    if (line.has("average") && !(line.number("average", 0) > 0))
        throw FatalError("-average needs a time above 0 s");
    only("expect", !line.has("reference"), "does not go with -reference");
    if (line.has("series") && !line.has("column")) throw FatalError("-series needs -column");
    if (line.has("profile") && !series && !line.has("reference"))
        throw FatalError("-profile needs -reference, or -front");
    const std::vector<std::string> names = measureNames();
    const std::string name = line.value("measure", "max");
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw FatalError(
            fmt::format("Unknown measure {}\n\nValid measures are:\n\n{}", name, listOf(names)));
}

Source sourceOf(const CommandLine& line)
{
    const Real infinity = std::numeric_limits<Real>::infinity();
    Source source;
    const auto path = [&](const char* option) {
        return line.has(option) ? line.caseDir() / line.value(option) : std::filesystem::path();
    };
    source.series = path("series");
    source.profile = path("profile");
    source.columns = line.value("column");
    source.along = line.value("along", "x");
    if (line.has("value")) source.value = line.number("value", 0);
    if (line.has("front")) source.front = line.number("front", 0);
    if (line.has("times")) source.times = numbers("times", line.value("times"));
    source.from = line.number("from", -infinity);
    source.to = line.number("to", infinity);
    source.average = line.number("average", 0);
    return source;
}

int compare(const CommandLine& line)
{
    checkCombination(line);
    Expectation expectation{line.number("expect", 0), {}, line.has("band")};
    if (line.has("reference")) expectation.reference = line.caseDir() / line.value("reference");
    const Real scale = line.number("scale", 1);
    const auto deviation = [&](Real delay) {
        Source source = sourceOf(line);
        source.delay = delay;
        std::vector<Sample> all = samples(source, expectation);
        for (Sample& s : all) s = {s.time, scale * s.measured, scale * s.expected};
        if (line.has("relative")) all = inPerCent(std::move(all));
        return measure(line.value("measure", "max"), all);
    };
    Real value = deviation(0);
    std::string name = line.value("name");
    if (line.has("delay")) {
        constexpr int steps = 40;
        const Real most = line.number("delay", 0);
        Real best = 0;
        for (int k = 1; k <= steps; ++k)
            if (const Real later = deviation(most * k / steps); later < value)
                value = later, best = most * k / steps;
        name += fmt::format("(delay={:.3g}s)", best);
    }
    const Real bound = line.number("bound", 0);
    const bool ok = value <= bound;  // false for a value that is no number
    info("{} {:.4g} {} bound {:g} {}", name, value,
         line.value("unit", line.has("relative") ? "%" : "-"), bound, ok ? "ok" : "FAIL");
    return ok ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        CommandLine line("isphCompare", kDescription);
        declare(line);
        if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
        return compare(line);
    } catch (const std::exception& error) {
        return reportFatal(error);
    }
}
