// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Error.hpp"
#include "kernels/Kernel.hpp"
#include "selection/Libraries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

using namespace isph;

namespace {

/// An environment variable for the time of a test.
class Environment {
public:
    Environment(const char* name, const std::string& value) : name_(name)
    {
        if (const char* old = std::getenv(name)) old_ = old;
        setenv(name, value.c_str(), 1);
    }
    ~Environment() { setenv(name_, old_.c_str(), 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* name_;
    std::string old_;
};

/// The libraries mapped into this process whose names contain `part`.
std::vector<std::string> mapped(const std::string& part)
{
    std::vector<std::string> files;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);)
        if (line.find(part) != std::string::npos) files.push_back(line);
    return files;
}

TEST(Libraries, TheProjectIsTheFolderWithTheGlobalControlDict)
{
    EXPECT_TRUE(std::filesystem::exists(projectDir() / "etc/controlDict"));
}

TEST(Libraries, AWrongProjectFolderIsRefusedByName)
{
    const Environment wrong("ISPH_PROJECT_DIR", "/nowhere/project");
    try {
        projectDir();
        FAIL() << "accepted";
    } catch (const FatalError& error) {
        EXPECT_NE(std::string(error.what()).find("ISPH_PROJECT_DIR is \"/nowhere/project\""),
                  std::string::npos)
            << error.what();
    }
}

TEST(Libraries, AFamilyWithoutBuiltInModelsHasNoLibrary)
{
    const auto before = loadedLibraries();
    EXPECT_NO_THROW(loadFamily("familyOfNobody"));
    EXPECT_EQ(loadedLibraries(), before);
}

TEST(Libraries, OnlyTheModelsOfTheFamilyThatIsAskedForAreMapped)
{
    Kernel::select(Dictionary::parse("kernel wendlandC2;"));
    EXPECT_FALSE(mapped("/libisphKernels.so").empty());
    EXPECT_EQ(std::count(loadedLibraries().begin(), loadedLibraries().end(), "libisphKernels.so"),
              1);
    for (const std::string other :
         {"/libisphPorousModels.so", "/libisphErosionModels.so", "/libisphTurbulenceModels.so"})
        EXPECT_TRUE(mapped(other).empty()) << other;
}

}  // namespace
