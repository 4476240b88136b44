// SPDX-License-Identifier: GPL-3.0-or-later
// A page of panels, one a time, with axes, colour bar and measured profiles, as PNG.
#pragma once
#include "Frame.hpp"
#include "Overlay.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph {

struct Region {
    Vec<2> low, high;  ///< corners [m]
};

struct PictureStyle {
    int width = 1200;        ///< of the picture in pixels
    int columns = 1;         ///< of panels
    std::string title;       ///< above all panels; empty: none
    std::string fieldLabel;  ///< beside the colour bar
    Range range;             ///< of the colours
    Region region;
    std::string right = "x", up = "y";  ///< names of the axes
    Overlay overlay;
    std::string overlayLabel = "measured";
};

/// The region that holds all particles, and a little more.
Region regionOf(const std::vector<Frame>& frames);

/// Paints a panel for each frame and writes the file. Throws FatalIOError if it cannot be written.
void paintPicture(const std::vector<Frame>& frames, const PictureStyle& style,
                  const std::filesystem::path& file);

}  // namespace isph
