// SPDX-License-Identifier: GPL-3.0-or-later
#include "TemporaryFolder.hpp"
#include "output/VtpFile.hpp"
#include "output/WholeFile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace isph {
namespace {

ParticleFile someParticles(std::size_t count)
{
    std::mt19937_64 bits(7);
    const auto real = [&] {
        return std::ldexp(static_cast<Real>(bits()), static_cast<int>(bits() % 200) - 160);
    };
    ParticleFile file;
    auto& p = file.scalars["p"];
    auto& U = file.vectors["U"];
    auto& id = file.integers["id"];
    for (std::size_t i = 0; i < count; ++i) {
        file.points.push_back({real(), -real(), real()});
        p.push_back(real());
        U.push_back({real(), real(), -real()});
        id.push_back(static_cast<std::int64_t>(bits()));
    }
    file.names["wallNames"] = {"tank", "", "a wall with blanks & <signs>"};
    file.numbers["dimension"] = {2};
    file.numbers["spacing"] = {0.1};
    return file;
}

/// Equality of every bit, so that -0, subnormal numbers and NaN count.
template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSame(const ParticleFile& a, const ParticleFile& b)
{
    EXPECT_TRUE(sameBits(a.points, b.points));
    ASSERT_EQ(a.scalars.size(), b.scalars.size());
    for (const auto& [name, values] : a.scalars)
        EXPECT_TRUE(sameBits(values, b.scalar(name))) << name;
    ASSERT_EQ(a.vectors.size(), b.vectors.size());
    for (const auto& [name, values] : a.vectors)
        EXPECT_TRUE(sameBits(values, b.vector(name))) << name;
    EXPECT_EQ(a.integers, b.integers);
    EXPECT_EQ(a.names, b.names);
    EXPECT_EQ(a.numbers, b.numbers);
}

std::string errorOf(const std::filesystem::path& file)
{
    try {
        readParticleFile(file);
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.file(), file.string());
        return error.what();
    }
    return "";
}

TEST(VtpFile, WhatIsWrittenIsReadBackBitForBit)
{
    const test::TemporaryFolder folder;
    ParticleFile file = someParticles(10007);
    file.scalars["p"][0] = -0.0;
    file.scalars["p"][1] = std::numeric_limits<Real>::denorm_min();
    file.scalars["p"][2] = std::numeric_limits<Real>::quiet_NaN();
    file.scalars["p"][3] = -std::numeric_limits<Real>::infinity();
    writeParticleFile(folder / "water.vtp", file);
    expectSame(file, readParticleFile(folder / "water.vtp"));
}

TEST(VtpFile, NoParticlesAndOneParticleAreWrittenAndRead)
{
    const test::TemporaryFolder folder;
    for (const std::size_t count : {0u, 1u}) {
        const ParticleFile file = someParticles(count);
        writeParticleFile(folder / "water.vtp", file);
        expectSame(file, readParticleFile(folder / "water.vtp"));
    }
}

TEST(VtpFile, NoTemporaryFileIsLeft)
{
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "water.vtp", someParticles(10));
    writeParticleFile(folder / "water.vtp", someParticles(20));  // over the one that stands there
    EXPECT_EQ(readParticleFile(folder / "water.vtp").size(), 20u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(VtpFile, AFileCutOffAnywhereIsRefused)
{
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "whole.vtp", someParticles(500));
    const std::string whole = readWholeFile(folder / "whole.vtp");
    for (std::size_t length = 0; length + 1 < whole.size(); length += 1 + whole.size() / 211) {
        writeWholeFile(folder / "cut.vtp", std::string_view(whole).substr(0, length));
        ASSERT_NE(errorOf(folder / "cut.vtp"), "") << length << " of " << whole.size() << " bytes";
    }
    const std::size_t checksum = whole.size() - whole.find("<!-- crc32");  // characters of its line
    for (std::size_t missing = 1; missing < 40; ++missing) {               // within the last tags
        writeWholeFile(folder / "cut.vtp",
                       std::string_view(whole).substr(0, whole.size() - missing));
        const bool allDataThere = missing == checksum || missing == checksum + 1;
        EXPECT_EQ(errorOf(folder / "cut.vtp").empty(), allDataThere) << missing;
    }
}

TEST(VtpFile, OneFlippedBitAnywhereIsRefused)
{
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "whole.vtp", someParticles(500));
    const std::string whole = readWholeFile(folder / "whole.vtp");
    for (std::size_t at = 0; at + 1 < whole.size(); at += 1 + whole.size() / 307) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        writeWholeFile(folder / "damaged.vtp", damaged);
        EXPECT_NE(errorOf(folder / "damaged.vtp"), "") << "byte " << at;
    }
}

TEST(VtpFile, DamageInAFileWithoutChecksumIsNoCrash)
{
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "whole.vtp", someParticles(500));
    std::string whole = readWholeFile(folder / "whole.vtp");
    whole.erase(whole.find("<!-- crc32"));
    writeWholeFile(folder / "foreign.vtp", whole);
    EXPECT_EQ(readParticleFile(folder / "foreign.vtp").size(), 500u);
    std::mt19937 bits(3);
    for (int trial = 0; trial < 300; ++trial) {
        std::string damaged = whole;
        damaged[bits() % damaged.size()] = static_cast<char>(bits());
        writeWholeFile(folder / "damaged.vtp", damaged);
        errorOf(folder / "damaged.vtp");  // an error where VTK sees the damage, never a crash
    }
}

TEST(VtpFile, AMissingFileAFolderAndAnotherKindOfFileAreNamed)
{
    const test::TemporaryFolder folder;
    EXPECT_NE(errorOf(folder / "none.vtp").find("No such file"), std::string::npos);
    EXPECT_NE(errorOf(folder.path()).find("Is a directory"), std::string::npos);
    writeWholeFile(folder / "text.vtp", "FoamFile { }");
    EXPECT_NE(errorOf(folder / "text.vtp").find("no VTK XML poly data"), std::string::npos);
}

TEST(VtpFile, AFieldOfTheWrongLengthIsNotWritten)
{
    const test::TemporaryFolder folder;
    ParticleFile file = someParticles(10);
    file.scalars["p"].pop_back();
    EXPECT_THROW(writeParticleFile(folder / "water.vtp", file), FatalError);
    EXPECT_FALSE(std::filesystem::exists(folder / "water.vtp"));
}

TEST(VtpFile, AFolderThatCannotBeWrittenToIsAnError)
{
    EXPECT_THROW(writeParticleFile("/nonexistent/folder/water.vtp", someParticles(1)),
                 FatalIOError);
}

TEST(VtpFile, AMissingFieldIsNamedWithThoseThatAreThere)
{
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "water.vtp", someParticles(10));
    const ParticleFile file = readParticleFile(folder / "water.vtp");
    EXPECT_EQ(file.number("spacing"), 0.1);
    try {
        file.scalar("porosity");
        FAIL();
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.file(), (folder / "water.vtp").string());
        EXPECT_NE(std::string(error.what()).find("scalar field porosity is missing"),
                  std::string::npos);
        EXPECT_NE(std::string(error.what()).find("    p\n"), std::string::npos);
    }
}

}  // namespace
}  // namespace isph
