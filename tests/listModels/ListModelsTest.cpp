// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

using namespace isph;
namespace fs = std::filesystem;

namespace {

struct Outcome {
    std::string text;  ///< of stdout and stderr
    int exitCode;
};

Outcome run(const std::string& options)
{
    Outcome outcome{"", -1};
    FILE* pipe = popen((ISPH_LIST_MODELS " " + options + " 2>&1").c_str(), "r");
    char part[4096];
    while (std::fgets(part, sizeof part, pipe) != nullptr) outcome.text += part;
    outcome.exitCode = WEXITSTATUS(pclose(pipe));
    return outcome;
}

std::string contentOf(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

void expectPart(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in:\n" << text;
}

TEST(ListModels, FamiliesAndModelsAreListedAsOpenFOAMListsThem)
{
    const Outcome all = run("");
    EXPECT_EQ(all.exitCode, 0) << all.text;
    expectPart(all.text, "Valid kernel types are:\n\n4\n(\n    cubicSpline\n    quinticSpline\n");
    expectPart(all.text, "Valid porousModel types are:\n\n6\n(\n    akbari\n");
    expectPart(all.text, "Valid erosionModel types are:\n\n1\n(\n    thresholdVelocity\n)\n");
    const Outcome one = run("-family turbulenceModel");
    EXPECT_EQ(one.text,
              "Valid turbulenceModel types are:\n\n2\n(\n    Smagorinsky\n    laminar\n)\n\n");
}

TEST(ListModels, ScriptsGetTheNamesAlone)
{
    EXPECT_EQ(run("-family kernel -names").text,
              "cubicSpline\nquinticSpline\nwendlandC2\nwendlandC4\n");
}

TEST(ListModels, TheKeysOfAModelComeWithDefaultDimensionsAndRange)
{
    const Outcome keys = run("-keys akbari");
    EXPECT_EQ(keys.exitCode, 0) << keys.text;
    for (const std::string part :
         {"// porousModel akbari\n", "porosity", "> 0 and < 1", "D50", "[0 1 0 0 0 0 0]",
          "alphaC          1000;", "betaC           1.1;"})
        expectPart(keys.text, part);
}

TEST(ListModels, AnUnknownModelOrFamilyEndsWithTheValidOnes)
{
    const Outcome model = run("-keys akbary");
    EXPECT_EQ(model.exitCode, 1);
    expectPart(model.text, "--> FOAM FATAL ERROR:\nUnknown model akbary, did you mean akbari?");
    const Outcome family = run("-family porous");
    EXPECT_EQ(family.exitCode, 1);
    expectPart(family.text, "    porousModel\n");
}

TEST(ListModels, TheAnnotatedDictionariesOfTheProjectAreThoseOfTheModels)
{
    const fs::path fresh = fs::temp_directory_path() / ("annotated" + std::to_string(getpid()));
    const Outcome outcome = run("-annotated " + fresh.string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.text;
    int files = 0;
    for (const auto& file : fs::directory_iterator(fresh)) {
        const fs::path kept =
            fs::path(ISPH_SOURCE_DIR) / "etc/caseDicts/annotated" / file.path().filename();
        EXPECT_EQ(contentOf(kept), contentOf(file.path()))
            << kept << " is out of date: isphListModels -annotated etc/caseDicts/annotated";
        EXPECT_NO_THROW(Dictionary::read(file.path()));
        ++files;
    }
    EXPECT_EQ(files, 4);
    fs::remove_all(fresh);
}

}  // namespace
