// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of time folders, made without a display.
#include "Frame.hpp"
#include "Picture.hpp"
#include "case/TimeList.hpp"
#include "core/Error.hpp"
#include "core/Log.hpp"
#include "selection/CommandLine.hpp"

#include <fmt/core.h>

#include <cmath>
#include <sstream>

namespace isph {
namespace {

CommandLine commandLine()
{
    CommandLine line("isphSnapshot",
                     "Draws the particles of time folders, coloured by a field, as PNG pictures.");
    line.option("time", "times", "times to draw: '0.35,0.75', ranges '0.5:1' (default: all)")
        .flag("latestTime", "draw the latest time")
        .option("field", "name",
                "field that colours the water: U (magnitude, default), U.x, p, porosity, ...")
        .option("range", "'low high'", "values of the colour bar's ends (default: of the data)")
        .option("width", "pixels", "width of the picture (default 1200)")
        .option("output", "file", "picture to write (default: postProcessing/snapshot/<field>.png)")
        .flag("montage", "all times in one picture, below each other")
        .option("columns", "n", "columns of the montage (default 1)")
        .option("region", "'x0 x1 y0 y1'", "part of the plane to draw [m] (default: all particles)")
        .option("title", "text", "line above the picture")
        .option("overlay", "file.csv",
                "measured profiles to draw: columns t, x, z; those of the time drawn")
        .option("overlayLabel", "text", "their name (default: measured)")
        .option("view", "axis",
                "3-D: axis to look along, x, y or z (default: that of the plane of gravity)")
        .option("slab", "'low high'", "3-D: part of that axis to draw [m]");
    return line;
}

/// The numbers of an option, exactly `count` of them.
std::vector<Real> numbers(const CommandLine& line, const std::string& option, std::size_t count)
{
    std::istringstream in(line.value(option));
    std::vector<Real> found;
    for (Real number; in >> number;) found.push_back(number);
    if (!in.eof() || found.size() != count)
        throw FatalError(
            fmt::format("-{} '{}': {} numbers are expected", option, line.value(option), count));
    return found;
}

/// An interval given by an option as two of its numbers.
Range interval(const CommandLine& line, const std::string& option, Real low, Real high)
{
    if (!(low < high))
        throw FatalError(
            fmt::format("-{} '{}': the lower value comes first", option, line.value(option)));
    return {low, high};
}

/// Looks along y where gravity points along z, else along z, so that up is up.
View defaultView(const std::filesystem::path& caseDir)
{
    const std::filesystem::path file = caseDir / "constant" / "g";
    if (!std::filesystem::exists(file)) return View::along("z");
    const Vector3 g = Dictionary::read(file).get<Vector3>("value", dims::acceleration);
    return View::along(std::abs(g[2]) > std::abs(g[1]) ? "y" : "z");
}

View viewOf(const CommandLine& line)
{
    View view = line.has("view") ? View::along(line.value("view")) : defaultView(line.caseDir());
    if (line.has("slab")) {
        const std::vector<Real> ends = numbers(line, "slab", 2);
        view.slab = interval(line, "slab", ends[0], ends[1]);
    }
    return view;
}

PictureStyle styleOf(const CommandLine& line, const View& view, const FieldChoice& field)
{
    PictureStyle style;
    style.width = static_cast<int>(line.number("width", 1200));
    if (style.width < 200 || style.width > 10000)
        throw FatalError("-width: 200 to 10000 pixels are possible");
    style.columns = static_cast<int>(line.number("columns", 1));
    if (style.columns < 1 || style.columns > 10) throw FatalError("-columns: 1 to 10 are possible");
    if (style.columns > 1 && !line.has("montage")) throw FatalError("-columns belongs to -montage");
    style.title = line.value("title");
    style.fieldLabel = field.label();
    const std::vector<std::string> axes = {"x", "y", "z"};
    style.right = axes[static_cast<std::size_t>(view.right)];
    style.up = axes[static_cast<std::size_t>(view.up)];
    if (line.has("overlay"))
        style.overlay = Overlay(line.value("overlay"));
    else if (line.has("overlayLabel"))
        throw FatalError("-overlayLabel belongs to -overlay");
    style.overlayLabel = line.value("overlayLabel", style.overlayLabel);
    return style;
}

/// Region and range of the colours that all pictures share, from the frames or the command line.
void fitTo(const std::vector<Frame>& frames, const CommandLine& line, PictureStyle& style)
{
    if (line.has("region")) {
        const std::vector<Real> ends = numbers(line, "region", 4);
        const Range x = interval(line, "region", ends[0], ends[1]),
                    y = interval(line, "region", ends[2], ends[3]);
        style.region = {{{x.low, y.low}}, {{x.high, y.high}}};
    } else {
        style.region = regionOf(frames);
    }
    if (line.has("range")) {
        const std::vector<Real> ends = numbers(line, "range", 2);
        style.range = interval(line, "range", ends[0], ends[1]);
        return;
    }
    style.range = frames.front().fieldRange;
    for (const Frame& frame : frames) {
        style.range.low = std::min(style.range.low, frame.fieldRange.low);
        style.range.high = std::max(style.range.high, frame.fieldRange.high);
    }
}

std::filesystem::path outputFile(const CommandLine& line)
{
    if (line.has("output")) return line.value("output");
    return line.caseDir() / "postProcessing" / "snapshot" / (line.value("field", "U") + ".png");
}

void paint(const std::vector<Frame>& frames, const PictureStyle& style,
           const std::filesystem::path& file)
{
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    paintPicture(frames, style, file);
    info("Writing {}", file.string());
}

int run(int argc, char** argv)
{
    CommandLine line = commandLine();
    if (const auto exitCode = line.parse(argc, argv)) return *exitCode;
    const FieldChoice field(line.value("field", "U"));
    const View view = viewOf(line);
    PictureStyle style = styleOf(line, view, field);
    if (line.has("latestTime") && line.has("time"))
        throw FatalError("give -time or -latestTime, not both");
    const std::string selection = line.has("latestTime") ? "latestTime" : line.value("time", ":");

    std::vector<Frame> frames;
    std::vector<std::string> names;
    for (const TimeFolder& folder : selectTimes(timeFolders(line.caseDir()), selection)) {
        frames.push_back(readFrame(folder, field, view));
        names.push_back(folder.name);
    }
    fitTo(frames, line, style);
    const std::filesystem::path file = outputFile(line);
    if (line.has("montage") || frames.size() == 1) {
        paint(frames, style, file);
        return 0;
    }
    for (std::size_t f = 0; f < frames.size(); ++f)
        paint({frames[f]}, style,
              file.parent_path() /
                  (file.stem().string() + "_" + names[f] + file.extension().string()));
    return 0;
}

}  // namespace
}  // namespace isph

int main(int argc, char** argv)
{
    try {
        return isph::run(argc, argv);
    } catch (const std::exception& error) {
        return isph::reportFatal(error);
    }
}
