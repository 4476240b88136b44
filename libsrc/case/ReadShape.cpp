// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/BasicShapes.hpp"
#include "case/CompositeShapes.hpp"
#include "case/PolygonShape.hpp"
#include "case/SurfaceShape.hpp"

#include <fmt/core.h>

#include <functional>
#include <map>
#include <numbers>

namespace isph {

namespace {

using Made = std::unique_ptr<Shape>;

struct ShapeType {
    std::function<Schema(int dimension)> keys;
    std::function<Made(const Dictionary&, const ShapeContext&)> make;
};

Key length3(const char* name, const char* sentence)
{
    return Key::vector(name, sentence).units(dims::length);
}

Point pointOf(const Dictionary& dict, const char* key)
{
    return {dict.get<Vector3>(key, dims::length)};
}

Real positive(const Dictionary& dict, const char* key)
{
    const Real value = dict.get<Real>(key, dims::length);
    if (!(value > 0)) dict.fail(key, fmt::format("{} {} must be positive", key, value));
    return value;
}

// ---- one type after the other: keys, then maker

Schema boxKeys(int)
{
    return {length3("min", "corner of the smallest coordinates [m]"),
            length3("max", "corner of the largest coordinates [m]")};
}

Made makeBox(const Dictionary& dict, const ShapeContext& context)
{
    const Point min = pointOf(dict, "min"), max = pointOf(dict, "max");
    for (int d = 0; d < context.dimension; ++d)
        if (!(max[d] > min[d]))
            dict.fail("max", fmt::format("the box has no extent along {}: min {} and max {}",
                                         "xyz"[d], min[d], max[d]));
    return std::make_unique<Box>(min, max, context.dimension);
}

Schema roundKeys(int)
{
    return {length3("centre", "centre [m]"),
            Key::scalar("radius", "radius [m]").units(dims::length).above(0)};
}

Made makeSphere(const Dictionary& dict, const ShapeContext& context)
{
    return std::make_unique<Sphere>(pointOf(dict, "centre"), positive(dict, "radius"),
                                    context.dimension);
}

Made makeCircle(const Dictionary& dict, const ShapeContext& context)
{
    if (context.dimension == 3)
        dict.fail("type", "a circle is a shape of two dimensions; in three use cylinder or sphere");
    return makeSphere(dict, context);
}

Schema cylinderKeys(int dimension)
{
    if (dimension == 2) return roundKeys(2);
    return {length3("point1", "centre of one end [m]"),
            length3("point2", "centre of the other end [m]"),
            Key::scalar("radius", "radius [m]").units(dims::length).above(0)};
}

Made makeCylinder(const Dictionary& dict, const ShapeContext& context)
{
    if (context.dimension == 2) return makeSphere(dict, context);
    const Point a = pointOf(dict, "point1"), b = pointOf(dict, "point2");
    if (!(norm(b - a) > 0)) dict.fail("point2", "point1 and point2 are the same point");
    return std::make_unique<Cylinder>(a, b, positive(dict, "radius"));
}

Schema halfSpaceKeys(int)
{
    return {length3("point", "a point of the plane [m]"),
            Key::vector("normal", "normal of the plane, out of the shape")};
}

Made makeHalfSpace(const Dictionary& dict, const ShapeContext& context)
{
    Point n{dict.get<Vector3>("normal")};
    if (context.dimension == 2) n[2] = 0;
    if (!(norm(n) > 0)) dict.fail("normal", "the normal of a half-space must not be zero");
    const Real margin = norm(context.domain.size());
    return std::make_unique<HalfSpace>(pointOf(dict, "point"), n,
                                       context.domain.grown(margin, context.dimension),
                                       context.dimension);
}

Schema polygonKeys(int dimension)
{
    Schema keys{Key::list("points", "corners in order, ((x y) (x y) ...) [m]").units(dims::length)};
    if (dimension == 3) {
        keys.add(Key::scalar("zMin", "lower end; the domain's by default [m]")
                     .units(dims::length)
                     .mayBeAbsent());
        keys.add(Key::scalar("zMax", "upper end; the domain's by default [m]")
                     .units(dims::length)
                     .mayBeAbsent());
    }
    return keys;
}

/// ((x y) (x y z) ...): numbers in groups of two or three; the third is not used.
std::vector<Vec<2>> planePoints(const Dictionary& dict, std::string_view key)
{
    std::vector<Vec<2>> points;
    std::vector<Real> group;
    int depth = 0;
    for (const Token& token : dict.tokens(key)) {
        if (token.text == "(") {
            ++depth;
            group.clear();
        } else if (token.text == ")") {
            if (--depth == 1) {
                if (group.size() < 2 || group.size() > 3)
                    dict.fail(
                        key, fmt::format("a point of {} numbers; (x y) is expected", group.size()));
                points.push_back({{group[0], group[1]}});
            }
        } else if (depth == 2 && token.kind == Token::Kind::number) {
            group.push_back(token.number);
        } else if (depth > 0) {
            dict.fail(key, fmt::format("'{}' where a point (x y) is expected", token.text));
        }
    }
    return points;
}

Made makePolygon(const Dictionary& dict, const ShapeContext& context)
{
    const std::vector<Vec<2>> points = planePoints(dict, "points");
    if (points.size() < 3) dict.fail("points", "a polygon needs three points or more");
    const std::vector<Edge> loop = loopOf(points);
    for (const Edge& e : loop)
        if (!(e.length() > 0))
            dict.fail("points",
                      fmt::format("the point ({} {}) stands twice in a row; the last point is "
                                  "joined to the first by itself",
                                  e.a[0], e.a[1]));
    if (crossesItself(loop))
        dict.fail("points", "the edges of the polygon cross or touch one another");
    const Real zMin = dict.getOrDefault("zMin", context.domain.min[2], dims::length);
    const Real zMax = dict.getOrDefault("zMax", context.domain.max[2], dims::length);
    if (context.dimension == 3 && !(zMax > zMin))
        dict.fail("zMax", fmt::format("the polygon has no extent along z: zMin {} and zMax {}",
                                      zMin, zMax));
    return PolygonShape::through(points, context.dimension, zMin, zMax);
}

Schema surfaceKeys(int dimension)
{
    Schema keys{
        Key::text("file", "closed surface in STL, OBJ or VTP, sought from the case's folder")};
    if (dimension == 2)
        keys.add(Key::scalar("z", "height of the section; by default the middle of the surface [m]")
                     .units(dims::length)
                     .mayBeAbsent());
    return keys;
}

Made makeSurface(const Dictionary& dict, const ShapeContext& context)
{
    const std::filesystem::path file = context.caseDir / dict.get<std::string>("file");
    try {
        if (context.dimension == 3) return std::make_unique<SurfaceShape>(file);
        std::optional<Real> z;
        if (dict.found("z")) z = dict.get<Real>("z", dims::length);
        return surfaceSection(file, z);
    } catch (const FatalIOError&) {
        throw;
    } catch (const FatalError& error) {
        dict.fail("file", error.what());
    }
}

Schema compositeKeys(int)
{
    return {Key::dictionary("shapes", "the shapes by name, in order")};
}

Made makeComposite(const Dictionary& dict, const ShapeContext& context, CompositeShape::Kind kind)
{
    const Dictionary& shapes = dict.subDict("shapes");
    std::vector<Made> parts;
    for (const std::string& name : shapes.keywords())
        if (shapes.isDict(name)) parts.push_back(readShape(shapes.subDict(name), context));
    if (parts.size() < 2) dict.fail("shapes", "two shapes or more are expected");
    return std::make_unique<CompositeShape>(kind, std::move(parts), context.dimension);
}

std::function<Made(const Dictionary&, const ShapeContext&)> compositeOf(CompositeShape::Kind kind)
{
    return [kind](const Dictionary& d, const ShapeContext& c) { return makeComposite(d, c, kind); };
}

const std::map<std::string, ShapeType>& types()
{
    using Kind = CompositeShape::Kind;
    static const std::map<std::string, ShapeType> all{
        {"box", {boxKeys, makeBox}},
        {"circle", {roundKeys, makeCircle}},
        {"cylinder", {cylinderKeys, makeCylinder}},
        {"sphere", {roundKeys, makeSphere}},
        {"polygon", {polygonKeys, makePolygon}},
        {"halfSpace", {halfSpaceKeys, makeHalfSpace}},
        {"surface", {surfaceKeys, makeSurface}},
        {"union", {compositeKeys, compositeOf(Kind::unite)}},
        {"difference", {compositeKeys, compositeOf(Kind::subtract)}},
        {"intersection", {compositeKeys, compositeOf(Kind::intersect)}}};
    return all;
}

Made rotated(Made shape, const Dictionary& dict, const ShapeContext& context)
{
    static const Schema keys{Key::scalar("angle", "angle [degrees]"),
                             Key::vector("axis", "direction of the axis").byDefault("(0 0 1)"),
                             length3("origin", "a point of the axis [m]").byDefault("(0 0 0)")};
    keys.check(dict);
    const Point axis{keys.get<Vector3>(dict, "axis")};
    if (!(norm(axis) > 0)) dict.fail("axis", "the axis of a rotation must not be zero");
    if (context.dimension == 2 && (axis[0] != 0 || axis[1] != 0))
        dict.fail("axis", "in two dimensions the axis of a rotation is (0 0 1)");
    const Real angle = keys.get<Real>(dict, "angle") * std::numbers::pi / 180;
    return std::make_unique<RotatedShape>(std::move(shape), rotationAbout(axis, angle),
                                          Point{keys.get<Vector3>(dict, "origin")},
                                          context.dimension);
}

}  // namespace

std::vector<std::string> shapeTypes()
{
    std::vector<std::string> names;
    for (const auto& [name, type] : types()) names.push_back(name);
    return names;
}

Schema shapeKeys(const std::string& type, int dimension)
{
    Schema keys{Key::word("type", "the kind of shape").oneOf(shapeTypes())};
    const Schema own = types().at(type).keys(dimension);
    for (const Key& key : own.keys()) keys.add(key);
    keys.add(Key::dictionary("rotation", "turns the shape: angle [degrees], axis, origin")
                 .mayBeAbsent());
    return keys;
}

std::unique_ptr<Shape> readShape(const Dictionary& dict, const ShapeContext& context,
                                 const std::vector<Key>& others)
{
    const std::string name = dict.get<std::string>("type");
    const auto type = types().find(name);
    if (type == types().end()) {
        const std::string near = nearestName(name, shapeTypes());
        dict.fail("type",
                  fmt::format("Unknown shape type {}{}\n\nValid shape types are:\n\n{}", name,
                              near.empty() ? "" : fmt::format("; did you mean {}?", near),
                              listOf(shapeTypes())));
    }
    Schema keys = shapeKeys(name, context.dimension);
    for (const Key& key : others) keys.add(key);
    keys.check(dict);
    Made shape = type->second.make(dict, context);
    return dict.found("rotation") ? rotated(std::move(shape), dict.subDict("rotation"), context)
                                  : std::move(shape);
}

}  // namespace isph
