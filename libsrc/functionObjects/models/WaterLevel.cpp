// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace isph {
namespace {

constexpr Real kHalf = 0.5;
constexpr Real kScanSteps = 4;  // heights per d0: a quarter of the thinnest layer of particles
constexpr Real kLeastWaterShare =
    0.125;  // of the half at a surface: in a corner of the walls still met

Schema lineKeys()
{
    return {Key::vector("start", "First point.").units(dims::length),
            Key::vector("end", "Last point.").units(dims::length),
            Key::integer("n", "Number of points, both ends included.").atLeast(2)};
}

std::vector<Vector3> readLine(const Dictionary& dict)
{
    const Schema keys = lineKeys();
    keys.check(dict);
    const Vector3 start = keys.get<Vector3>(dict, "start"), end = keys.get<Vector3>(dict, "end");
    const int n = keys.get<int>(dict, "n");
    std::vector<Vector3> points;
    for (int k = 0; k < n; ++k) {
        const Real s = static_cast<Real>(k) / (n - 1);
        points.push_back(((1 - s) * toVec(start) + s * toVec(end)).c);
    }
    return points;
}

/// One vertical of the flow: the sums by which a height is judged.
class Vertical {
public:
    Vertical(const KernelField& field, const Vec<3>& foot, const Vec<3>& up)
        : field_(field), foot_(foot), up_(up)
    {
    }

    struct Sums {
        Real water = 0;  ///< share of water
        Real below = 0;  ///< share of wall that lies below the height

        /// What a still surface at this height would leave: 1/2 exactly on it, also beside walls.
        Real filled() const { return water + below; }
    };

    Sums at(Real z) const
    {
        thread_local KernelSamples samples;
        const Vec<3> x = foot_ + z * up_;
        Sums sums;
        field_.water().gather(x, samples);
        for (const Real weight : samples.weight) sums.water += weight;
        field_.walls().gather(x, samples);
        const Real spacing = field_.flow().spacing;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const Real above =
                dot(samples.offset[k], up_) / spacing;  // of x above the wall particle
            sums.below += samples.weight[k] * std::clamp(kHalf + above, Real(0), Real(1));
        }
        return sums;
    }

