// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadScene.hpp"

#include "SceneFiles.hpp"
#include "case/CaseSchemas.hpp"
#include "output/TimeFolders.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {

Dictionary readOptional(const std::filesystem::path& file)
{
    return std::filesystem::exists(file) ? Dictionary::read(file)
                                         : Dictionary::parse("", file.string());
}

template <int Dim>
Vec<Dim> fromVector3(const Vector3& a)
{
    Vec<Dim> r;
    for (int d = 0; d < Dim; ++d) r[d] = a[static_cast<std::size_t>(d)];
    return r;
}

template <int Dim>
PeriodicBox<Dim> readBox(const CaseFiles& files)
{
    const Dictionary& domain = files.particles.subDict("domain");
    const auto periodic = readPeriodic(files.boundaries, Dim);
    PeriodicBox<Dim> box;
    box.min = fromVector3<Dim>(domainKeys().get<Vector3>(domain, "min"));
    box.max = fromVector3<Dim>(domainKeys().get<Vector3>(domain, "max"));
    for (int d = 0; d < Dim; ++d) box.periodic[d] = periodic[static_cast<std::size_t>(d)];
    return box;
}

/// Distance between the first and the last particle in a direction.
template <int Dim>
Real extentAlong(const Water<Dim>& water, const Vec<Dim>& direction)
{
    Real low = 0, high = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Real z = dot(water.x[i], direction);
        if (i == 0 || z < low) low = z;
        if (i == 0 || z > high) high = z;
    }
    return high - low;
}

/// Extent along g (without gravity the largest) and largest speed of the water at hand, and the
/// properties of the dictionaries.
template <int Dim>
WaterProperties waterProperties(const CaseFiles& files, const Water<Dim>& water)
{
    WaterProperties properties;
    properties.spacing = particlesKeys().get<Real>(files.particles, "spacing");
    transportKeys().check(files.transport);
    properties.density = transportKeys().get<Real>(files.transport, "rho");
    properties.viscosity = transportKeys().get<Real>(files.transport, "nu");
    properties.force = readForce(files.gravity, Dim);
    const Vec<Dim> down = unit(fromVector3<Dim>(properties.force));
    Real extent = extentAlong(water, down);
    if (norm(down) == 0)
        for (int d = 0; d < Dim; ++d) {
            Vec<Dim> axis;
            axis[d] = 1;
            extent = std::max(extent, extentAlong(water, axis));
        }
    for (const Vec<Dim>& u : water.u) properties.speed = std::max(properties.speed, norm(u));
    properties.depth = extent + properties.spacing;
    return properties;
}

/// Depth at the start of the case, also when the run goes on from a later time.
template <int Dim>
WaterProperties propertiesAtStart(const CaseFiles& files, const TimeFolder& start,
                                  const Water<Dim>& now)
{
    const std::vector<TimeFolder> folders = timeFolders(files.caseDir);
    if (start.value == 0 || folders.empty() || folders.front().value != 0)
        return waterProperties(files, now);
    Scene<Dim> first;
    takeParticles(readTimeFolder(folders.front()), first);
    return waterProperties(files, first.water);
}

/// Zones in the order in which the soil particles number them.
template <int Dim>
void readSoil(const CaseFiles& files, Scene<Dim>& scene)
{
    if (scene.soil.size() == 0) return;
    std::vector<SoilZone> zones = readZones(files.porousZones, scene.soil.names);
    for (SoilZone& zone : zones)
        zone.resistance = zone.model->resistance(zone.porosity, scene.scheme.viscosity);
    scene.porous = std::make_unique<PorousField<Dim>>(std::move(zones), scene.wallCloud,
                                                      scene.scheme.spacing);
    scene.porous->place(scene.soil, scene.box);
}

template <int Dim>
Real leastPorosity(const CaseFiles& files, const Soil<Dim>& soil)
{
    Real least = 1;
    for (const std::string& name : soil.names)
        if (files.porousZones.found(name))
            least =
                std::min(least, PorousModel::select(files.porousZones.subDict(name))->porosity());
    return least;
}

/// A wall may move along itself alone: its particles stay where they are.
template <int Dim>
void requireAlongItself(const Dictionary& condition, const WallCloud<Dim>& walls, std::int64_t wall,
                        const Vec<Dim>& velocity)
{
    Real across = 0, count = 0;
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (walls.wall[k] == wall) across += std::abs(dot(velocity, walls.normal[k])), count += 1;
    if (across > 0.2 * count * norm(velocity))   // corners have normals of their own
        condition.fail("velocity",
                       "The velocity of a wall lies along its surface; walls that move through the "
                       "water are not built.");
}

