// The library against OSMesa at work: not a bit of colour or depth may differ.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>
#include <raster/stages/blend.h>

#include "catalogue.h"
#include "options.h"
#include "osmesa.h"

namespace {

using namespace raster::conformance;

class Exact : public testing::TestWithParam<Kind> {};

TEST_P(Exact, NotOnePixelDiffers) {
    int drawn = 0;
    for (int i = 0; i < options.scenes; ++i) {
        const std::uint64_t seed = options.seed * 1000 + std::uint64_t(i);
        const Scene scene = GetParam().make(seed);
        const Picture theirs = Oracle::instance().render(scene);
        for (const Path path : {Path::fast, Path::observed}) {
            // One pixel after the other takes long; it is checked against the fast draw elsewhere, too.
            if (path == Path::observed && i % 4 != 0) continue;
            const Difference difference = compare(render(scene, path), theirs);
            ASSERT_TRUE(difference.none()) << "seed " << seed << ", " << scene.width << " x " << scene.height << ": "
                                           << describe(difference, scene.width);
        }
        drawn += theirs.color != std::vector<std::uint32_t>(theirs.color.size(), theirs.color[0]);
    }
    const bool draws = GetParam().name != "clear" && GetParam().name != "cull_both" && GetParam().name != "collinear";
    EXPECT_TRUE(drawn > 0 || !draws) << "all pictures are empty";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Exact, testing::ValuesIn(exact_kinds()),
                         [](const auto& info) { return info.param.name; });

class Close : public testing::TestWithParam<Kind> {};

TEST_P(Close, ColoursDifferByAtMostOne) {
    int largest = 0;
    std::size_t different = 0, pixels = 0;
    for (int i = 0; i < options.scenes; ++i) {
        const Scene scene = GetParam().make(options.seed * 1000 + std::uint64_t(i));
        const Difference difference = compare(render(scene, Path::fast), Oracle::instance().render(scene));
        EXPECT_EQ(difference.depth_pixels, 0u);
        largest = std::max(largest, difference.largest);
        different += difference.color_pixels;
        pixels += std::size_t(scene.width) * std::size_t(scene.height);
    }
    std::printf("%s: at most %d/255, %zu of %zu pixels\n", GetParam().name.c_str(), largest, different, pixels);
    EXPECT_LE(largest, 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Close, testing::ValuesIn(close_kinds()),
                         [](const auto& info) { return info.param.name; });

TEST(Fans, EveryPixelIsDrawnOnceByBoth) {
    const auto& kinds = exact_kinds();
    const auto fans = std::find_if(kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.name == "fans"; });
    int drawn = 0;
    for (int i = 0; i < options.scenes; ++i) {
        Scene scene = fans->make(options.seed * 1000 + std::uint64_t(i));
        scene.clear_color = glm::vec4(0);
        const std::vector<Draw> draws = scene.draws;
        for (const Draw& fan : draws) {
            scene.draws = {fan};
            const Picture theirs = Oracle::instance().render(scene);
            EXPECT_EQ(render(scene, Path::fast), theirs);
            const std::uint32_t once = std::uint32_t(raster::pack_rgba8(fan.vertices[0].color));
            for (const std::uint32_t color : theirs.color) {
                ASSERT_TRUE(color == 0 || color == once) << std::hex << color;
                drawn += color != 0;
            }
        }
    }
    EXPECT_GT(drawn, 0);
}

}  // namespace
