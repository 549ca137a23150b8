// A target: clearing, planes, formats and copies as images.
#include <raster/target.h>

#include <gtest/gtest.h>

#include <raster/pipeline.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;

TEST(Target, ItIsBornClear) {
    Target t(3, 2, ColorFormat::rgba8, DepthFormat::unorm24, 2);
    EXPECT_EQ(t.width(), 3);
    EXPECT_EQ(t.height(), 2);
    EXPECT_EQ(t.extra_channels(), 2);
    EXPECT_EQ(t.color8(), std::vector<std::uint32_t>(6, 0));
    EXPECT_EQ(t.depth(), std::vector<std::uint32_t>(6, 0xffffff));
    EXPECT_EQ(t.extra(1), std::vector<float>(6, 0));
    EXPECT_TRUE(t.color_float().empty());
}

TEST(Target, AClearRoundsColoursAsFragmentsAreRounded) {
    Target t(2, 2);
    t.clear({1, 0.5f, -3, 7}, 0.5f);
    EXPECT_EQ(t.color8()[3], 0xff0080ffu);
    EXPECT_EQ(t.depth()[0], 8388608u) << "8388607.5 to even";
    EXPECT_EQ(t.color(1, 1), glm::vec4(1, 128 / 255.0f, 0, 1));
}

TEST(Target, FloatColoursAreKeptAsTheyAre) {
    Target t(2, 2, ColorFormat::rgba_float, DepthFormat::float32);
    t.clear({7, -0.5f, 1e30f, 0.1f}, 0.1f);
    EXPECT_EQ(t.color(1, 0), glm::vec4(7, -0.5f, 1e30f, 0.1f));
    EXPECT_EQ(t.depth(1, 0), 0.1f);
    EXPECT_TRUE(t.color8().empty());
}

TEST(Target, AClearForgetsExtraPlanesToo) {
    Target t(2, 1, ColorFormat::rgba8, DepthFormat::unorm24, 1);
    t.extra(0) = {5, 6};
    t.clear({0, 0, 0, 0});
    EXPECT_EQ(t.extra(0), (std::vector<float>{0, 0}));
}

TEST(Target, WhatIsWrittenIntoAPlaneAfterAClearStays) {
    Target t(2, 1);
    t.clear({1, 1, 1, 1});
    t.color8()[1] = 42;
    EXPECT_EQ(t.color8(), (std::vector<std::uint32_t>{0xffffffffu, 42}));
}

TEST(Target, OfTwoClearsTheLastCounts) {
    Target t(1, 1);
    t.clear({1, 0, 0, 1}, 0);
    t.clear({0, 1, 0, 1}, 1);
    EXPECT_EQ(t.color8()[0], 0xff00ff00u);
    EXPECT_EQ(t.depth()[0], 0xffffffu);
}

TEST(Target, RowsGoDown) {
    const Target t(5, 4);
    EXPECT_EQ(t.index(0, 0), 0u);
    EXPECT_EQ(t.index(4, 0), 4u);
    EXPECT_EQ(t.index(0, 1), 5u);
    EXPECT_EQ(t.index(4, 3), 19u);
}

