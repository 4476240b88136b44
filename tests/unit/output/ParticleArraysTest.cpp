// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/ParticleArrays.hpp"

#include "core/Error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace isph {
namespace {

constexpr Real kSpacing = 0.1;

Water<2> someWater()
{
    Water<2> water;
    for (int i = 0; i < 3; ++i) {
        const Real a = 0.1 * i + 0.3;
        water.x.push_back({{a, -a}});
        water.u.push_back({{1 / a, a}});
        water.uOld.push_back({{a * a, 2}});
        water.p.push_back(7 * a);
        water.forceGradient.push_back({{-a, 9.81}});
        water.forceGradientOld.push_back({{-2 * a, 9.8}});
        water.porosity.push_back(a), water.porosityOld.push_back(a / 3);
        water.id.push_back(10 - i);
    }
    return water;
}

Walls<2> someWalls()
{
    Walls<2> walls;
    walls.x = {{{0, -0.05}}, {{0.1, -0.05}}};
    walls.normal = {{{0, 1}}, {{0.6, 0.8}}};
    walls.depth = {0.05, 0.05};
    walls.volume = {0.01, 0};
    walls.wall = {0, 1};
    walls.id = {0, 1};
    walls.names = {"tank", "caisson"};
    return walls;
}

Soil<2> someSoil()
{
    Soil<2> soil;
    soil.x = {{{0.1, 0.2}}, {{0.3, 0.4}}};
    soil.u = {{{0, 0}}, {{0.1, -0.3}}};
    soil.solidVolume = {0.006, 0.007};
    soil.zone = {1, 0};
    soil.released = {0, 1};
    soil.id = {5, 6};
    soil.names = {"sand", "rock"};
    return soil;
}

std::string messageOf(const std::function<void()>& read)
{
    try {
        read();
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.file(), "0/x.vtp");
        return error.what();
    }
    return "nothing";
}

/// Breaks a file and expects that whoever reads it is told of `part`.
template <class Read>
void expectRefusal(ParticleFile file, const std::function<void(ParticleFile&)>& breakIt,
                   Read&& read, const std::string& part)
{
    file.source = "0/x.vtp";
    breakIt(file);
    const std::string message = messageOf([&] { read(file); });
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
}

TEST(ParticleArrays, WhatARestartNeedsComesBackBitForBit)
{
    const Water<2> water = waterOf<2>(fileOf(someWater(), kSpacing));
    EXPECT_EQ(water.x, someWater().x);
    EXPECT_EQ(water.u, someWater().u);
    EXPECT_EQ(water.uOld, someWater().uOld);
    EXPECT_EQ(water.p, someWater().p);
    EXPECT_EQ(water.forceGradient, someWater().forceGradient);
    EXPECT_EQ(water.forceGradientOld, someWater().forceGradientOld);
    EXPECT_EQ(water.porosity, someWater().porosity);
    EXPECT_EQ(water.porosityOld, someWater().porosityOld);
    EXPECT_EQ(water.id, someWater().id);
    const Walls<2> walls = wallsOf<2>(fileOf(someWalls(), kSpacing));
    EXPECT_EQ(walls.x, someWalls().x);
    EXPECT_EQ(walls.normal, someWalls().normal);
    EXPECT_EQ(walls.depth, someWalls().depth);
    EXPECT_EQ(walls.volume, someWalls().volume);
    EXPECT_EQ(walls.wall, someWalls().wall);
    EXPECT_EQ(walls.names, someWalls().names);
    const Soil<2> soil = soilOf<2>(fileOf(someSoil(), kSpacing));
    EXPECT_EQ(soil.x, someSoil().x);
    EXPECT_EQ(soil.u, someSoil().u);
    EXPECT_EQ(soil.solidVolume, someSoil().solidVolume);
    EXPECT_EQ(soil.zone, someSoil().zone);
    EXPECT_EQ(soil.released, someSoil().released);
    EXPECT_EQ(soil.names, someSoil().names);
}

