// SPDX-License-Identifier: GPL-3.0-or-later
// Text, lines and pixels on a page: the few drawing calls of cairo that a picture needs.
#pragma once
#include "ColourMap.hpp"
#include "Raster.hpp"
#include "core/Vec.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isph {

/// Where a text stands: its left end, middle or right end at the point given.
enum class Align { left, centre, right };

/// A white page; lengths in pixels, y downwards.
class Canvas {
public:
    Canvas(int width, int height);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// The text's middle height is at the point, so that labels meet their ticks.
    void text(const std::string& words, const Vec<2>& at, Real size, Align align = Align::left);
    /// Upwards, its middle at the point.
    void textUpwards(const std::string& words, const Vec<2>& at, Real size);
    Real textWidth(const std::string& words, Real size) const;
    void line(const std::vector<Vec<2>>& points, Real width, const Colour& colour);
    void circle(const Vec<2>& centre, Real radius, const Colour& fill, const Colour& edge);
    void fill(const Vec<2>& corner, Real width, Real height, const Colour& colour);
    /// Paints what follows only inside this rectangle, until the next call or unclip().
    void clip(const Vec<2>& corner, Real width, Real height);
    void unclip();
    void image(const Raster& raster, const Vec<2>& corner);
    /// Throws FatalIOError.
    void writePng(const std::filesystem::path& file) const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace isph
