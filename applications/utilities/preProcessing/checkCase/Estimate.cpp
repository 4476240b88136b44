// SPDX-License-Identifier: GPL-3.0-or-later
#include "Estimate.hpp"

#include "case/RunEstimate.hpp"
#include "case/Time.hpp"
#include "core/Log.hpp"
#include "core/Parallel.hpp"

#include <algorithm>

namespace isph {

namespace {

Real largestSpeed(const CaseParticles& particles, const Point& gravity)
{
    Real low = std::numeric_limits<Real>::max(), high = -low, speed = 0;
    for (std::size_t i = 0; i < particles.water.x.size(); ++i) {
        const Real z = dot(particles.water.x[i], unit(gravity));
        low = std::min(low, z);
        high = std::max(high, z);
        speed = std::max(speed, norm(particles.water.velocity[i]));
    }
    return std::max(speed, std::sqrt(2 * norm(gravity) * std::max(0.0, high - low)));
}

Real stepNumber(const Dictionary& control, Real spacing, Real speed)
{
    const Schema keys = controlDictKeys();
    const Real duration =
        keys.get<Real>(control, "endTime") - control.getOrDefault("startTime", 0.0, dims::time);
    Real step = keys.get<Real>(control, "deltaT");
    if (control.getOrDefault("adjustTimeStep", false)) {
        step = keys.get<Real>(control, "maxCo") * spacing / std::max(speed, 1e-30);
        if (control.found("maxDeltaT"))
            step = std::min(step, control.get<Real>("maxDeltaT", dims::time));
    }
    return std::ceil(std::max(0.0, duration) / step);
}

std::string duration(Real seconds)
{
    if (seconds < 120) return fmt::format("{:.0f} s", std::max(1.0, seconds));
    if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

void printEstimate(const CaseSetup& setup, const CaseParticles& particles, const Point& gravity,
                   const std::filesystem::path& caseDir)
{
    const Dictionary control = Dictionary::read(caseDir / "system" / "controlDict");
    const ParticleNumbers numbers{particles.water.x.size(), particles.walls.size(),
                                  particles.soil.x.size()};
    const Real neighbours =
        neighbourNumber(setup.clearRadius, setup.geometry.spacing, setup.geometry.dimension);
    const Real steps =
        stepNumber(control, setup.geometry.spacing, largestSpeed(particles, gravity));
    const Real seconds = steps * stepTime(numbers, neighbours, threadCount());
    info("\nExpected memory: {:.0f} MB   time: {} ({:.0f} steps, {} threads)",
         1e-6 * runMemory(numbers, neighbours), duration(seconds), steps, threadCount());
}

}  // namespace isph
