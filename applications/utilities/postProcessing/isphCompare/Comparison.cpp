// SPDX-License-Identifier: GPL-3.0-or-later
#include "Comparison.hpp"

#include "core/Error.hpp"
#include "functionObjects/DataFile.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace isph {

namespace fs = std::filesystem;

namespace {

constexpr Real kSameTime = 1e-6;  // relative; times in tables are typed, those of runs summed
constexpr Real kOverhang = 0.05;  // of a profile's length
constexpr int kBandSamples = 2000;

struct Curve {
    std::string name;
    std::vector<Real> x, y;  ///< x ascending
};

using Table = std::vector<std::vector<Real>>;

bool sameTime(Real a, Real b)
{
    return std::abs(a - b) <= kSameTime * std::max({Real(1), std::abs(a), std::abs(b)});
}

DataTable readData(const fs::path& path)
{
    DataTable table = fs::is_directory(path) ? readAllStarts(path) : readDataTable(path);
    if (table.rows.empty()) throw FatalError(fmt::format("{} holds no row", path.string()));
    return table;
}

/// Rows of numbers between commas; lines that begin with # and a first line of names are passed
/// over.
Table readReference(const fs::path& file, std::size_t width)
{
    std::ifstream in(file);
    if (!in) throw FatalError(fmt::format("Cannot read the reference {}", file.string()));
    Table rows;
    int lineNumber = 0;
    bool names = true;
    for (std::string line; std::getline(in, line);) {
        ++lineNumber;
        if (line.empty() || line[0] == '#') continue;
        std::vector<Real> row;
        std::istringstream parts(line);
        for (std::string part; row.size() < width && std::getline(parts, part, ',');) {
            char* end = nullptr;
            const Real value = std::strtod(part.c_str(), &end);
            if (end == part.c_str()) break;
            row.push_back(value);
        }
        if (row.size() == width)
            rows.push_back(row);
        else if (!names || !row.empty())
            throw FatalIOError(
                fmt::format("expected {} numbers between commas, found '{}'", width, line),
                file.string(), lineNumber);
        names = false;
    }
    if (rows.empty()) throw FatalError(fmt::format("The reference {} holds no row", file.string()));
    return rows;
}

/// Linear between the points; beyond the ends constant, for at most `overhang`.
Real valueAt(const Curve& curve, Real x, Real overhang, const std::string& what)
{
    const Real low = curve.x.front(), high = curve.x.back();
    if (x < low - overhang || x > high + overhang)
        throw FatalError(fmt::format("{}: {} {} lies outside the measured range from {} to {}",
                                     curve.name, what, x, low, high));
    if (x <= low) return curve.y.front();
    if (x >= high) return curve.y.back();
    const auto k = static_cast<std::size_t>(std::upper_bound(curve.x.begin(), curve.x.end(), x) -
                                            curve.x.begin());
    const Real share = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
    return (1 - share) * curve.y[k - 1] + share * curve.y[k];
}

Real valueAtTime(const Curve& curve, Real time)
{
    const std::size_t n = curve.x.size();
    const Real row = n > 1 ? curve.x[n - 1] - curve.x[n - 2] : 0;
    return valueAt(curve, time, row + kSameTime * std::max(Real(1), std::abs(time)), "time");
}

std::vector<Real> timesOf(const DataTable& table)
{
    std::vector<Real> times;
    for (const auto& row : table.rows) times.push_back(row[0]);
    return times;
}

bool matches(const std::string& column, const std::string& patterns)
{
    std::istringstream in(patterns);
    for (std::string pattern; in >> pattern;)
        if (pattern == column || fnmatch(pattern.c_str(), column.c_str(), 0) == 0) return true;
    return false;
}

/// Its mean over `width` about each of its points; at the ends over what there is.
Curve averaged(const Curve& curve, Real width)
{
    const std::size_t n = curve.x.size();
    std::vector<Real> integral(n, 0);
    for (std::size_t k = 1; k < n; ++k)
        integral[k] = integral[k - 1] +
                      (curve.y[k] + curve.y[k - 1]) / 2 * (curve.x[k] - curve.x[k - 1]);
    // Up to x: of the rows below it, and of the piece of a straight line from the last of them.
    const auto upTo = [&](Real x) {
        if (x >= curve.x.back()) return integral.back();
        const auto above = std::upper_bound(curve.x.begin(), curve.x.end(), x);
        const auto k =
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - curve.x.begin(), 1)) - 1;
        const Real length = x - curve.x[k];
        const Real slope = (curve.y[k + 1] - curve.y[k]) / (curve.x[k + 1] - curve.x[k]);
        return integral[k] + length * (curve.y[k] + slope * length / 2);
    };
    Curve mean = curve;
    for (std::size_t k = 0; k < n && n > 1; ++k) {
        const Real from = std::max(curve.x.front(), curve.x[k] - width / 2);
        const Real to = std::min(curve.x.back(), curve.x[k] + width / 2);
        if (to > from) mean.y[k] = (upTo(to) - upTo(from)) / (to - from);
    }
    return mean;
}

