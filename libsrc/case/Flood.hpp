// SPDX-License-Identifier: GPL-3.0-or-later
// Where water can get to between the walls, on a grid.
#pragma once
#include "case/CaseGeometry.hpp"

#include <cstdint>

namespace isph {

/// The cells of d0/2 in the domain that are connected with water through passages wider than a
/// width, no higher than the water stands.
class Flood {
public:
    /// up: unit vector against gravity, zero where there is none (then nothing bounds the height).
    Flood(const CaseGeometry& geometry, const std::vector<Point>& water, const Point& up,
          Real passage);

    bool reached(const Point& x) const;
    /// The first place found where water reaches a face of the domain that is neither periodic nor
    /// the open face of a box; nullopt: it stays within.
    std::optional<Point> leak() const { return leak_; }

private:
    using Cell = std::array<std::int64_t, 3>;
    bool inGrid(Cell& cell, bool& leaks) const;
    std::size_t number(const Cell& c) const;
    Cell cellOf(const Point& x) const;
    Point centre(const Cell& c) const;
    bool passable(const Cell& c) const;
    void start(const std::vector<Point>& water);
    void spread();

    const CaseGeometry& g_;
    Point up_;
    Real clearance_, level_ = 0;
    Cell count_{1, 1, 1};
    Point size_;
    std::vector<char> visited_;
    std::vector<Cell> front_;
    std::array<bool, 6> faceOpen_{};  ///< 2 axis + (0 low, 1 high)
    std::optional<Point> leak_;
};

}  // namespace isph
