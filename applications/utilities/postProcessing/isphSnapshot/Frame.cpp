// SPDX-License-Identifier: GPL-3.0-or-later
#include "Frame.hpp"

#include "Raster.hpp"
#include "core/Error.hpp"
#include "output/TimeFolders.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace isph {

namespace {

constexpr Real kOutliers =
    0.002;  // share of particles, such as spray, that may lie beyond the colours

std::vector<Real> valuesOf(const ParticleFile& file, const FieldChoice& field)
{
    std::vector<Real> values(file.size());
    if (const auto it = file.scalars.find(field.name);
        it != file.scalars.end() && field.component < 0) {
        values = it->second;
    } else if (const auto vector = file.vectors.find(field.name); vector != file.vectors.end()) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Vector3& v = vector->second[i];
            values[i] = field.component < 0 ? norm(Vec<3>{v})
                                            : v[static_cast<std::size_t>(field.component)];
        }
    } else if (const auto whole = file.integers.find(field.name);
               whole != file.integers.end() && field.component < 0) {
        std::transform(whole->second.begin(), whole->second.end(), values.begin(),
                       [](auto v) { return static_cast<Real>(v); });
    } else {
        std::vector<std::string> names;
        for (const auto& f : file.scalars) names.push_back(f.first);
        for (const auto& f : file.vectors) names.push_back(f.first);
        for (const auto& f : file.integers) names.push_back(f.first);
        const std::string nearest = nearestName(field.name, names);
        throw FatalIOError(
            fmt::format("there is no field {}{}; fields are {}", field.name,
                        nearest.empty() ? "" : " (did you mean " + nearest + "?)", listOf(names)),
            file.source, 0);
    }
    return values;
}

std::optional<Dot> dotAt(const Vector3& x, Real radius, const View& view)
{
    const Real along = x[static_cast<std::size_t>(view.depth)];
    if (along < view.slab.low || along > view.slab.high) return {};
    return Dot{{{x[static_cast<std::size_t>(view.right)], x[static_cast<std::size_t>(view.up)]}},
               view.towards * along,
               radius,
               0};
}

void addWater(Frame& frame, const ParticleFile& file, const FieldChoice& field, const View& view)
{
    const std::vector<Real> values = valuesOf(file, field);
    const auto porosity = file.scalars.find("porosity");
    for (std::size_t i = 0; i < file.size(); ++i) {
        const Real eps = porosity == file.scalars.end() ? 1 : porosity->second[i];
        auto dot =
            dotAt(file.points[i], 0.5 * frame.spacing / std::pow(eps, 1.0 / frame.dimension), view);
        if (!dot) continue;
        dot->value = values[i];
        frame.water.push_back(*dot);
    }
    frame.fieldRange = roundRange(values, kOutliers);
}

/// In 3-D the walls between the viewer and the water are left out: their normals point away from
/// him.
void addWalls(Frame& frame, const ParticleFile& file, const View& view)
{
    constexpr Real shown = 2;  // layers of wall particles, in spacings of depth
    const auto normal = file.vectors.find("normal");
    const auto depth = file.scalars.find("depth");
    for (std::size_t i = 0; i < file.size(); ++i) {
        if (depth != file.scalars.end() && depth->second[i] > shown * frame.spacing) continue;
        auto dot = dotAt(file.points[i], 0.5 * frame.spacing, view);
        if (!dot) continue;
        if (frame.dimension == 3 && normal != file.vectors.end()) {
            const Vec<3> n{normal->second[i]};
            const Vec<3> seen{{n[view.right], n[view.up], view.towards * n[view.depth]}};
            if (seen[2] < -0.1) continue;
            dot->value = brightness(seen);
        }
        frame.walls.push_back(*dot);
    }
}

void addSoil(Frame& frame, const ParticleFile& file, const View& view)
{
    for (const Vector3& x : file.points)
        if (const auto dot = dotAt(x, 0.5 * frame.spacing, view)) frame.soil.push_back(*dot);
}

}  // namespace

FieldChoice::FieldChoice(const std::string& text) : name(text)
{
    const auto point = text.find('.');
    if (point == std::string::npos) return;
    name = text.substr(0, point);
    const std::string letter = text.substr(point + 1);
    component = letter == "x" ? 0 : letter == "y" ? 1 : letter == "z" ? 2 : -1;
    if (component < 0)
        throw FatalError(fmt::format("-field {}: a component is .x, .y or .z", text));
}

std::string FieldChoice::label() const
{
    if (name.front() == 'U')
        return component < 0 ? fmt::format("|{}| [m/s]", name)
                             : fmt::format("{}.{} [m/s]", name, "xyz"[component]);
    if (name == "p") return "p [Pa]";
    return component < 0 ? name : fmt::format("{}.{}", name, "xyz"[component]);
}

View View::along(const std::string& axis)
{
    if (axis == "z") return {.right = 0, .up = 1, .depth = 2, .towards = 1};
    if (axis == "y") return {.right = 0, .up = 2, .depth = 1, .towards = -1};
    if (axis == "x") return {.right = 1, .up = 2, .depth = 0, .towards = 1};
    throw FatalError(fmt::format("-view {}: x, y or z is expected", axis));
}

Frame readFrame(const TimeFolder& folder, const FieldChoice& field, const View& view)
{
    const auto parts = readTimeFolder(folder);
    const ParticleFile& water = parts.at("water");
    Frame frame;
    frame.time = folder.value;
    frame.dimension = static_cast<int>(water.number("dimension"));
    frame.spacing = water.number("spacing");
    addWater(frame, water, field, view);
    if (const auto walls = parts.find("walls"); walls != parts.end())
        addWalls(frame, walls->second, view);
    if (const auto soil = parts.find("soil"); soil != parts.end())
        addSoil(frame, soil->second, view);
    return frame;
}

}  // namespace isph