std::vector<Curve> seriesOf(const Source& source)
{
    const DataTable table = readData(source.series);
    std::vector<Curve> curves;
    for (std::size_t c = 1; c < table.columns.size(); ++c) {
        if (!matches(table.columns[c], source.columns)) continue;
        curves.push_back({table.columns[c], timesOf(table), {}});
        for (const auto& row : table.rows) curves.back().y.push_back(row[c]);
    }
    if (source.average > 0)
        for (Curve& curve : curves) curve = averaged(curve, source.average);
    if (curves.empty())
        throw FatalError(fmt::format("{} has no column {}\n\nIts columns are:\n\n{}",
                                     source.series.string(), source.columns,
                                     listOf({table.columns.begin() + 1, table.columns.end()})));
    return curves;
}

/// The profiles of all rows over the coordinate `along`.
struct Profiles {
    std::vector<Real> times;
    std::vector<Curve> curves;
};

Profiles profilesOf(const Source& source)
{
    const DataTable table = readData(source.profile);
    const auto points = table.header.find(source.along);
    if (points == table.header.end() || points->second.size() + 1 != table.columns.size())
        throw FatalError(
            fmt::format("{} has no line \"# {} ...\" with the coordinate of every column: is it "
                        "the file of a waterLevel?",
                        source.profile.string(), source.along));
    const std::vector<Real>& x = points->second;
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    Profiles all{timesOf(table), {}};
    for (const auto& row : table.rows) {
        Curve curve{source.profile.string(), {}, {}};
        for (const std::size_t k : order) {
            curve.x.push_back(x[k]);
            curve.y.push_back(row[k + 1]);
        }
        all.curves.push_back(curve);
    }
    return all;
}

/// Where the profile last falls through the level, seen from its beginning; its beginning if it
/// never stands above.
Real frontOf(const Curve& curve, Real level)
{
    std::size_t k = curve.x.size();
    while (k > 0 && curve.y[k - 1] <= level) --k;
    if (k == 0) return curve.x.front();
    if (k == curve.x.size()) return curve.x.back();
    const Real share = (curve.y[k - 1] - level) / (curve.y[k - 1] - curve.y[k]);
    return curve.x[k - 1] + share * (curve.x[k] - curve.x[k - 1]);
}

/// Measured values beside those of the band that lie nearest, at evenly spaced times.
std::vector<Sample> besideBand(const std::vector<Curve>& curves, const Source& source,
                               const Table& reference)
{
    Curve low{"band", {}, {}}, high = low;
    for (const auto& row : reference) {
        low.x.push_back(row[0]), low.y.push_back(row[2]);
        high.x.push_back(row[0]), high.y.push_back(row[3]);
    }
    const Real from = std::max(source.from, low.x.front()), to = std::min(source.to, low.x.back());
    std::vector<Sample> all;
    for (const Curve& curve : curves)
        for (int k = 0; k <= kBandSamples && from <= to; ++k) {
            const Real time = from + (to - from) * k / kBandSamples;
            const Real value = valueAtTime(curve, time - source.delay);
            const Real least = valueAt(low, time, 0, "time"), most = valueAt(high, time, 0, "time");
            all.push_back({time, value, value < least ? least : value > most ? most : value});
        }
    return all;
}

std::vector<Sample> fromSeries(const std::vector<Curve>& curves, const Source& source,
                               const Expectation& expectation)
{
    std::vector<Sample> all;
    const Table reference = expectation.reference.empty()
                                ? Table{}
                                : readReference(expectation.reference, expectation.band ? 4 : 2);
    if (expectation.band) return besideBand(curves, source, reference);
    const auto wanted = [&](Real t) { return t >= source.from && t <= source.to; };
    for (const Curve& curve : curves) {
        if (!reference.empty()) {
            for (const auto& row : reference)
                if (wanted(row[0]))
                    all.push_back({row[0], valueAtTime(curve, row[0] - source.delay), row[1]});
        } else if (!source.times.empty()) {
            for (const Real time : source.times)
                all.push_back({time, valueAtTime(curve, time), expectation.value});
        } else {
            for (std::size_t k = 0; k < curve.x.size(); ++k)
                if (wanted(curve.x[k])) all.push_back({curve.x[k], curve.y[k], expectation.value});
        }
    }
    return all;
}