    /// The height between low and high where `share` of the sums passes through `mark`.
    template <class Share>
    Real crossing(Real low, Real high, Share&& share, Real mark) const
    {
        const bool filledAtLow = share(at(low)) >= mark;
        for (int k = 0; k < 40; ++k) {  // a quarter spacing halved until round-off
            const Real middle = 0.5 * (low + high);
            ((share(at(middle)) >= mark) == filledAtLow ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

private:
    const KernelField& field_;
    Vec<3> foot_, up_;
};

/// Free-surface elevation (height along the direction opposite to gravity, from the origin) at
/// points or along a line: the highest z on the vertical of each point where
///     sum over water V_j W  +  sum over walls below z V_j W  =  1/2
/// Walls below z count as filled, those above as empty (in between over one spacing), so that a
/// still surface is met beside walls as in the open, on flat, inclined or curved floors, and a
/// layer of one particle on a floor stands d0 above it. A layer counts if it rests on a wall, or if
/// it is at least minimumDepth spacings deep: drops and single particles above the surface do not.
/// A vertical without water gets dryLevel if given; else the floor, the lowest height at which wall
/// ends; else, where there is no wall, the lowest height of any particle. A vertical outside the
/// domain is an error.
class WaterLevel : public FunctionObject {
public:
    static Schema keys()
    {
        return keysWith({
            Key::list("at", "Points ((x y z) ...) whose verticals are searched.")
                .units(dims::length)
                .mayBeAbsent(),
            Key::dictionary("line",
                            "Instead of at: start (x y z); end (x y z); n <number of points>;")
                .mayBeAbsent(),
            Key::scalar(
                "minimumDepth",
                "Spacings that a layer off the walls must be deep to count; 0: drops count.")
                .byDefault("2")
                .atLeast(0),
            Key::scalar("dryLevel",
                        "Elevation written where a vertical holds no water; else the floor.")
                .units(dims::length)
                .mayBeAbsent(),
            Key::vector("direction", "Upward direction; opposite to gravity where absent.")
                .mayBeAbsent(),
        });
    }

    explicit WaterLevel(const Dictionary& dict)
        : dict_(dict), minimumDepth_(keys().get<Real>(dict, "minimumDepth"))
    {
        if (dict.found("at") == dict.found("line"))
            dict.fail(
                "at",
                fmt::format("\"{}\" needs either at ((x y z) ...); or line {{ start; end; n; }}",
                            dict.name()));
        points_ = dict.found("at") ? dict.get<std::vector<Vector3>>("at", dims::length)
                                   : readLine(dict.subDict("line"));
        if (points_.empty()) dict.fail("at", "at holds no point");
        if (dict.found("dryLevel")) dryLevel_ = dict.get<Real>("dryLevel", dims::length);
        if (!dict.found("direction")) return;
        up_ = unit(toVec(dict.get<Vector3>("direction")));
        if (normSqr(*up_) == 0) dict.fail("direction", "direction (0 0 0) points nowhere");
    }

    std::vector<Real> measure(const FlowView& flow) override
    {
        const Vec<3> up = up_ ? *up_ : upward(flow);
        if (normSqr(up) == 0)
            dict_.fail("direction",
                       "without gravity there is no upward direction: give direction (x y z)");
        requireInDomain(flow, up);
        const KernelField field(flow);
        std::vector<Real> levels(points_.size());
        const Range range = extent(field, up);
        parallelForDynamic(points_.size(), [&](Index p) {
            const Vec<3> point = pointIn(flow, points_[p]);
            levels[p] =
                level(Vertical(field, point - dot(point, up) * up, up), range, flow.spacing);
        });
        return levels;
    }

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> all;
        for (std::size_t p = 0; p < points_.size(); ++p) all.push_back(fmt::format("level_{}", p));
        return all;
    }

    std::vector<std::string> header() const override
    {
        std::vector<std::string> lines{"elevations [m] at the points"};
        for (int d = 0; d < 3; ++d) {
            lines.emplace_back(1, static_cast<char>('x' + d));
            for (const Vector3& point : points_) lines.back() += fmt::format(" {}", point[d]);
        }
        return lines;
    }

private:
    struct Range {
        Real low, high;
    };

    /// Refuses points whose verticals miss the domain.
    void requireInDomain(const FlowView& flow, const Vec<3>& up) const
    {
        const Vector3 &min = flow.domainMin, &max = flow.domainMax;
        for (const Vector3& point : points_) {
            Range inside{-std::numeric_limits<Real>::max(), std::numeric_limits<Real>::max()};
            for (int d = 0; d < flow.dimension; ++d) {
                if (!(min[d] < max[d])) continue;
                const Real tolerance = 1e-9 * (max[d] - min[d]);
                const Real low = min[d] - tolerance - point[d],
                           high = max[d] + tolerance - point[d];
                if (std::fabs(up[d]) < 1e-12) {
                    if (low > 0 || high < 0) inside.high = -std::numeric_limits<Real>::max();
                    continue;
                }
                inside.low = std::max(inside.low, std::min(low / up[d], high / up[d]));
                inside.high = std::min(inside.high, std::max(low / up[d], high / up[d]));
            }
            if (inside.low > inside.high)
                dict_.fail(dict_.found("at") ? "at" : "line",
                           fmt::format("the vertical of the point ({} {} {}) lies outside the "
                                       "domain, which is ({} {} {}) to ({} {} {})",
                                       point[0], point[1], point[2], min[0], min[1], min[2], max[0],
                                       max[1], max[2]));
        }
    }

    /// From the lowest particle to the highest one of the water.
    static Range extent(const KernelField& field, const Vec<3>& up)
    {
        const Real infinity = std::numeric_limits<Real>::infinity();
        Range range{infinity, -infinity};
        for (const Vec<3>& x : field.water().position())
            range.high = std::max(range.high, dot(x, up));
        for (const KernelCloud* cloud : {&field.water(), &field.walls()})
            for (const Vec<3>& x : cloud->position()) range.low = std::min(range.low, dot(x, up));
        range.high = std::max(range.high, range.low);
        return std::isfinite(range.low) ? range : Range{0, 0};
    }

    /// Scans downwards and ends as soon as a layer is known to count.
    Real level(const Vertical& vertical, const Range& range, Real spacing) const
    {
        const Real step = spacing / kScanSteps;
        const auto filled = [](const Vertical::Sums& s) { return s.filled(); };
        Real z = range.high + 2 * spacing;
        while (z > range.low) {
            while (z > range.low && filled(vertical.at(z)) < kHalf) z -= step;
            if (z <= range.low) break;
            const Real surface = vertical.crossing(z, z + step, filled, kHalf);
            const bool wet = vertical.at(surface).water >= kLeastWaterShare;
            bool rests = false;
            for (; z > range.low - spacing; z -= step) {
                const Vertical::Sums sums = vertical.at(z);
                if (filled(sums) < kHalf) break;
                rests = sums.below >= sums.water;
                if (wet && (rests || surface - z >= minimumDepth_ * spacing)) return surface;
            }
        }
        return dryLevel_ ? *dryLevel_ : floorOf(vertical, range, spacing);
    }

    /// The lowest height at which wall ends; the lowest particle's where there is none. Inside a
    /// wall the share below is 1/2 throughout, so the height at which it begins to fall is
    /// extrapolated from two above, where it falls linearly also in a corner.
    static Real floorOf(const Vertical& vertical, const Range& range, Real spacing)
    {
        constexpr Real inside = 0.45, outside = 0.4;  // lattice sums ripple by 0.02
        const Real step = spacing / kScanSteps;
        const auto below = [](const Vertical::Sums& s) { return s.below; };
        bool inWall = false;
        for (Real z = range.low; z <= range.high + 2 * spacing; z += step) {
            const Real share = below(vertical.at(z));
            if (inWall && share < outside) {
                const Real near = vertical.crossing(z - 2 * step, z, below, inside);
                return 2 * near - vertical.crossing(z - 2 * step, z, below, outside);
            }
            inWall = inWall || share >= inside;
        }
        return range.low;
    }

    Dictionary dict_;
    std::vector<Vector3> points_;
    Real minimumDepth_;
    std::optional<Real> dryLevel_;
    std::optional<Vec<3>> up_;
};

const FunctionObject::Table::Entry<WaterLevel> entry{"waterLevel"};

}  // namespace
}  // namespace isph
