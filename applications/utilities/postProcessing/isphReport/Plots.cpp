// SPDX-License-Identifier: GPL-3.0-or-later
#include "Plots.hpp"

#include "Process.hpp"
#include "core/Error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace isph {

namespace fs = std::filesystem;

namespace {

struct Dot {
    Real x, y;
};
struct Curve {
    std::string name;
    std::vector<Dot> dots;
};

/// Text between single quotes of gnuplot, without the marks of its enhanced mode.
std::string plain(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', ' ');
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string fileName(std::string text)
{
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return text;
}

/// Least squares of ln y over ln x; none for fewer than two places.
std::optional<Real> slope(const std::vector<Dot>& dots)
{
    Real n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Dot& dot : dots) {
        const Real x = std::log(dot.x), y = std::log(dot.y);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const Real spread = n * sxx - sx * sx;
    if (n < 2 || !(spread > 1e-12 * n * sxx)) return std::nullopt;
    return (n * sxy - sx * sy) / spread;
}

template <class Abscissa>
std::vector<Curve> curves(const std::vector<Line>& all, const std::string& error, Abscissa&& x)
{
    std::vector<Curve> drawn;
    for (const Line& line : all) {
        Curve curve{line.name, {}};
        for (const Result* point : line.points) {
            const auto it = point->outcome.errors.find(error);
            const std::optional<Real> at = x(*point);
            if (it != point->outcome.errors.end() && it->second > 0 && at && *at > 0)
                curve.dots.push_back({*at, it->second});
        }
        std::sort(curve.dots.begin(), curve.dots.end(),
                  [](const Dot& a, const Dot& b) { return a.x < b.x; });
        if (!curve.dots.empty()) drawn.push_back(curve);
    }
    return drawn;
}

/// Both terminals; the plot itself stands in `plot`, which ends with its data blocks known.
std::string script(const std::string& name, const std::string& data, const std::string& plot)
{
    std::string text = data;
    for (const char* terminal :
         {"svg size 800,600 dynamic enhanced background rgb 'white' font 'sans,14'",
          "pngcairo size 1200,900 enhanced font 'sans,18'"}) {
        const char* ending = terminal[0] == 's' ? "svg" : "png";
        text +=
            fmt::format("set terminal {}\nset output '{}.{}'\n{}", terminal, name, ending, plot);
    }
    return text + "set output\n";
}

void draw(const fs::path& folder, const std::string& name, const std::string& text)
{
    const fs::path file = folder / (name + ".gnuplot");
    std::ofstream(file) << text;
    const fs::path log = folder / (name + ".gnuplot.log");
    const ProcessEnd end =
        runCommand({fmt::format("gnuplot '{}'", file.filename().string()), folder, log, 1, {}});
    if (!end.succeeded())
        throw FatalError(
            fmt::format("gnuplot could not draw {} (exit code {}): is it installed? See "
                        "{}\nThe tables are written.",
                        file.string(), end.code, log.string()));
    fs::remove(log);
}

std::string blocks(const std::vector<Curve>& all)
{
    std::string text;
    for (std::size_t k = 0; k < all.size(); ++k) {
        text += fmt::format("$line{} << EOD\n", k);
        for (const Dot& dot : all[k].dots) text += fmt::format("{:.10g} {:.10g}\n", dot.x, dot.y);
        text += "EOD\n";
    }
    return text;
}

struct Axis {
    std::string label;
    bool slopes = false;  ///< fitted ones in the key, and lines of slope 1 and 2
};

/// Lines of slope 1 and 2 through a third of the lowest point at the right.
std::string guides(const std::vector<Curve>& all)
{
    Real right = 0, low = 0;
    for (const Curve& curve : all)
        for (const Dot& dot : curve.dots) {
            right = std::max(right, dot.x);
            if (low == 0 || dot.y < low) low = dot.y;
        }
    Real left = right;
    for (const Curve& curve : all) left = std::min(left, curve.dots.front().x);
    if (!(right > left)) return "";
    std::string text;
    for (const int order : {1, 2})
        text += fmt::format(
            ", [{:.10g}:{:.10g}] {:.10g}*(x/{:.10g})**{} dashtype {} linecolor "
            "'gray' title 'slope {}'",
            left, right, 0.7 * low, left, order, order + 1, order);
    return text;
}

/// Axes a little longer than the points need; gnuplot's own end at whole decades.
std::string ranges(const std::vector<Curve>& all)
{
    constexpr Real margin = 1.5;
    Dot low = all.front().dots.front(), high = low;
    for (const Curve& curve : all)
        for (const Dot& dot : curve.dots) {
            low = {std::min(low.x, dot.x), std::min(low.y, dot.y)};
            high = {std::max(high.x, dot.x), std::max(high.y, dot.y)};
        }
    return fmt::format("set xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n",
                       low.x / margin, high.x * margin, low.y / margin / margin, high.y * margin);
}

/// A mark at each place of the points.
std::string tics(const std::vector<Curve>& all)
{
    std::set<Real> places;
    for (const Curve& curve : all)
        for (const Dot& dot : curve.dots) places.insert(dot.x);
    return fmt::format("set xtics ({:g})\n", fmt::join(places, ", "));
}

void drawLines(const fs::path& folder, const std::string& name, const std::vector<Curve>& all,
               const Axis& x, const std::string& error)
{
    std::string plot = fmt::format(
        "set logscale xy\nset format x '%g'\nset format y '%g'\nset grid\nset key outside bottom "
        "center horizontal noenhanced\nset xlabel '{}' noenhanced\nset ylabel '{}' noenhanced\n"
        "{}plot ",
        plain(x.label), plain(error), ranges(all));
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::string title = all[k].name;
        const std::optional<Real> fitted = x.slopes ? slope(all[k].dots) : std::nullopt;
        if (fitted) title += fmt::format(" (slope {:.2f})", *fitted);
        plot +=
            fmt::format("{}$line{} using 1:2 with linespoints pointsize 1.2 linewidth 2 title '{}'",
                        k ? ", " : "", k, plain(title));
    }
    if (x.slopes) plot = tics(all) + plot + guides(all);
    draw(folder, name, script(name, blocks(all), plot + "\n"));
}

/// Index of a variant's value on the axis of a key.
int place(const VariedKey& key, const Variant& variant)
{
    for (const Setting& setting : variant.settings)
        if (setting.key == &key)
            for (std::size_t k = 0; k < key.values.size(); ++k)
                if (key.values[k].text == setting.value.text) return static_cast<int>(k);
    return -1;
}

std::string tics(const VariedKey& key)
{
    std::string text;
    for (std::size_t k = 0; k < key.values.size(); ++k)
        text += fmt::format("{}'{}' {}", k ? ", " : "", plain(key.values[k].label), k);
    return text;
}

constexpr std::size_t kRoomyColumns = 7;

void drawMap(const Report& report, const std::vector<Result>& results, const std::string& error,
             const fs::path& folder, const std::string& name)
{
    const VariedKey &first = report.keys[0], &second = report.keys[1];
    std::string good = "$good << EOD\n", plainGood = "$unknown << EOD\n", bad = "$bad << EOD\n";
    int counts[3] = {0, 0, 0};
    for (const Result& result : results) {
        const auto it = result.outcome.errors.find(error);
        const bool stable = result.outcome.state == Outcome::State::stable;
        const bool known = stable && it != result.outcome.errors.end() && it->second > 0;
        const std::string at =
            fmt::format("{} {}", place(first, *result.variant), place(second, *result.variant));
        ++counts[known ? 0 : stable ? 1 : 2];
        if (known) good += fmt::format("{} {:.10g}\n", at, it->second);
        (known ? good : stable ? plainGood : bad) += known ? "" : at + "\n";
    }
    std::string plot = fmt::format(
        "set xrange [-0.5:{}.5]\nset yrange [-0.5:{}.5]\nset xtics ({}) noenhanced\nset ytics ({}) "
        "noenhanced\nset xlabel '{}' noenhanced\nset ylabel '{}' noenhanced\nset logscale cb\nset "
        "format cb '%g'\nset cblabel '{}' noenhanced\nset palette defined (0 '#2166ac', 1 "
        "'#67a9cf', 2 "
        "'#fddbc7', 3 '#b2182b')\nset key outside top center horizontal\nplot ",
        first.values.size() - 1, second.values.size() - 1, tics(first), tics(second),
        plain(first.name), plain(second.name), plain(error));
    std::vector<std::string> parts;
    if (counts[0]) {
        parts.push_back("$good using 1:2:3 with points pt 5 ps 4 lc palette title 'stable'");
        const bool crowded =
            first.values.size() > kRoomyColumns;  // texts would run into one another
        parts.push_back(
            fmt::format("$good using 1:2:(sprintf('{}', $3)) with labels offset 0,1.7{} notitle",
                        crowded ? "%.1e" : "%.3g", crowded ? " font ',8'" : ""));
    }
    if (counts[1])
        parts.push_back(
            "$unknown using 1:2 with points pt 4 ps 4 lc 'black' title 'stable, no error'");
    if (counts[2])
        parts.push_back("$bad using 1:2 with points pt 2 ps 3 lw 3 lc 'black' title 'unstable'");
    plot += fmt::format("{}\n", fmt::join(parts, ", "));
    draw(folder, name, script(name, good + "EOD\n" + plainGood + "EOD\n" + bad + "EOD\n", plot));
}

}  // namespace