/// Walls with friction, and their velocities, told to the wall cloud.
template <int Dim>
void readFriction(const CaseFiles& files, const std::vector<std::string>& names,
                  WallCloud<Dim>& walls)
{
    if (!files.boundaries.found("walls")) return;
    const Dictionary& conditions = files.boundaries.subDict("walls");
    for (const std::string& name : conditions.keywords()) {
        const auto it = std::find(names.begin(), names.end(), name);
        if (it == names.end())
            conditions.fail(name,
                            "There is no wall " + name + ". Walls of this case:\n" + listOf(names));
        const Dictionary& condition = conditions.subDict(name);
        wallConditionKeys().check(condition);
        const std::string kind = wallConditionKeys().get<std::string>(condition, "condition");
        if (kind == "slip" && condition.found("velocity"))
            condition.fail("velocity",
                           "A wall that slips drags no water along: condition noSlip or wallLaw "
                           "belongs to a velocity.");
        if (kind == "slip") continue;
        if (kind == "wallLaw" && readProjection(files.schemes) == Projection::paper)
            condition.fail("condition",
                           "The paper's projection has no wall law: condition slip or noSlip.");
        auto& marked = kind == "noSlip" ? walls.noSlip : walls.wallLaw;
        marked.resize(walls.size()), walls.velocity.resize(walls.size());
        const std::int64_t wall = it - names.begin();
        Vec<Dim> velocity;
        if (condition.found("velocity")) {
            const Vector3 given = wallConditionKeys().get<Vector3>(condition, "velocity");
            for (int d = 0; d < Dim; ++d) velocity[d] = given[d];
            requireAlongItself(condition, walls, wall, velocity);
        }
        for (std::size_t k = 0; k < walls.size(); ++k)
            if (walls.wall[k] == wall) marked[k] = 1, walls.velocity[k] = velocity;
    }
}

}  // namespace

CaseFiles::CaseFiles(const std::filesystem::path& dir) : caseDir(dir)
{
    const auto system = dir / "system", constant = dir / "constant";
    particles = Dictionary::read(system / "particlesDict");
    particlesKeys().check(particles);
    gravity = Dictionary::read(constant / "g");
    schemes = Dictionary::read(system / "isphSchemes");
    checkSchemes(schemes);
    solution = Dictionary::read(system / "isphSolution");
    solutionKeys().check(solution);
    boundaries = readOptional(system / "boundaryDict");
    boundaryKeys().check(boundaries);
    transport = readOptional(constant / "transportProperties");
    porousZones = readOptional(constant / "porousZones");
    turbulence = readOptional(constant / "turbulenceProperties");
    hasErosion = std::filesystem::exists(constant / "erosionProperties");
    erosion = readOptional(constant / "erosionProperties");
}

int CaseFiles::dimension() const { return particlesKeys().get<int>(particles, "dimension"); }

template <int Dim>
Scene<Dim> readScene(const CaseFiles& files, const TimeFolder& start)
{
    Scene<Dim> scene;
    const auto parts = readTimeFolder(start);
    const Real spacing = particlesKeys().get<Real>(files.particles, "spacing");
    for (const auto& part : parts) requireSameCase(part.second, spacing, Dim);
    takeParticles(parts, scene);
    if (scene.water.size() == 0)
        throw FatalIOError("There is no water.", (start.path / "water.vtp").string(), 0);
    scene.scheme = readScheme<Dim>(files.schemes, propertiesAtStart(files, start, scene.water));
    Dictionary choice = files.schemes;
    if (!choice.found("kernel")) choice.set("kernel", "wendlandC2");
    scene.kernel = Kernel::select(choice);
    scene.box = readBox<Dim>(files);
    if (readTimeState(start).index == 0) requireApart(scene, start.path / "water.vtp");
    const Real porosity = scene.soil.size() > 0 ? leastPorosity(files, scene.soil) : 1;
    const Real reach =
        scene.kernel->supportRadius() * scene.scheme.h0 / std::pow(porosity, Real(1) / Dim);
    scene.wallCloud = WallCloud<Dim>(scene.walls, scene.box, reach + scene.scheme.spacing);
    readFriction(files, scene.walls.names, scene.wallCloud);
    readSoil(files, scene);
    if (readTimeState(start).index == 0)   // later ones are written sorted
        sortParticles(scene, scene.kernel->supportRadius() * scene.scheme.h0);
    scene.solver = PressureSolver::select(files.solution.subDict("pressure"));
    if (files.turbulence.found("turbulenceModel")) {
        scene.turbulence = TurbulenceModel::select(files.turbulence);
        if (!scene.turbulence->active()) scene.turbulence.reset();
    }
    return scene;
}

template Scene<2> readScene(const CaseFiles&, const TimeFolder&);
template Scene<3> readScene(const CaseFiles&, const TimeFolder&);

}  // namespace isph
