// SPDX-License-Identifier: GPL-3.0-or-later
#include "Picture.hpp"

#include "Canvas.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace isph {

namespace {

constexpr Colour kWall{0.62, 0.62, 0.64}, kSoil{0.80, 0.70, 0.56}, kGrain{0.42, 0.29, 0.16};
constexpr Colour kWallInLight{0.90, 0.90, 0.92};
constexpr Colour kFrame{0.35, 0.35, 0.35}, kMeasured{0.84, 0.10, 0.11}, kWhite{1, 1, 1};

/// Lengths of a page in pixels, all from its width.
struct Layout {
    Layout(const PictureStyle& style, std::size_t panels)
    {
        small =
            std::clamp(style.width * 0.0135, 10.0, 40.0) / std::sqrt(std::min(style.columns, 3));
        large = 1.35 * small;
        columns = style.columns;
        rows = (static_cast<int>(panels) + columns - 1) / columns;
        const Vec<2> size = style.region.high - style.region.low;
        left = 5.0 * small, below = 2.2 * small, above = 2.0 * small, gap = 1.0 * small;
        top = style.title.empty() ? 0.4 * small : 2.6 * large;
        bottom = 2.4 * small;
        bar = 9.0 * small;
        panelWidth = std::floor((style.width - bar) / columns - left - gap);
        scale = panelWidth / size[0];
        panelHeight = std::ceil(size[1] * scale);
        height = static_cast<int>(std::ceil(top + rows * (above + panelHeight + below) + bottom));
    }
    Vec<2> corner(std::size_t panel) const
    {
        const auto row = static_cast<Real>(static_cast<int>(panel) / columns);
        const auto column = static_cast<Real>(static_cast<int>(panel) % columns);
        return {{std::round(left + column * (left + panelWidth + gap)),
                 std::round(top + above + row * (above + panelHeight + below))}};
    }
    Real small, large, left, below, above, gap, top, bottom, bar, panelWidth, panelHeight, scale;
    int columns, rows, height;
};

/// One panel: the particles of a frame and all that is drawn around them.
class Panel {
public:
    Panel(Canvas& canvas, const Layout& layout, const PictureStyle& style, const Vec<2>& corner)
        : canvas_(canvas), layout_(layout), style_(style), corner_(corner)
    {
    }

    void paint(const Frame& frame) const
    {
        Raster raster(static_cast<int>(layout_.panelWidth), static_cast<int>(layout_.panelHeight));
        if (frame.dimension == 3)
            paintSpheres(raster, frame);
        else
            paintDiscs(raster, frame);
        canvas_.image(raster, corner_);
        paintMeasured(style_.overlay.at(frame.time));
        paintAxes();
        const Vec<2> above = corner_ + Vec<2>{{0, -0.8 * layout_.small}};
        canvas_.text(fmt::format("t = {:.4g} s", frame.time), above, 1.1 * layout_.small);
    }

private:
    Vec<2> inRaster(const Vec<2>& x) const
    {
        return {{(x[0] - style_.region.low[0]) * layout_.scale,
                 (style_.region.high[1] - x[1]) * layout_.scale}};
    }

    void paintAll(Raster& raster, const std::vector<Dot>& dots, Real size, const Colour& colour,
                  Real depth) const
    {
        for (const Dot& dot : dots)
            raster.paint(
                {inRaster(dot.at), size * dot.radius * layout_.scale, depth, colour, false});
    }

    /// Layers from below: the tint of the soil, walls, water, the grains of the soil.
    void paintDiscs(Raster& raster, const Frame& frame) const
    {
        paintAll(raster, frame.soil, 1.5, kSoil, 0);  // radius beyond half the diagonal: no holes
        paintAll(raster, frame.walls, 1.5, kWall, 1);
        for (const Dot& dot : frame.water)
            raster.paint({inRaster(dot.at), 1.1 * dot.radius * layout_.scale, 2,
                          viridis(style_.range.share(dot.value)), false});
        paintAll(raster, frame.soil, 0.36, kGrain, 3);
    }

    /// Walls as lit discs without gaps, a quiet background; soil and water as spheres.
    void paintSpheres(Raster& raster, const Frame& frame) const
    {
        const auto paint = [&](const std::vector<Dot>& dots, Real size, bool round,
                               auto&& colourOf) {
            for (const Dot& dot : dots)
                raster.paint({inRaster(dot.at), size * dot.radius * layout_.scale,
                              dot.depth * layout_.scale, colourOf(dot), round});
        };
        paint(frame.walls, 1.5, false, [](const Dot& dot) {
            return mix({0, 0, 0}, kWallInLight, dot.value);
        });
        paint(frame.soil, 1.1, true, [](const Dot&) { return kSoil; });
        paint(frame.water, 1.1, true,
              [&](const Dot& dot) { return viridis(style_.range.share(dot.value)); });
    }

    void paintMeasured(const std::vector<Vec<2>>& profile) const
    {
        if (profile.empty()) return;
        std::vector<Vec<2>> points;
        for (const Vec<2>& x : profile) points.push_back(corner_ + inRaster(x));
        canvas_.clip(corner_, layout_.panelWidth, layout_.panelHeight);
        canvas_.line(points, 0.30 * layout_.small, kWhite);
        canvas_.line(points, 0.15 * layout_.small, kMeasured);
        for (const Vec<2>& point : points)
            canvas_.circle(point, 0.24 * layout_.small, kMeasured, kWhite);
        canvas_.unclip();
        const Real size = layout_.small, right = corner_[0] + layout_.panelWidth;
        const Real y = corner_[1] - 0.8 * size,
                   start = right - canvas_.textWidth(style_.overlayLabel, size) - 0.7 * size;
        canvas_.line({{{start - 2 * size, y}}, {{start, y}}}, 0.15 * size, kMeasured);
        canvas_.circle({{start - size, y}}, 0.24 * size, kMeasured, kWhite);
        canvas_.text(style_.overlayLabel, {{right, y}}, size, Align::right);
    }

