// Stage 4: the divide, the viewport, and the snap to the subpixel grid.
#include <raster/stages/project.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace {

using namespace raster;
using raster::testing::Random;

TEST(Project, TheVolumesCornersAreTheViewportsCorners) {
    const ViewportTransform t(Viewport{0, 0, 640, 480});
    const auto top_left = project(glm::vec4(-1, 1, -1, 1), t);
    EXPECT_EQ(top_left.x, 0);
    EXPECT_EQ(top_left.y, 0);
    EXPECT_EQ(top_left.z, 0);
    const auto bottom_right = project(glm::vec4(2, -2, 2, 2), t);
    EXPECT_EQ(bottom_right.x, 640);
    EXPECT_EQ(bottom_right.y, 480);
    EXPECT_EQ(bottom_right.z, 1);
    EXPECT_EQ(bottom_right.oow, 0.5f);
    const auto centre = project(glm::vec4(0, 0, 0, 5), t);
    EXPECT_EQ(centre.x, 320);
    EXPECT_EQ(centre.y, 240);
    EXPECT_EQ(centre.z, 0.5f);
}

TEST(Project, AViewportMovesAndADepthRangeScales) {
    const ViewportTransform t(Viewport{-10, 20, 100, 50, 0.25f, 0.75f});
    const auto p = project(glm::vec4(1, 1, 1, 1), t);
    EXPECT_EQ(p.x, 90);
    EXPECT_EQ(p.y, 20);
    EXPECT_EQ(p.z, 0.75f);
    EXPECT_EQ(project(glm::vec4(-1, -1, -1, 1), t).z, 0.25f);
    const ViewportTransform reversed(Viewport{0, 0, 10, 10, 1, 0});
    EXPECT_EQ(project(glm::vec4(0, 0, -1, 1), reversed).z, 1);
}

TEST(Project, AViewportWithoutAWidthIsTheWholeTarget) {
    Viewport v = effective_viewport({7, 8, 0, 0, 0.1f, 0.2f}, 30, 40);
    EXPECT_EQ(v.x, 0);
    EXPECT_EQ(v.y, 0);
    EXPECT_EQ(v.width, 30);
    EXPECT_EQ(v.height, 40);
    EXPECT_EQ(v.near_depth, 0.1f);
    EXPECT_EQ(v.far_depth, 0.2f);
    v = effective_viewport({7, 8, 9, 10}, 30, 40);
    EXPECT_EQ(v.x, 7);
    EXPECT_EQ(v.width, 9);
}

TEST(Project, ViewportsThatFixedPointCannotHoldAreNotValid) {
    constexpr int most = 2147483647, least = -most - 1;
    EXPECT_TRUE(is_valid({0, 0, 1, 1}));
    EXPECT_TRUE(is_valid({-16384, -16384, 32768, 32768}));
    EXPECT_TRUE(is_valid({16383, 16383, 1, 1}));
    for (const auto& [start, size] : {std::pair{0, 0},
                                      {0, -1},
                                      {-16385, 10},
                                      {16384, 1},
                                      {1, 16384},
                                      {-16384, 32769},
                                      {least, most},
                                      {most, most},
                                      {least, 10},
                                      {0, most},
                                      {most, 1}}) {
        EXPECT_FALSE(is_valid({start, 0, size, 1})) << start << " " << size;
        EXPECT_FALSE(is_valid({0, start, 1, size})) << start << " " << size;
    }
}

TEST(Project, PixelCentresAreMultiplesOf256) {
    EXPECT_EQ(snap(0.5f), 0);
    EXPECT_EQ(snap(1.5f), 256);
    EXPECT_EQ(snap(100.5f), 25600);
    EXPECT_EQ(snap(-0.5f), -256);
    EXPECT_EQ(snap(0.0f), -128);
}

TEST(Project, SnappingRoundsHalvesToEven) {
    const auto at = [](int half_subpixels) { return snap(0.5f + float(half_subpixels) / 512.0f); };
    EXPECT_EQ(at(1), 0);
    EXPECT_EQ(at(3), 2);
    EXPECT_EQ(at(5), 2);
    EXPECT_EQ(at(7), 4);
    EXPECT_EQ(at(-1), 0);
    EXPECT_EQ(at(-3), -2);
    for (int i = -4000; i <= 4000; ++i) EXPECT_EQ(at(i), int(std::nearbyint(i / 2.0)));
}

TEST(Project, SnappingMovesByAtMostHalfASubpixel) {
    Random random(1);
    for (int round = 0; round < 100000; ++round) {
        const float x = random.uniform(-16384, 16384);
        ASSERT_LE(std::abs(double(snap(x)) / 256 + 0.5 - double(x)), 0.5 / 256 + 1e-3 * std::abs(double(x)) / 16384);
        ASSERT_LE(std::abs(snap(x)), 16385 * 256);
    }
}

TEST(Project, SnappingKeepsOrder) {
    Random random(2);
    for (int round = 0; round < 100000; ++round) {
        const float x = random.uniform(-100, 100), y = x + random.uniform(0, 0.02f);
        ASSERT_LE(snap(x), snap(y));
    }
}

TEST(Project, LanesProjectAndSnapAsScalars) {
    using F = FloatPack<8>;
    Random random(3);
    for (int round = 0; round < 500; ++round) {
        const int x = random.integer(-50, 50), width = random.integer(1, 2000);
        const ViewportTransform t(Viewport{x, 3, width, random.integer(1, 2000), 0.1f, random.uniform(0, 1)});
        vec<4, F> pack;
        glm::vec4 scalars[8];
        for (int l = 0; l < 8; ++l) {
            scalars[l] = make_triangle(raster::testing::Group::perspective, random, 100, 100)[0];
            for (int i = 0; i < 4; ++i) pack[i].v[l] = scalars[l][i];
        }
        const WindowVertex<F> window = project(pack, t);
        const SubpixelVertex<F> snapped = snap(window);
        for (int l = 0; l < 8; ++l) {
            const auto one = project(scalars[l], t);
            ASSERT_EQ(lane(window.x, l), one.x);
            ASSERT_EQ(lane(window.y, l), one.y);
            ASSERT_EQ(lane(window.z, l), one.z);
            ASSERT_EQ(lane(window.oow, l), one.oow);
            ASSERT_EQ(lane(snapped.x, l), snap(one).x);
            ASSERT_EQ(lane(snapped.y, l), snap(one).y);
        }
    }
}

}  // namespace
