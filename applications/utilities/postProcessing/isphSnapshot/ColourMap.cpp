// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColourMap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isph {

namespace {

/// Every 16th of viridis' 256 colours, and the last.
constexpr std::array<Colour, 17> kViridis = {{{0.267004, 0.004874, 0.329415},
                                              {0.282327, 0.094955, 0.417331},
                                              {0.278826, 0.175490, 0.483397},
                                              {0.258965, 0.251537, 0.524736},
                                              {0.229739, 0.322361, 0.545706},
                                              {0.199430, 0.387607, 0.554642},
                                              {0.172719, 0.448791, 0.557885},
                                              {0.149039, 0.508051, 0.557250},
                                              {0.127568, 0.566949, 0.550556},
                                              {0.120638, 0.625828, 0.533488},
                                              {0.157851, 0.683765, 0.501686},
                                              {0.246070, 0.738910, 0.452024},
                                              {0.369214, 0.788888, 0.382914},
                                              {0.515992, 0.831158, 0.294279},
                                              {0.678489, 0.863742, 0.189503},
                                              {0.845561, 0.887322, 0.099702},
                                              {0.993248, 0.906157, 0.143936}}};

/// 1, 2 or 5 times a power of ten, the first one that is not smaller.
Real roundUp(Real length)
{
    const Real power = std::pow(10.0, std::floor(std::log10(length)));
    for (const Real factor : {1.0, 2.0, 5.0})
        if (factor * power >= length * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

}  // namespace

Colour mix(const Colour& a, const Colour& b, Real s)
{
    return {a.red + s * (b.red - a.red), a.green + s * (b.green - a.green),
            a.blue + s * (b.blue - a.blue)};
}

Colour viridis(Real share)
{
    const Real place = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    return mix(kViridis[below], kViridis[below + 1], place - static_cast<Real>(below));
}

Range roundRange(std::vector<Real> values, Real outliers)
{
    std::erase_if(values, [](Real v) { return !std::isfinite(v); });
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto skip = static_cast<std::size_t>(outliers * static_cast<Real>(values.size()));
    const Real high = values[values.size() - 1 - skip];
    const Real low = values[skip] > 0 && values[skip] < 0.3 * high ? 0 : values[skip];
    const Real size = std::max(std::abs(low), std::abs(high));
    if (!(high - low > 1e-9 * size)) return {low, low + (size > 0 ? size : 1)};
    const Real step = roundUp((high - low) / 10);
    return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step};
}

std::vector<Real> roundTicks(const Range& range, int count)
{
    const Real step = roundUp((range.high - range.low) / count);
    std::vector<Real> ticks;
    for (Real n = std::ceil(range.low / step - 1e-6); n * step <= range.high + 1e-6 * step; ++n)
        ticks.push_back(n * step);
    return ticks;
}

std::string tickText(Real tick, Real distance)
{
    if (std::abs(tick) < 1e-9 * distance) return "0";
    const int decimals = static_cast<int>(std::ceil(-std::log10(distance) - 1e-9));
    if (decimals > 4 || std::abs(tick) >= 1e6) return fmt::format("{:.4g}", tick);
    return fmt::format("{:.{}f}", tick, std::max(decimals, 0));
}

}  // namespace isph