TEST(ParticleArrays, FieldsThatOnlyARunWritesMayBeMissing)
{
    ParticleFile file = fileOf(someWater(), kSpacing);
    file.vectors.erase("UOld"), file.vectors.erase("forceGradient"),
        file.scalars.erase("pEquation");
    const Water<2> water = waterOf<2>(file);
    EXPECT_EQ(water.uOld, someWater().u);
    EXPECT_EQ(water.p, std::vector<Real>(3, 0));
    EXPECT_EQ(water.forceGradient, std::vector<Vec<2>>(3));
    file = fileOf(someWater(), kSpacing);
    file.vectors.erase("forceGradientOld");
    EXPECT_EQ(waterOf<2>(file).forceGradientOld, someWater().forceGradient);
    file.scalars.erase("porosityOfUOld");
    EXPECT_EQ(waterOf<2>(file).porosityOld, someWater().porosity);
    file.scalars.erase("porosityOfU");
    EXPECT_TRUE(waterOf<2>(file).porosity.empty());
    ParticleFile bed = fileOf(someSoil(), kSpacing);
    bed.vectors.erase("U"), bed.integers.erase("released");
    EXPECT_EQ(soilOf<2>(bed).released, (std::vector<std::int64_t>{0, 0}));
}

TEST(ParticleArrays, WaterThatCannotBeIsRefused)
{
    const auto refuse = [](const std::function<void(ParticleFile&)>& breakIt,
                           const std::string& part) {
        expectRefusal(fileOf(someWater(), kSpacing), breakIt, waterOf<2>, part);
    };
    refuse([](ParticleFile& f) { f.points[1][0] = NAN; }, "points of particle 1 is nan");
    refuse([](ParticleFile& f) { f.points[2][1] = INFINITY; }, "points of particle 2 is inf");
    refuse([](ParticleFile& f) { f.points[1][2] = 0.5; }, "Particle 1 has z = 0.5");
    refuse([](ParticleFile& f) { f.vectors["U"][0][1] = NAN; }, "U of particle 0 is nan");
    refuse([](ParticleFile& f) { f.vectors.erase("U"); }, "The array U is missing");
    refuse([](ParticleFile& f) { f.integers.erase("id"); }, "The array id is missing");
}

TEST(ParticleArrays, WallsThatCannotBeAreRefused)
{
    const auto refuse = [](const std::function<void(ParticleFile&)>& breakIt,
                           const std::string& part) {
        expectRefusal(fileOf(someWalls(), kSpacing), breakIt, wallsOf<2>, part);
    };
    refuse([](ParticleFile& f) { f.integers["wall"][1] = 2; }, "wall of particle 1 is 2");
    refuse([](ParticleFile& f) { f.integers["wall"][0] = -1; }, "wall of particle 0 is -1");
    refuse([](ParticleFile& f) { f.names.clear(); }, "The array wallNames is missing");
    refuse([](ParticleFile& f) { f.scalars["volume"][0] = -0.01; }, "allowed: volume >= 0");
    refuse(
        [](ParticleFile& f) {
            f.vectors["normal"][1] = {0, 0, 0};
        },
        "normal of particle 1 has the length 0");
    refuse([](ParticleFile& f) { f.vectors["normal"][1][0] = NAN; }, "normal of particle 1 is nan");
}

TEST(ParticleArrays, SoilThatCannotBeIsRefused)
{
    const auto refuse = [](const std::function<void(ParticleFile&)>& breakIt,
                           const std::string& part) {
        expectRefusal(fileOf(someSoil(), kSpacing), breakIt, soilOf<2>, part);
    };
    refuse([](ParticleFile& f) { f.integers["zone"][0] = 2; }, "zone of particle 0 is 2");
    refuse([](ParticleFile& f) { f.integers["zone"][1] = -1; }, "zone of particle 1 is -1");
    refuse([](ParticleFile& f) { f.names["zoneNames"].clear(); }, "the list zoneNames has 0 names");
    refuse([](ParticleFile& f) { f.scalars["solidVolume"][1] = -1; }, "allowed: solidVolume >= 0");
    refuse([](ParticleFile& f) { f.scalars["solidVolume"][1] = NAN; },
           "solidVolume of particle 1 is nan");
}

TEST(ParticleArrays, FilesOfAnotherSpacingOrDimensionAreRefused)
{
    const ParticleFile file = fileOf(someWater(), kSpacing);
    requireSameCase(file, kSpacing, 2);
    const auto check = [](Real spacing, int dimension) {
        return [=](const ParticleFile& f) { requireSameCase(f, spacing, dimension); };
    };
    expectRefusal(
        file, [](ParticleFile&) {}, check(0.2, 2), "made with spacing 0.1");
    expectRefusal(
        file, [](ParticleFile&) {}, check(kSpacing, 3), "made with dimension 2");
    expectRefusal(
        file, [](ParticleFile& f) { f.numbers.erase("spacing"); }, check(kSpacing, 2), "spacing");
}

}  // namespace
}  // namespace isph