    void paintAxes() const
    {
        const Real size = layout_.small, w = layout_.panelWidth, h = layout_.panelHeight;
        const Vec<2> end = corner_ + Vec<2>{{w, h}};
        canvas_.line({corner_, {{end[0], corner_[1]}}, end, {{corner_[0], end[1]}}, corner_},
                     0.07 * size, kFrame);
        const int wanted = std::max(2, static_cast<int>(w / (7 * size)));
        const std::vector<Real> xs =
            roundTicks({style_.region.low[0], style_.region.high[0]}, wanted);
        for (const Real x : xs) {
            const Real at = corner_[0] + (x - style_.region.low[0]) * layout_.scale;
            canvas_.line({{{at, end[1]}}, {{at, end[1] + 0.4 * size}}}, 0.07 * size, kFrame);
            canvas_.text(label(x, xs), {{at, end[1] + 1.2 * size}}, size, Align::centre);
        }
        const std::vector<Real> ys = roundTicks({style_.region.low[1], style_.region.high[1]},
                                                std::max(2, static_cast<int>(h / (4 * size))));
        for (const Real y : ys) {
            const Real at = end[1] - (y - style_.region.low[1]) * layout_.scale;
            canvas_.line({{{corner_[0] - 0.4 * size, at}}, {{corner_[0], at}}}, 0.07 * size,
                         kFrame);
            canvas_.text(label(y, ys), {{corner_[0] - 0.7 * size, at}}, size, Align::right);
        }
        canvas_.textUpwards(style_.up + " [m]", {{corner_[0] - 4.1 * size, corner_[1] + 0.5 * h}},
                            size);
    }

    static std::string label(Real tick, const std::vector<Real>& ticks)
    {
        return tickText(tick,
                        ticks.size() > 1 ? ticks[1] - ticks[0] : std::max(std::abs(tick), 1e-12));
    }

    Canvas& canvas_;
    const Layout& layout_;
    const PictureStyle& style_;
    Vec<2> corner_;
};

/// Right of the panels, at most as high as the picture is wide.
void paintColourBar(Canvas& canvas, const Layout& layout, const PictureStyle& style)
{
    const Real size = layout.small, width = 1.3 * size;
    const Real space = layout.height - layout.top - layout.above - layout.below - layout.bottom;
    const Real height = std::min(space, std::max(30 * size, layout.panelHeight));
    const Real left = style.width - layout.bar + 1.4 * size;
    const Real top = layout.top + layout.above + 0.5 * (space - height);
    const int strips = static_cast<int>(height);
    for (int s = 0; s < strips; ++s)  // each reaches to the lower end, so that no seam shows
        canvas.fill({{left, top + s}}, width, height - s, viridis(1 - (s + 0.5) / strips));
    canvas.line({{{left, top}},
                 {{left + width, top}},
                 {{left + width, top + height}},
                 {{left, top + height}},
                 {{left, top}}},
                0.07 * size, kFrame);
    const std::vector<Real> ticks =
        roundTicks(style.range, std::max(2, static_cast<int>(height / (5 * size))));
    for (const Real tick : ticks) {
        const Real y = top + height * (1 - style.range.share(tick));
        canvas.line({{{left + width, y}}, {{left + width + 0.4 * size, y}}}, 0.07 * size, kFrame);
        canvas.text(tickText(tick, ticks.size() > 1 ? ticks[1] - ticks[0]
                                                    : std::max(std::abs(tick), 1e-12)),
                    {{left + width + 0.7 * size, y}}, size);
    }
    canvas.textUpwards(style.fieldLabel, {{style.width - 0.9 * size, top + 0.5 * height}},
                       1.1 * size);
}

}  // namespace

Region regionOf(const std::vector<Frame>& frames)
{
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Region region{{{infinity, infinity}}, {{-infinity, -infinity}}};
    for (const Frame& frame : frames)
        for (const std::vector<Dot>* dots : {&frame.water, &frame.walls, &frame.soil})
            for (const Dot& dot : *dots)
                for (int d = 0; d < 2; ++d) {
                    region.low[d] = std::min(region.low[d], dot.at[d] - dot.radius);
                    region.high[d] = std::max(region.high[d], dot.at[d] + dot.radius);
                }
    if (!(region.low[0] < region.high[0])) throw FatalError("there are no particles to be drawn");
    return region;
}

void paintPicture(const std::vector<Frame>& frames, const PictureStyle& style,
                  const std::filesystem::path& file)
{
    const Layout layout(style, frames.size());
    Canvas canvas(style.width, layout.height);
    if (!style.title.empty())
        canvas.text(style.title, {{layout.left, 1.4 * layout.large}}, layout.large);
    for (std::size_t f = 0; f < frames.size(); ++f)
        Panel(canvas, layout, style, layout.corner(f)).paint(frames[f]);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (f + static_cast<std::size_t>(layout.columns) < frames.size())
            continue;  // not the last of its column
        const Vec<2> below{
            {0.5 * layout.panelWidth, layout.panelHeight + layout.below + 0.7 * layout.small}};
        canvas.text(style.right + " [m]", layout.corner(f) + below, layout.small, Align::centre);
    }
    paintColourBar(canvas, layout, style);
    canvas.writePng(file);
}

}  // namespace isph
