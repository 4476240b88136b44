// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/CaseGeometry.hpp"

#include "case/CaseSchemas.hpp"
#include "case/InitialVelocity.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

namespace isph {

Wall::Wall(std::string name, std::unique_ptr<Shape> shape, bool fluidInside,
           std::vector<int> openFaces, Location at, int dimension)
    : name_(std::move(name)),
      shape_(std::move(shape)),
      fluidInside_(fluidInside),
      openFaces_(std::move(openFaces)),
      at_(std::move(at))
{
    if (openFaces_.empty()) return;
    frame_ = shape_->box();
    const Real far = 1e3 * norm(frame_->length);
    Point min, max = frame_->length;
    for (int face : openFaces_) (face % 2 ? max : min)[face / 2] += face % 2 ? far : -far;
    channel_ = std::make_unique<Box>(min, max, dimension);
}

bool Wall::isOpen(int face) const
{
    return std::find(openFaces_.begin(), openFaces_.end(), face) != openFaces_.end();
}

Real Wall::bodyDistance(const Point& x) const
{
    if (!channel_) return (fluidInside_ ? -1 : 1) * shape_->signedDistance(x);
    const Point local = frame_->toLocal(x);
    Real f = -channel_->signedDistance(local);
    for (int face : openFaces_) {
        const int d = face / 2;
        f = std::max(f, face % 2 ? local[d] - frame_->length[d] : -local[d]);
    }
    return f;
}

Point Wall::surfacePoint(const Point& x) const
{
    if (!channel_) return shape_->nearestPoint(x);
    Point q = channel_->nearestPoint(frame_->toLocal(x));
    for (int face : openFaces_) {  // the surface ends at the plane of the open face
        const int d = face / 2;
        q[d] = face % 2 ? std::min(q[d], frame_->length[d]) : std::max(q[d], 0.0);
    }
    return frame_->toGlobal(q);
}

Real CaseGeometry::bodyDistance(const Point& x) const
{
    Real f = std::numeric_limits<Real>::max();
    for (const Wall& wall : walls) f = std::min(f, wall.bodyDistance(x));
    return f;
}

Point CaseGeometry::wrapped(Point x) const
{
    for (int d = 0; d < dimension; ++d)
        if (periodic[d]) {
            const Real length = domain.max[d] - domain.min[d];
            x[d] -= length * std::floor((x[d] - domain.min[d]) / length);
        }
    return x;
}

namespace {

/// left right bottom top back front, or xMin ... zMax, in the frame of the box.
int faceOf(const Dictionary& dict, const std::string& word, int dimension)
{
    static const std::vector<std::string> sides{"left", "right", "bottom", "top", "back", "front"};
    static const std::vector<std::string> axes{"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};
    std::vector<std::string> valid;
    for (int face = 0; face < 2 * dimension; ++face) {
        if (word == sides[face] || word == axes[face]) return face;
        valid.push_back(sides[face]);
        valid.push_back(axes[face]);
    }
    const std::string near = nearestName(word, valid);
    dict.fail("open", fmt::format("{} is not a face of the box{}\n\nValid faces are:\n\n{}", word,
                                  near.empty() ? "" : fmt::format("; did you mean {}?", near),
                                  listOf(valid)));
}

Wall readWall(const Dictionary& dict, const ShapeContext& context)
{
    std::unique_ptr<Shape> shape = readShape(dict, context, wallKeys().keys());
    std::vector<int> open;
    for (const std::string& word : dict.getOrDefault("open", std::vector<std::string>{}))
        open.push_back(faceOf(dict, word, context.dimension));
    if (!open.empty() && !shape->box()) dict.fail("open", "only a box has faces that can be open");
    const std::string side =
        dict.getChoice("fluid", {"inside", "outside"}, open.empty() ? "outside" : "inside");
    if (!open.empty() && side == "outside")
        dict.fail(
            "fluid",
            "a box with open faces holds its water inside: write fluid inside, or leave it out");
    return Wall(dict.scopeName(), std::move(shape), side == "inside", std::move(open),
                dict.location(), context.dimension);
}

/// f(sub-dictionary) for each region in dict.key.
template <class F>
void forEachRegion(const Dictionary& dict, const std::string& key, F&& f)
{
    if (!dict.found(key)) return;
    const Dictionary& regions = dict.subDict(key);
    for (const std::string& name : regions.keywords()) {
        if (!regions.isDict(name)) {
            if (regions.isUsedByMacro(name)) continue;
            regions.fail(name,
                         fmt::format("{} is not a dictionary: {} holds one dictionary per region",
                                     name, key));
        }
        f(regions.subDict(name));
    }
}

/// Volume of water and soil, from samples over the domain.
Real sampledVolume(const CaseGeometry& g)
{
    const int along = g.dimension == 2 ? 256 : 40;
    Point cell{};
    Real volume = 1;
    for (int d = 0; d < g.dimension; ++d) {
        cell[d] = (g.domain.max[d] - g.domain.min[d]) / along;
        volume *= cell[d];
    }
    std::int64_t inside = 0;
    const auto covers = [](const auto& regions, const Point& x) {
        return std::any_of(regions.begin(), regions.end(),
                           [&](const auto& region) { return region.shape->signedDistance(x) < 0; });
    };
    for (int k = 0; k < (g.dimension == 3 ? along : 1); ++k)
        for (int j = 0; j < along; ++j)
            for (int i = 0; i < along; ++i) {
                Point x = g.domain.min;
                const std::array<int, 3> number{i, j, k};
                for (int d = 0; d < g.dimension; ++d) x[d] += (number[d] + 0.5) * cell[d];
                inside += covers(g.water, x) + covers(g.soil, x);
            }
    return volume * static_cast<Real>(inside);
}

/// Refuses a spacing of which the particles can neither be numbered nor held in memory, before the
/// first one is laid. Where the whole domain could be filled nothing is sampled.
void requireCountable(const Dictionary& dict, const CaseGeometry& g)
{
    constexpr Real leastBytes = 150;  // of a particle while it is laid: position, velocity, packing
    const Real memory =
        static_cast<Real>(sysconf(_SC_PHYS_PAGES)) * static_cast<Real>(sysconf(_SC_PAGESIZE));
    const Real most = std::min(memory / leastBytes, Real(std::numeric_limits<Index>::max()));
    Real domain = 1;
    for (int d = 0; d < g.dimension; ++d) domain *= g.domain.max[d] - g.domain.min[d];
    if (domain / g.cellVolume() < most) return;
    const Real count = sampledVolume(g) / g.cellVolume();
    if (count < most) return;
    dict.fail(
        "spacing",
        fmt::format(
            "spacing {} m asks for about {:.2g} particles; this machine ({:.2g} GB) holds {:.2g} "
            "at the very most",
            g.spacing, count, 1e-9 * memory, most));
}

}  // namespace

CaseGeometry readGeometry(const Dictionary& dict, const std::array<bool, 3>& periodic,
                          const std::filesystem::path& caseDir)
{
    particlesKeys().check(dict);
    CaseGeometry g;
    g.spacing = dict.get<Real>("spacing", dims::length);
    g.dimension = dict.get<int>("dimension");
    const Dictionary& domain = dict.subDict("domain");
    domainKeys().check(domain);
    g.domain = {{domain.get<Vector3>("min", dims::length)},
                {domain.get<Vector3>("max", dims::length)}};
    if (g.dimension == 2) g.domain.min[2] = g.domain.max[2] = 0;
    for (int d = 0; d < g.dimension; ++d) {
        const Real extent = g.domain.max[d] - g.domain.min[d];
        if (!(extent > 0))
            domain.fail("max", fmt::format("the domain has no extent along {}: min {} and max {}",
                                           "xyz"[d], g.domain.min[d], g.domain.max[d]));
        if (g.spacing > extent)
            dict.fail("spacing",
                      fmt::format("spacing {} m is more than the domain's extent {} m along {}",
                                  g.spacing, extent, "xyz"[d]));
        g.periodic[d] = periodic[d];
    }
    const ShapeContext context{g.dimension, g.domain, caseDir};
    forEachRegion(dict, "walls",
                  [&](const Dictionary& d) { g.walls.push_back(readWall(d, context)); });
    forEachRegion(dict, "water", [&](const Dictionary& d) {
        g.water.push_back({d.scopeName(), readShape(d, context, waterKeys().keys()),
                           readVelocity(d), d.location()});
    });
    forEachRegion(dict, "soil", [&](const Dictionary& d) {
        g.soil.push_back({d.scopeName(), d.get<std::string>("zone"),
                          readShape(d, context, soilKeys().keys()), d.location()});
    });
    requireCountable(dict, g);
    return g;
}

}  // namespace isph
