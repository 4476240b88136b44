// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColourMap.hpp"
#include "Overlay.hpp"
#include "Picture.hpp"
#include "Raster.hpp"
#include "core/Error.hpp"
#include "output/TimeFolders.hpp"

#include <cairo.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

namespace isph {
namespace {

TEST(ColourMap, BrightnessOfViridisRisesAllTheWay)
{
    const auto luminance = [](const Colour& c) {
        return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
    };
    for (int k = 0; k < 100; ++k)
        EXPECT_LT(luminance(viridis(k / 100.0)), luminance(viridis((k + 1) / 100.0)));
    EXPECT_EQ(viridis(-1).red, viridis(0).red);
    EXPECT_EQ(viridis(7).red, viridis(1).red);
}

TEST(ColourMap, RangesAreRoundAndForgetASprayingParticle)
{
    std::vector<Real> values;
    for (int k = 0; k < 1000; ++k) values.push_back(0.001 * k);
    values.back() = 50;
    const Range range = roundRange(values, 0.002);
    EXPECT_DOUBLE_EQ(range.low, 0);
    EXPECT_DOUBLE_EQ(range.high, 1);
    const Range equal = roundRange({3, 3, 3}, 0.002);
    EXPECT_LT(equal.low, equal.high);
    EXPECT_LT(roundRange({}, 0.002).low, roundRange({}, 0.002).high);
}

TEST(ColourMap, TicksAreRoundNumbersInTheRange)
{
    std::string text;
    for (const Real tick : roundTicks({-0.01, 0.9}, 5)) text += tickText(tick, 0.2) + " ";
    EXPECT_EQ(text, "0 0.2 0.4 0.6 0.8 ");
    EXPECT_EQ(tickText(2500, 500), "2500");
    EXPECT_EQ(tickText(3e-7, 1e-7), "3e-07");
}

Real coverage(const Raster& raster)
{
    Real sum = 0;
    for (const std::uint32_t pixel : raster.pixels()) sum += static_cast<Real>(pixel >> 24) / 255;
    return sum;
}

TEST(Raster, ADiscCoversItsArea)
{
    Raster raster(50, 40);
    raster.paint({{{25.3, 20.1}}, 12.5, 0, {1, 0, 0}, false});
    // Samples at distance 1/3 pixel miscount at most those within half of that of the edge.
    const Real area = std::numbers::pi * sqr(12.5);
    EXPECT_NEAR(coverage(raster), area, 2 * std::numbers::pi * 12.5 / 6);
}

TEST(Raster, TheNearestIsOnTopInAnyOrderAndTheRestOfThePictureStaysEmpty)
{
    for (const bool nearFirst : {true, false}) {
        Raster raster(20, 20);
        const Disc far{{{10, 10}}, 5, 1, {1, 0, 0}, false},
            near{{{10, 10}}, 5, 2, {0, 0, 1}, false};
        raster.paint(nearFirst ? near : far);
        raster.paint(nearFirst ? far : near);
        EXPECT_EQ(raster.pixels()[10 * 20 + 10], 0xff0000ffU);
        EXPECT_EQ(raster.pixels()[0], 0U);
    }
}

TEST(Raster, DiscsBeyondTheEdgesAreCutOff)
{
    Raster raster(10, 10);
    raster.paint({{{-3, 5}}, 5, 0, {1, 1, 1}, false});
    raster.paint({{{1e9, -1e9}}, 5, 0, {1, 1, 1}, true});
    EXPECT_GT(coverage(raster), 5);
    EXPECT_LT(coverage(raster), 30);
}

/// A folder of its own for each test.
class Snapshot : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::temp_directory_path() /
                  ("isph_snapshot_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }
    /// Two water particles a metre apart in soil's and walls' company, one of them at rest.
    void writeCase() const
    {
        ParticleFile water;
        water.points = {{0, 0, 0}, {1, 0.5, 0}};
        water.vectors["U"] = {{0, 0, 0}, {3, 4, 0}};
        water.scalars["p"] = {1, 2};
        water.scalars["porosity"] = {1, 1};
        water.numbers = {{"dimension", {2}}, {"spacing", {0.1}}};
        ParticleFile walls = water;
        walls.points = {{0.5, 0, 0}, {0.5, 0.5, 0}};
        writeTimeFolder(folder_, {1, "1", 1, 1, 1, {}}, {{"water", water}, {"walls", walls}});
        writeTimeFolder(folder_, {2, "2", 2, 1, 1, {}}, {{"water", water}});
    }
    /// Exit code and, in output_, what it printed.
    int snapshot(const std::string& arguments)
    {
        const std::filesystem::path log = folder_ / "log";
        const std::string command = std::string(SNAPSHOT_PROGRAM) + " -case " + folder_.string() +
                                    " " + arguments + " > " + log.string() + " 2>&1";
        const int status = std::system(command.c_str());
        std::ostringstream text;
        text << std::ifstream(log).rdbuf();
        output_ = text.str();
        return WEXITSTATUS(status);
    }

    std::filesystem::path folder_;
    std::string output_;
};

struct Png {
    explicit Png(const std::filesystem::path& file)
    {
        cairo_surface_t* image = cairo_image_surface_create_from_png(file.c_str());
        width = cairo_image_surface_get_width(image);
        height = cairo_image_surface_get_height(image);
        const int stride = cairo_image_surface_get_stride(image);
        for (int row = 0; row < height; ++row) {
            const auto* line = reinterpret_cast<const std::uint32_t*>(
                cairo_image_surface_get_data(image) + row * stride);
            pixels.insert(pixels.end(), line, line + width);
        }
        cairo_surface_destroy(image);
    }
    /// Pixels of a colour; cairo may round a part of it to either side.
    int count(const Colour& c) const
    {
        const auto same = [](std::uint32_t part, Real v) {
            return std::abs((part & 255U) - 255 * v) <= 1;
        };
        return static_cast<int>(std::count_if(pixels.begin(), pixels.end(), [&](std::uint32_t p) {
            return same(p >> 16, c.red) && same(p >> 8, c.green) && same(p, c.blue);
        }));
    }
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

TEST_F(Snapshot, WaterIsColouredByItsSpeedOnAWhitePage)
{
    writeCase();
    ASSERT_EQ(snapshot("-time 1 -range '0 5' -width 600 -output " + (folder_ / "a.png").string()),
              0)
        << output_;
    const Png picture(folder_ / "a.png");
    EXPECT_EQ(picture.width, 600);
    // A disc of 1.1 x 0.1 m at the scale of a panel of about 470 pixels for 1.1 m: 1700 pixels.
    EXPECT_GT(picture.count(viridis(0)), 1000);          // at rest
    EXPECT_GT(picture.count(viridis(1)), 1000);          // |(3, 4)| = 5 m/s
    EXPECT_GT(picture.count({0.62, 0.62, 0.64}), 2000);  // two wall particles
    EXPECT_GT(picture.count({1, 1, 1}), static_cast<int>(picture.pixels.size()) / 2);
}

TEST_F(Snapshot, AMontageStacksTimesAndSinglePicturesAreNumberedByTime)
{
    writeCase();
    ASSERT_EQ(snapshot("-time 1 -width 400"), 0) << output_;
    const Png single(folder_ / "postProcessing/snapshot/U.png");
    ASSERT_EQ(snapshot("-montage -width 400"), 0) << output_;
    const Png both(folder_ / "postProcessing/snapshot/U.png");
    EXPECT_GT(both.height, 1.6 * single.height);
    ASSERT_EQ(snapshot("-field p -width 400"), 0) << output_;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "postProcessing/snapshot/p_1.png"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "postProcessing/snapshot/p_2.png"));
}

TEST_F(Snapshot, MeasuredPointsAreDrawnAtTheirTimeOnly)
{
    writeCase();
    const std::string overlay =
        "-overlay " + write("m.csv", "# data\nt_s,x_m,z_m\n1,0.2,0.2\n1,0.8,0.3\n").string();
    const Colour red{0.84, 0.10, 0.11};
    ASSERT_EQ(snapshot("-time 1 " + overlay), 0) << output_;
    EXPECT_GT(Png(folder_ / "postProcessing/snapshot/U.png").count(red), 100);
    ASSERT_EQ(snapshot("-time 2 " + overlay), 0) << output_;
    EXPECT_EQ(Png(folder_ / "postProcessing/snapshot/U.png").count(red), 0);
}

TEST_F(Snapshot, MistakesAreNamedAndEndWithOne)
{
    EXPECT_EQ(snapshot(""), 1);
    EXPECT_NE(output_.find("no time folders"), std::string::npos) << output_;
    writeCase();
    const auto fails = [&](const std::string& arguments, const std::string& text) {
        EXPECT_EQ(snapshot(arguments), 1) << arguments;
        EXPECT_NE(output_.find(text), std::string::npos) << output_;
    };
    fails("-field porsity", "did you mean porosity?");
    fails("-field U.q", "a component is .x, .y or .z");
    fails("-range '5 1'", "the lower value comes first");
    fails("-region '0 1 0'", "4 numbers are expected");
    fails("-view up", "x, y or z is expected");
    fails("-overlay /nonexistent.csv", "/nonexistent.csv");
    fails("-overlay " + write("bad.csv", "t,x,z\n1,2,three\n").string(), "bad.csv at line 2");
    fails("-overlay " + write("head.csv", "1,2,3\n").string(), "columns t, x and z");
    fails("-columns 2", "-montage");
    std::ofstream(folder_ / "2/water.vtp") << "cut";
    fails("", "2/water.vtp");
}

TEST_F(Snapshot, ProfilesAreFoundByTimeWithinAThousandthOfTheLongest)
{
    const Overlay overlay(write("m.csv", "z, t [s], x\n1,0.35,3\n4,1.95,6\n7,1.95,9\n"));
    EXPECT_EQ(overlay.at(0.3505).size(), 1u);
    EXPECT_EQ(overlay.at(0.36).size(), 0u);
    const std::vector<Vec<2>> last = overlay.at(1.95);
    ASSERT_EQ(last.size(), 2u);
    EXPECT_EQ(last[1], (Vec<2>{{9, 7}}));
}

}  // namespace
}  // namespace isph