std::vector<std::string> makePlots(const Report& report, const std::vector<Result>& results,
                                   const fs::path& folder)
{
    std::vector<std::string> names;
    const std::vector<Line> all = lines(report, results);
    const VariedKey* along = report.alongKey();
    std::vector<std::string> errors = errorNames(results);
    for (const std::string& error : errors) {
        const auto byTime = curves(all, error, [](const Result& point) {
            return std::optional<Real>(point.outcome.wall);
        });
        if (byTime.empty()) continue;  // nothing above zero
        names.push_back(fileName(error) + "-wallTime");
        drawLines(folder, names.back(), byTime, {"wall time [s]"}, error);
        if (!along || !along->numeric()) continue;
        const auto byKey =
            curves(all, error, [&](const Result& point) { return point.variant->along(report); });
        if (byKey.empty()) continue;
        names.push_back(fileName(error) + "-" + fileName(along->name));
        drawLines(folder, names.back(), byKey, {along->name, true}, error);
    }
    if (report.mode != Report::Mode::grid || report.keys.size() != 2) return names;
    if (errors.empty()) errors.emplace_back("error");
    for (const std::string& error : errors) {
        names.push_back(fileName(error) + "-map");
        drawMap(report, results, error, folder, names.back());
    }
    return names;
}

}  // namespace isph
