// SPDX-License-Identifier: GPL-3.0-or-later
// Discs and spheres as pixels, the nearest on top.
#pragma once
#include "ColourMap.hpp"
#include "core/Vec.hpp"

#include <cstdint>
#include <vector>

namespace isph {

struct Disc {
    Vec<2> centre;    ///< in pixels, y downwards
    Real radius = 1;  ///< in pixels
    Real depth = 0;   ///< the larger the nearer to the viewer
    Colour colour;
    bool round = false;  ///< shaded and deep as a sphere whose centre is at `depth` (in pixels)
};

/// Brightness of a surface by its unit normal (right, up, towards the viewer): 0.45 in the shade;
/// light comes from the upper left, in front of the picture.
Real brightness(const Vec<3>& normal);

class Raster {
public:
    /// Pixels of the picture; each is the mean of samples x samples points.
    Raster(int width, int height, int samples = 3);

    void paint(const Disc& disc);
    int width() const { return width_; }
    int height() const { return height_; }
    /// Premultiplied 0xAARRGGBB, row by row, transparent where nothing was painted.
    std::vector<std::uint32_t> pixels() const;

private:
    struct Sample {
        std::uint8_t red, green, blue;
        float depth;
    };
    int width_, height_, samples_;
    std::vector<Sample> data_;
};

}  // namespace isph
