// SPDX-License-Identifier: GPL-3.0-or-later
#include "TemporaryFolder.hpp"
#include "output/TimeFolders.hpp"
#include "output/WholeFile.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

namespace isph {
namespace {

ParticleFile particles(std::size_t count)
{
    ParticleFile file;
    for (std::size_t i = 0; i < count; ++i)
        file.points.push_back({0.1 * static_cast<Real>(i), 1, 0});
    file.scalars["p"].assign(count, 3.5);
    return file;
}

TimeState at(Real value, const std::string& name)
{
    return {value, name, 1, 0.05, 0.05, {}};
}

/// (time, part number, name, file) of every data set; fails if a line is anything else.
std::vector<std::array<std::string, 4>> dataSets(const std::filesystem::path& pvd)
{
    const std::regex set(
        "    <DataSet timestep=\"([^\"]*)\" group=\"\" part=\"([0-9]+)\" name=\"([^\"]*)\" "
        "file=\"([^\"]*)\"/>");
    std::vector<std::array<std::string, 4>> found;
    std::vector<std::string> other;
    std::ifstream in(pvd);
    for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (std::regex_match(line, match, set))
            found.push_back({match[1], match[2], match[3], match[4]});
        else
            other.push_back(line);
    }
    EXPECT_EQ(other,
              (std::vector<std::string>{
                  "<?xml version=\"1.0\"?>",
                  "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">",
                  "  <Collection>", "  </Collection>", "</VTKFile>"}));
    return found;
}

std::vector<std::string> entriesOf(const std::filesystem::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(TimeFolders, AFolderIsReadAsItWasWritten)
{
    const test::TemporaryFolder folder;
    const ParticleFile water = particles(7), walls = particles(3);
    TimeFolderWriter(folder.path())
        .write(at(0.15000000000000002, "0.15"), {{"water", water}, {"walls", walls}});
    const std::vector<TimeFolder> times = timeFolders(folder.path());
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(readTimeState(times[0]).value, 0.15000000000000002);
    const auto parts = readTimeFolder(times[0]);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts.at("water").points, water.points);
    EXPECT_EQ(parts.at("walls").scalars, walls.scalars);
    EXPECT_EQ(entriesOf(folder.path()),
              (std::vector<std::string>{"0.15", pvdFile(folder.path()).filename().string()}));
}

TEST(TimeFolders, ThePvdHoldsEveryPartOfEveryTimeThatExists)
{
    const test::TemporaryFolder folder;
    const ParticleFile some = particles(2);
    TimeFolderWriter writer(folder.path());
    writer.write(at(10, "10"), {{"water", some}, {"walls", some}, {"soil", some}});
    writer.write(at(2, "2"), {{"water", some}, {"walls", some}});
    EXPECT_EQ(pvdFile(folder.path()).filename(), folder.path().filename().string() + ".pvd");
    using Row = std::array<std::string, 4>;
    EXPECT_EQ(dataSets(pvdFile(folder.path())),
              (std::vector<Row>{
                  Row{"2", "0", "water", "2/water.vtp"}, Row{"2", "1", "walls", "2/walls.vtp"},
                  Row{"10", "0", "water", "10/water.vtp"}, Row{"10", "1", "walls", "10/walls.vtp"},
                  Row{"10", "2", "soil", "10/soil.vtp"}}));
    std::filesystem::remove_all(folder / "10");  // by the user
    writePvd(folder.path());
    EXPECT_EQ(dataSets(pvdFile(folder.path())).size(), 2u);
}

TEST(TimeFolders, PurgeKeepsTheLatestOfThisRunAndWhatWasThereBefore)
{
    const test::TemporaryFolder folder;
    const ParticleFile some = particles(2);
    writeTimeFolder(folder.path(), at(0, "0"), {{"water", some}});
    TimeFolderWriter writer(folder.path());
    for (const char* name : {"1", "2", "3", "4"})
        writer.write(at(std::stod(name), name), {{"water", some}}, 2);
    std::string names;
    for (const TimeFolder& time : timeFolders(folder.path())) names += time.name + " ";
    EXPECT_EQ(names, "0 3 4 ");
    EXPECT_EQ(dataSets(pvdFile(folder.path())).size(), 3u);
}

TEST(TimeFolders, ARunThatWasKilledLeavesNothingHalfWritten)
{
    const test::TemporaryFolder folder;
    const ParticleFile some = particles(2);
    std::filesystem::create_directories(folder / ".0.5.part");  // as a killed run leaves it
    std::ofstream(folder / ".0.5.part/water.vtp") << "half";
    EXPECT_TRUE(timeFolders(folder.path()).empty());
    TimeFolderWriter writer(folder.path());
    EXPECT_TRUE(entriesOf(folder.path()).empty());
    ParticleFile broken = some;
    broken.scalars["p"].clear();  // fails in the middle of the folder
    EXPECT_THROW(writer.write(at(1, "1"), {{"soil", some}, {"water", broken}}), FatalError);
    EXPECT_TRUE(timeFolders(folder.path()).empty());
}

TEST(TimeFolders, WritingOverATimeReplacesItsFolder)
{
    const test::TemporaryFolder folder;
    const ParticleFile first = particles(2), second = particles(5);
    TimeFolderWriter writer(folder.path());
    writer.write(at(1, "1"), {{"water", first}, {"soil", first}}, 1);
    writer.write(at(1, "1"), {{"water", second}}, 1);
    const auto parts = readTimeFolder(timeFolders(folder.path()).at(0));
    EXPECT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts.at("water").size(), 5u);
}

TEST(TimeFolders, AMissingOrCutOffPartIsNamed)
{
    const test::TemporaryFolder folder;
    const ParticleFile some = particles(200);
    writeTimeFolder(folder.path(), at(1, "1"), {{"water", some}, {"walls", some}});
    const TimeFolder time = timeFolders(folder.path()).at(0);
    const auto error = [&] {
        try {
            readTimeFolder(time);
        } catch (const FatalIOError& thrown) {
            return thrown.file() + ": " + thrown.what();
        }
        return std::string();
    };
    const std::string whole = readWholeFile(folder / "1/water.vtp");
    writeWholeFile(folder / "1/water.vtp", whole.substr(0, whole.size() / 2));
    EXPECT_NE(error().find("1/water.vtp: the file is cut off"), std::string::npos) << error();
    std::filesystem::remove(folder / "1/water.vtp");
    EXPECT_NE(error().find("water.vtp is missing"), std::string::npos) << error();
    std::filesystem::remove_all(folder / "1/uniform");
    EXPECT_NE(error().find("uniform/time is missing"), std::string::npos) << error();
}

TEST(TimeFolders, AFolderThatCannotBeWrittenIsAnError)
{
    EXPECT_THROW(writeTimeFolder("/proc", at(1, "1"), {}), FatalIOError);
}

}  // namespace
}  // namespace isph
