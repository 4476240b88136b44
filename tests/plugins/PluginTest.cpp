// SPDX-License-Identifier: GPL-3.0-or-later
#include "porous/PorousModel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

using namespace isph;

namespace {

[[maybe_unused]] const int pathIsSet = setenv("ISPH_LIBRARY_PATH", "/nowhere:" ISPH_OUTSIDE, 1);

std::unique_ptr<PorousModel> zone(const std::string& text)
{
    return PorousModel::select(Dictionary::parse(text, "porousZones"));
}

/// The message of the error with which a library is refused.
std::string refusal(const std::string& library)
{
    try {
        loadLibrary(library);
    } catch (const FatalError& error) {
        return error.what();
    }
    return "";
}

void expectPart(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in:\n" << text;
}

bool offered(const std::string& name)
{
    const auto names = PorousModel::table().names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Plugin, AModelOfALibraryOutsideTheTreeIsSelectedByName)
{
    loadLibrary("libQuadraticDrag.so");
    const auto model =
        zone("porousModel quadraticDrag; quadraticDragCoeffs { porosity 0.4; b 7; }");
    EXPECT_EQ(model->porosity(), 0.4);
    EXPECT_EQ(model->resistance(0.4, 1e-6).quadratic, 7);
    EXPECT_TRUE(offered("quadraticDrag"));
    EXPECT_TRUE(offered("akbari"));
}

TEST(Plugin, ItsKeysAreCheckedAsThoseOfBuiltInModels)
{
    loadLibrary("libQuadraticDrag.so");
    try {
        zone("porousModel quadraticDrag;\nquadraticDragCoeffs\n{\n    porosity 0.4;\n    bb 7;\n}");
        FAIL() << "accepted";
    } catch (const FatalIOError& error) {
        EXPECT_EQ(error.line(), 5);
        expectPart(error.what(), "bb");
    }
}

TEST(Plugin, IsFoundByItsPathAndLoadedOnce)
{
    const std::string path = ISPH_OUTSIDE "/libQuadraticDrag.so";
    loadLibrary(path);
    loadLibrary(path);
    EXPECT_EQ(std::count(loadedLibraries().begin(), loadedLibraries().end(), path), 1);
}

TEST(Plugin, ClassesOfTheSameNameInTwoLibrariesStayApart)
{
    loadLibrary("libQuadraticDrag.so");
    loadLibrary("libTwinDrag.so");
    const auto one = zone("porousModel quadraticDrag; quadraticDragCoeffs { porosity 0.4; b 7; }");
    const auto two = zone("porousModel twinDrag; twinDragCoeffs { porosity 0.4; b 7; }");
    EXPECT_EQ(one->resistance(0.4, 1e-6).quadratic, 7);
    EXPECT_EQ(two->resistance(0.4, 1e-6).quadratic, 14);
}

TEST(Plugin, ANameThatIsTakenIsRefusedWithBothLibraries)
{
    ASSERT_TRUE(offered("ergun"));
    for (int attempt = 0; attempt < 2; ++attempt) {
        const std::string text = refusal("libSecondErgun.so");
        expectPart(text, "Library \"libSecondErgun.so\" cannot be used");
        expectPart(text, "porousModel ergun is registered already, by ");
        expectPart(text, "libisphPorousModels.so");
    }
    // The first one stays.
    EXPECT_GT(zone("porousModel ergun; ergunCoeffs { porosity 0.4; D50 0.01; }")
                  ->resistance(0.4, 1e-6)
                  .linear,
              0);
}

TEST(Plugin, AnotherInterfaceVersionIsRefused)
{
    const std::string text = refusal("libOldInterface.so");
    expectPart(text, "porousModel oldDrag was built for interface version ");
    expectPart(text, "build the library again");
    EXPECT_FALSE(offered("oldDrag"));
}

TEST(Plugin, AMissingSymbolIsAnErrorWhenTheLibraryIsLoaded)
{
    const std::string text = refusal("libMissingSymbol.so");
    expectPart(text, "could not be loaded");
    expectPart(text, "forgottenFunction");
}

TEST(Plugin, AMissingLibraryTellsWhereItWasSought)
{
    const std::string text = refusal("libNowhere.so");
    expectPart(text, "Library \"libNowhere.so\" not found");
    expectPart(text, "    " ISPH_OUTSIDE "/libNowhere.so\n");
    expectPart(text, "/lib/libNowhere.so\n");
    expectPart(text, "on the system's paths");
    expectPart(text, "ISPH_LIBRARY_PATH");

    const std::string path = refusal("/nowhere/libNowhere.so");
    expectPart(path, "    /nowhere/libNowhere.so\n");
    EXPECT_EQ(path.find("system's paths"), std::string::npos) << path;
}

TEST(Plugin, AFileThatIsNoLibraryIsRefusedWithTheLoadersWords)
{
    const std::string path = ISPH_OUTSIDE "/noLibrary.so";
    std::ofstream(path) << "text\n";
    const std::string text = refusal(path);
    expectPart(text, "could not be loaded");
    expectPart(text, "file too short");
}

TEST(Plugin, AnUnknownTypeListsTheModelsOfPluginsToo)
{
    loadLibrary("libQuadraticDrag.so");
    try {
        zone("porousModel quadraticDrg; quadraticDrgCoeffs {}");
        FAIL() << "accepted";
    } catch (const FatalIOError& error) {
        expectPart(error.what(),
                   "Unknown porousModel type quadraticDrg, did you mean quadraticDrag?");
        expectPart(error.what(), "    ergun\n");
        expectPart(error.what(), "    quadraticDrag\n");
    }
}

}  // namespace