/// The profile at a time, between rows linearly.
Real levelAt(const Profiles& profiles, Real time, Real x, const std::string& file)
{
    Curve inTime{file, profiles.times, {}};
    const Real length = profiles.curves.front().x.back() - profiles.curves.front().x.front();
    for (const Curve& curve : profiles.curves)
        inTime.y.push_back(valueAt(curve, x, kOverhang * length, "point"));
    return valueAtTime(inTime, time);
}

std::vector<Sample> fromProfile(const Source& source, const Expectation& expectation)
{
    const Profiles profiles = profilesOf(source);
    if (source.front) {
        Curve front{"front", profiles.times, {}};
        for (const Curve& curve : profiles.curves) front.y.push_back(frontOf(curve, *source.front));
        return fromSeries({front}, source, expectation);
    }
    const Table reference = readReference(expectation.reference, 3);
    std::vector<Sample> all;
    for (const auto& row : reference) {
        const auto same = [&](Real time) { return sameTime(time, row[0]); };
        if (!source.times.empty() && std::none_of(source.times.begin(), source.times.end(), same))
            continue;
        all.push_back({row[0], levelAt(profiles, row[0], row[1], source.profile.string()), row[2]});
    }
    for (const Real time : source.times)
        if (std::none_of(all.begin(), all.end(),
                         [&](const Sample& s) { return sameTime(s.time, time); }))
            throw FatalError(fmt::format("The reference {} has no point at time {}",
                                         expectation.reference.string(), time));
    return all;
}

}  // namespace

std::vector<Sample> samples(const Source& source, const Expectation& expectation)
{
    if (source.value) return {{0, *source.value, expectation.value}};
    const std::vector<Sample> all = source.profile.empty()
                                        ? fromSeries(seriesOf(source), source, expectation)
                                        : fromProfile(source, expectation);
    if (all.empty())
        throw FatalError(
            fmt::format("There is nothing to compare from time {} to {}", source.from, source.to));
    return all;
}

std::vector<std::string> measureNames()
{
    return {"last", "mean", "max", "min", "rms", "range", "outside"};
}

Real measure(const std::string& name, const std::vector<Sample>& all)
{
    for (const Sample& s : all)
        if (!std::isfinite(s.measured - s.expected)) return std::numeric_limits<Real>::quiet_NaN();
    const auto byValue = [](const Sample& a, const Sample& b) { return a.measured < b.measured; };
    if (name == "range") {
        const auto [low, high] = std::minmax_element(all.begin(), all.end(), byValue);
        return high->measured - low->measured;
    }
    if (name == "outside") {
        const auto off = std::count_if(all.begin(), all.end(), [](const Sample& s) {
            return s.measured != s.expected;
        });
        return 100 * static_cast<Real>(off) / static_cast<Real>(all.size());
    }
    Real latest = all.front().time, sum = 0, squares = 0, largest = 0,
         smallest = std::numeric_limits<Real>::infinity();
    for (const Sample& s : all) latest = std::max(latest, s.time);
    Real atLatest = 0, count = 0;
    for (const Sample& s : all) {
        const Real d = s.measured - s.expected;
        sum += d;
        squares += d * d;
        largest = std::max(largest, std::abs(d));
        smallest = std::min(smallest, std::abs(d));
        if (sameTime(s.time, latest)) atLatest += d, ++count;
    }
    const Real n = static_cast<Real>(all.size());
    if (name == "last") return std::abs(atLatest / count);
    if (name == "mean") return std::abs(sum / n);
    if (name == "rms") return std::sqrt(squares / n);
    return name == "max" ? largest : smallest;
}

std::vector<Sample> inPerCent(std::vector<Sample> all)
{
    Real whole = 0;
    for (const Sample& s : all) whole = std::max(whole, std::abs(s.expected));
    if (whole == 0) throw FatalError("-relative needs an expected value other than 0");
    for (Sample& s : all) s = {s.time, 100 * s.measured / whole, 100 * s.expected / whole};
    return all;
}

}  // namespace isph
