// SPDX-License-Identifier: GPL-3.0-or-later
// What system/particlesDict describes: domain, walls, water, soil.
#pragma once
#include "case/BasicShapes.hpp"
#include "case/Shape.hpp"

#include <array>
#include <functional>

namespace isph {

/// A wall: the body that water does not enter.
class Wall {
public:
    /// fluidInside: the body is what lies outside the shape. open: faces of a box that have no
    /// wall.
    Wall(std::string name, std::unique_ptr<Shape> shape, bool fluidInside,
         std::vector<int> openFaces, Location at, int dimension);

    const std::string& name() const { return name_; }
    const Shape& shape() const { return *shape_; }
    bool fluidInside() const { return fluidInside_; }
    /// Faces without wall: 2 axis + (0 low, 1 high), in the frame of the box.
    const std::vector<int>& openFaces() const { return openFaces_; }
    bool isOpen(int face) const;
    const Location& location() const { return at_; }

    /// Distance to the wall's surface, negative in its body. The body of a box with an open face
    /// ends at the plane of that face.
    Real bodyDistance(const Point& x) const;
    /// The point of the wall's surface nearest to x.
    Point surfacePoint(const Point& x) const;

private:
    std::string name_;
    std::unique_ptr<Shape> shape_;
    bool fluidInside_;
    std::vector<int> openFaces_;
    Location at_;
    std::optional<OrientedBox> frame_;  // of a box with open faces
    std::unique_ptr<Box> channel_;      // that box, its open faces moved far out, in its own frame
};

/// Velocity at the start, from a vector or from three expressions of x, y and z.
using VelocityField = std::function<Point(const Point&)>;

struct WaterRegion {
    std::string name;
    std::unique_ptr<Shape> shape;
    VelocityField velocity;  ///< empty: at rest
    Location at;
};

struct SoilRegion {
    std::string name, zone;
    std::unique_ptr<Shape> shape;
    Location at;
};

struct CaseGeometry {
    Real spacing = 0;  ///< d0 [m]
    int dimension = 2;
    BoundingBox domain;
    std::array<bool, 3> periodic{};
    std::vector<Wall> walls;
    std::vector<WaterRegion> water;  ///< of overlapping regions the first has the common part
    std::vector<SoilRegion> soil;    ///< as water

    Real cellVolume() const { return dimension == 2 ? sqr(spacing) : cube(spacing); }
    /// Distance to the nearest wall body, negative inside one (then by the depth in the body it is
    /// deepest in). Far out where there are no walls.
    Real bodyDistance(const Point& x) const;
    /// x moved by whole periods into the domain.
    Point wrapped(Point x) const;
    /// Region -> its shape without those listed before it.
    template <class Region>
    static Real ownDistance(const std::vector<Region>& regions, std::size_t k, const Point& x)
    {
        Real f = regions[k].shape->signedDistance(x);
        for (std::size_t j = 0; j < k; ++j) f = std::max(f, -regions[j].shape->signedDistance(x));
        return f;
    }
};

/// Reads system/particlesDict; `periodic` as system/boundaryDict has it. Surfaces are sought from
/// caseDir. Throws FatalIOError for unknown keys and for sizes that cannot be.
CaseGeometry readGeometry(const Dictionary& particlesDict, const std::array<bool, 3>& periodic,
                          const std::filesystem::path& caseDir);

}  // namespace isph
