// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilledScene.hpp"

using namespace isph;
using namespace isph::test;

namespace {

/// The place and the message of the error that filling the scene raises.
std::pair<int, std::string> refusal(const std::string& text)
{
    try {
        const FilledScene s(text);
    } catch (const FatalIOError& error) {
        return {error.line(), error.what()};
    }
    return {0, "no error"};
}

}  // namespace

TEST(Refusals, WaterInAWallNamesBoth)
{
    const auto [line, message] =
        refusal(tank("0.01", "\nwater {\n " + box("flood", "0 0 0", "1.02 0.2 0") + " }"));
    EXPECT_EQ(line, 3) << message;
    EXPECT_TRUE(contains(message, "flood")) << message;
    // a sliver that holds no particle is found as well
    const std::string block =
        "walls { block " + std::string("{ type box; min (0.4 0 0); max (0.5 0.3 0); } }");
    const std::string text = "spacing 0.01; dimension 2; domain { min (0 0 0); max (1 0.6 0); } " +
                             block + "water { " + box("left", "0 0 0", "0.403 0.2 0") + " }";
    EXPECT_TRUE(contains(refusal(text).second, "overlaps the wall block")) << refusal(text).second;
}

TEST(Refusals, ATankWrittenAsASolidBoxTellsHowToTurnItRound)
{
    const std::string text =
        "spacing 0.01; dimension 2; domain { min (0 0 0); max (1 0.6 0); }"
        "walls { tank { type box; min (0 0 0); max (1 0.6 0); } }"
        "water { " +
        box("w", "0 0 0", "1 0.2 0") + " }";
    EXPECT_TRUE(contains(refusal(text).second, "fluid inside")) << refusal(text).second;
}

TEST(Refusals, WaterOutsideTheDomainGivesTheDomain)
{
    const std::string text =
        "spacing 0.01; dimension 2; domain { min (0 0 0); max (1 0.6 0); }\n"
        "water { " +
        box("w", "0 0 0", "1 0.604 0") + " }";
    const auto [line, message] = refusal(text);
    EXPECT_EQ(line, 2) << message;
    EXPECT_TRUE(contains(message, "outside the domain")) << message;
}

TEST(Refusals, ARegionTooSmallForAParticleAndOneThatIsCovered)
{
    EXPECT_TRUE(contains(
        refusal(tank("0.01", "water { " + box("w", "0 0 0", "0.004 0.004 0") + " }")).second,
        "no room"));
    EXPECT_TRUE(contains(refusal(tank("0.01", "water { " + box("a", "0 0 0", "1 0.2 0") +
                                                  box("b", "0 0 0", "0.5 0.1 0") + " }"))
                             .second,
                         "no room"));
}

TEST(Refusals, SoilOfAnUnknownZoneNamesTheNearest)
{
    const auto [line, message] =
        refusal(tank("0.01", "soil {\n" + box("bed", "0 0 0", "1 0.1 0", "zone sannd;") +
                                 " } water { " + box("w", "0 0 0", "1 0.2 0") + " }"));
    EXPECT_EQ(line, 2) << message;
    EXPECT_TRUE(contains(message, "did you mean sand?")) << message;
}

TEST(Refusals, ADomainWithoutExtentAndASpacingBeyondIt)
{
    EXPECT_TRUE(contains(
        refusal("spacing 0.01; dimension 2; domain { min (0 0 0); max (1 0 0); } water {}").second,
        "no extent along y"));
    EXPECT_TRUE(contains(
        refusal("spacing 2; dimension 2; domain { min (0 0 0); max (1 1 0); } water {}").second,
        "spacing 2 m is more"));
}
