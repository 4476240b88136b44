// SPDX-License-Identifier: GPL-3.0-or-later
// What of a time folder is drawn: particles as discs of the picture's plane.
#pragma once
#include "ColourMap.hpp"
#include "case/TimeList.hpp"
#include "core/Vec.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace isph {

/// A field, or a component or (of a vector) the magnitude of it: "p", "U", "U.x".
struct FieldChoice {
    std::string name;
    int component = -1;  ///< -1: magnitude
    explicit FieldChoice(const std::string& text);
    std::string label() const;  ///< with its unit, where it is known: "|U| [m/s]"
};

/// The picture's plane: x-y seen from +z, x-z seen from -y, or y-z seen from +x.
struct View {
    int right = 0, up = 1, depth = 2;
    Real towards = 1;  ///< sign of the depth axis towards the viewer
    Range slab{-std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
    static View along(const std::string& axis);  ///< "x", "y" or "z"; throws FatalError
};

/// A particle seen in the picture's plane. [m]
struct Dot {
    Vec<2> at;
    Real depth = 0;  ///< towards the viewer
    Real radius = 0;
    Real value = 0;  ///< of the field; water only
};

struct Frame {
    Real time = 0;
    int dimension = 2;
    Real spacing = 0;
    std::vector<Dot> water, walls, soil;
    Range fieldRange;  ///< without the few highest and lowest values
};

/// Reads a time folder. Throws FatalIOError (missing field: names those there are).
Frame readFrame(const TimeFolder& folder, const FieldChoice& field, const View& view);

}  // namespace isph