TEST(Target, ImagesAreCopiesOfThePlanes) {
    Target t(2, 1, ColorFormat::rgba8, DepthFormat::unorm24, 1);
    t.color8() = {0x04030201u, 0x08070605u};
    t.depth() = {0, 0xffffff};
    t.extra(0) = {1.5f, -2.5f};
    const Image8 color = t.color_image();
    EXPECT_EQ(color.channels, 4);
    EXPECT_EQ(color.samples, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(t.color_image_float().samples[5], 6 / 255.0f);
    EXPECT_EQ(t.depth_image().samples, (std::vector<float>{0, 1}));
    EXPECT_EQ(t.extra_image(0).samples, (std::vector<float>{1.5f, -2.5f}));
}

TEST(Target, ImagesOfAClearedTargetShowTheClear) {
    Target t(2, 2);
    t.clear({0, 0, 1, 1}, 0);
    EXPECT_EQ(t.color_image().samples[2], 255);
    t.clear({1, 0, 0, 1}, 0);
    EXPECT_EQ(t.depth_image().samples[3], 0);
    t.clear({0, 1, 0, 1});
    EXPECT_EQ(t.color_image_float().samples[1], 1);
}

TEST(Target, FloatColoursAreClampedAndRoundedInAnEightBitImage) {
    Target t(1, 1, ColorFormat::rgba_float);
    t.clear({2, 0.5f, -1, 1});
    EXPECT_EQ(t.color_image().samples, (std::vector<std::uint8_t>{255, 128, 0, 255}));
    EXPECT_EQ(t.color_image_float().samples, (std::vector<float>{2, 0.5f, -1, 1}));
}

TEST(Target, ACopyIsItsOwn) {
    Target a(2, 2);
    a.clear({1, 1, 1, 1});
    Target b = a;
    b.clear({0, 0, 0, 0});
    EXPECT_EQ(a.color8()[0], 0xffffffffu);
    EXPECT_EQ(b.color8()[0], 0u);
    const Target c = std::move(a);
    EXPECT_EQ(c.color8()[3], 0xffffffffu);
}

TEST(Target, LargeClearsAreWrittenToTheLastPixel) {
    Target t(2000, 1001, ColorFormat::rgba8, DepthFormat::unorm24, 1);
    t.extra(0).assign(t.extra(0).size(), 5);
    t.clear({1, 0, 1, 0});
    EXPECT_EQ(t.color8(), std::vector<std::uint32_t>(2000 * 1001, 0x00ff00ffu));
    EXPECT_EQ(t.extra(0), std::vector<float>(2000 * 1001, 0.0f));
}

/// A rectangle at one depth, in window coordinates of a target of 200 x 100 pixels.
void draw_box(Target& t, float x0, float x1, float ndc_z) {
    const auto corner = [&](float x, float y) {
        raster::testing::Full::Vertex<float> v{};
        v.position = {x / 100 - 1, y / 50 - 1, ndc_z, 1};
        v.color = glm::vec4(1);
        return v;
    };
    const raster::testing::Vertices box = {corner(x0, 0),   corner(x1, 0),   corner(x1, 100),
                                   corner(x1, 100), corner(x0, 100), corner(x0, 0)};
    draw(t, raster::testing::Smooth{}, Mesh{box}, State{});
}

TEST(Target, DepthsOfAClearArriveWhereNothingIsDrawn) {
    Target t(200, 100);
    draw_box(t, 0, 200, -0.5f);
    ASSERT_EQ(t.depth(190, 50), t.depth(10, 50)) << "what the clear has to write over";
    t.clear({0, 0, 0, 0}, 0.75f);
    draw_box(t, 0, 20, 0);
    EXPECT_EQ(t.color8()[t.index(190, 50)], 0u);
    EXPECT_NEAR(t.depth(10, 50), 0.5f, 1e-6f);
    EXPECT_NEAR(t.depth(40, 50), 0.75f, 1e-6f) << "in the box's tile";
    EXPECT_NEAR(t.depth(190, 50), 0.75f, 1e-6f) << "in another one";
    EXPECT_NEAR(t.depth(190, 99), 0.75f, 1e-6f);
}

TEST(Target, LaterDrawsMeetTheDepthsOfAClearThatNobodyLookedAt) {
    Target t(200, 100);
    draw_box(t, 0, 200, -0.5f);
    t.clear({0, 0, 0, 0}, 0.75f);
    draw_box(t, 0, 20, 0);
    draw_box(t, 100, 200, 0.6f);  // hidden by the clear, not by the depths of before
    draw_box(t, 150, 200, 0.2f);
    EXPECT_EQ(t.color8()[t.index(120, 50)], 0u);
    EXPECT_NEAR(t.depth(120, 50), 0.75f, 1e-6f);
    EXPECT_EQ(t.color8()[t.index(170, 50)], 0xffffffffu);
    EXPECT_NEAR(t.depth(170, 50), 0.6f, 1e-6f);
    const Target copy = t;
    EXPECT_EQ(copy.depth(), t.depth());
    t.clear({0, 0, 0, 0}, 0.25f);
    EXPECT_NEAR(t.depth(170, 50), 0.25f, 1e-6f) << "with no draw in between";
}

}  // namespace
