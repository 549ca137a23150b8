// diff_flip_test.cpp: FLIP against a second implementation, straight from the paper: direct 2D filters in double.
#include <raster/image/flip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#if !defined(RASTER_NO_THREADS)
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <raster/image/diff.h>
#include <raster/image/diff_picture.h>
#include <raster/testing/matchers.h>

#include "flip_paper.h"
#include "random.h"

namespace {

using raster::AnyImage;
using raster::DifferingCells;
using raster::flip_map;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::mean_of;
using raster::testing::Random;
using namespace raster::testing::flip_paper;

// ------------------------------------------------------------------------------------------------ pictures

Image8 constant(int width, int height, std::array<int, 3> color) {
    Image8 image(width, height, 3);
    for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = std::uint8_t(color[i % 3]);
    return image;
}

/// Rectangles and single pixels of any colour.
Image8 scribble(Random& random, Image8 image, int count) {
    for (int n = 0; n < count; ++n) {
        const int x0 = random.integer(0, image.width - 1), y0 = random.integer(0, image.height - 1);
        const int x1 = std::min(x0 + random.integer(1, 12), image.width),
                  y1 = std::min(y0 + random.integer(1, 9), image.height);
        const std::array<int, 3> color = {random.integer(0, 255), random.integer(0, 255), random.integer(0, 255)};
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::uint8_t(color[std::size_t(c)]);
    }
    return image;
}

DifferingCells cells_of(const AnyImage& a, const AnyImage& b) {
    return std::visit(
        [&]<class T>(const raster::Image<T>& held) {
            return DifferingCells(raster::plain_metrics(held, std::get<raster::Image<T>>(b), 1).deltas);
        },
        a);
}

ImageF map_of(const AnyImage& a, const AnyImage& b, float ppd = raster::default_pixels_per_degree) {
    return flip_map(a, b, cells_of(a, b), ppd);
}

void expect_as_in_the_paper(const Image8& a, const Image8& b, float ppd) {
    const ImageF map = map_of(a, b, ppd);
    const Plane expected = flip_by_the_paper(linear(a), linear(b), double(ppd));
    double mean = 0, worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        mean += expected[i] / double(expected.size());
        worst = std::max(worst, std::abs(expected[i] - double(map.samples[i])));
    }
    EXPECT_NEAR(mean_of(map), mean, 1e-5);
    EXPECT_LT(worst, 2e-4);
}

// -------------------------------------------------------------------------------------------------- the tests

TEST(Flip, IsWhatThePaperSaysAtEveryPixel) {
    Random random(20);
    for (const auto& [width, height] : {std::pair(40, 30), {70, 5}, {1, 1}, {3, 50}, {33, 33}}) {
        const Image8 a = scribble(random, constant(width, height, {90, 120, 200}), 12);
        expect_as_in_the_paper(a, scribble(random, a, 4), raster::default_pixels_per_degree);
    }
}

TEST(Flip, IsWhatThePaperSaysAtOtherDistances) {
    Random random(21);
    const Image8 a = scribble(random, constant(30, 24, {10, 20, 30}), 9), b = scribble(random, a, 3);
    for (const float ppd : {8.0f, 20.0f, 40.5f, 110.0f}) expect_as_in_the_paper(a, b, ppd);
}

TEST(Flip, TilesMeetWithoutASeam) {
    Random random(22);
    // Tiles are 256 x 128; the differences lie where four of them meet. What the last rows and columns see ends 10
    // pixels before them, so that a part of the picture is enough for the slow way.
    const Image8 a = scribble(random, constant(275, 140, {128, 128, 128}), 200);
    Image8 b = a;
    for (int y = 124; y < 132; ++y)
        for (int x = 250; x < 262; ++x) b.pixel(x, y)[1] ^= 0x70;
    constexpr int left = 230, top = 105, margin = 10;
    const auto corner = [](const Image8& image) {
        Image8 part(image.width - left, image.height - top, 3);
        for (int y = 0; y < part.height; ++y) std::copy_n(image.pixel(left, top + y), 3 * part.width, part.pixel(0, y));
        return part;
    };
    const ImageF map = map_of(a, b);
    const Plane expected =
        flip_by_the_paper(linear(corner(a)), linear(corner(b)), double(raster::default_pixels_per_degree));
    for (int y = margin; y < 140 - top; ++y)
        for (int x = margin; x < 275 - left; ++x)
            EXPECT_NEAR(*map.pixel(left + x, top + y), expected[std::size_t(y * (275 - left) + x)], 2e-4);
}

TEST(Flip, GreenAgainstBlueIsOneByDefinition) {
    for (const float error : map_of(constant(9, 9, {0, 255, 0}), constant(9, 9, {0, 0, 255})).samples)
        EXPECT_NEAR(error, 1.0f, 1e-5f);
}

TEST(Flip, BlackAgainstWhiteIsLightnessAlone) {
    // Distance 100, past the knee; the largest is the distance from green to blue.
    const double largest = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    for (const float error : map_of(constant(5, 7, {0, 0, 0}), constant(5, 7, {255, 255, 255})).samples)
        EXPECT_NEAR(error, expected, 1e-5);
}

TEST(Flip, EqualPicturesHaveNoError) {
    Random random(23);
    const Image8 a = scribble(random, constant(64, 48, {1, 2, 3}), 30);
    for (const float error : map_of(a, a).samples) EXPECT_EQ(error, 0.0f);
}

TEST(Flip, FarFromADifferenceThereIsNone) {
    const Image8 a = constant(600, 40, {100, 100, 100});
    Image8 b = a;
    b.pixel(3, 20)[0] = 255;
    const ImageF map = map_of(a, b);
    EXPECT_GT(*map.pixel(3, 20), 0.05f);
    for (int x = 3 + 11; x < 600; ++x) EXPECT_EQ(*map.pixel(x, 20), 0.0f) << x;
}

TEST(Flip, ExchangingThePicturesChangesNothing) {
    Random random(24);
    const Image8 a = scribble(random, constant(50, 40, {60, 60, 60}), 10), b = scribble(random, a, 5);
    EXPECT_EQ(map_of(a, b), map_of(b, a));
}

TEST(Flip, SixteenBitsThatHoldEightGiveTheSame) {
    Random random(25);
    const Image8 a = scribble(random, constant(31, 17, {60, 60, 60}), 10), b = scribble(random, a, 5);
    const auto widen = [](const Image8& image) {
        Image16 wide(image.width, image.height, 3);
        for (std::size_t i = 0; i < image.samples.size(); ++i) wide.samples[i] = std::uint16_t(image.samples[i] * 257);
        return wide;
    };
    const ImageF eight = map_of(a, b), sixteen = map_of(widen(a), widen(b));
    for (std::size_t i = 0; i < eight.samples.size(); ++i) EXPECT_NEAR(eight.samples[i], sixteen.samples[i], 1e-5f);
}

TEST(Flip, FloatsAreLinearLight) {
    Random random(26);
    const Image8 a = scribble(random, constant(31, 17, {60, 60, 60}), 10), b = scribble(random, a, 5);
    const auto to_float = [](const Image8& image) {
        ImageF light(image.width, image.height, 3);
        for (std::size_t i = 0; i < image.samples.size(); ++i)
            light.samples[i] = float(linear_from_srgb(image.samples[i] / 255.0));
        return light;
    };
    const ImageF eight = map_of(a, b), floats = map_of(to_float(a), to_float(b));
    for (std::size_t i = 0; i < eight.samples.size(); ++i) EXPECT_NEAR(eight.samples[i], floats.samples[i], 1e-4f);
}

TEST(FlipMean, HasTheBitsOfTheMapsMeanAndItsSteps) {
    Random random(28);
    for (const auto& [width, height] : {std::pair(700, 150), {3, 5}, {193, 70}, {1, 1}, {384, 9}}) {
        const Image8 a = scribble(random, constant(width, height, {60, 60, 60}), 40), b = scribble(random, a, 25);
        if (a == b) continue;
        const ImageF map = map_of(a, b);
        Image8 steps;
        const std::optional<double> mean =
            raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree, &steps);
        ASSERT_TRUE(mean);
        EXPECT_EQ(*mean, mean_of(map)) << width;
        ASSERT_EQ(steps.width, width);
        ASSERT_EQ(steps.height, height);
        for (std::size_t i = 0; i < map.samples.size(); ++i) {
            const float up = float(steps.samples[i]) - 31 * map.samples[i];
            EXPECT_TRUE(up > -1e-4f && up < 1.0f) << map.samples[i];
            EXPECT_EQ(steps.samples[i] == 0, map.samples[i] == 0);
        }
    }
}

TEST(FlipMean, GivesUpWhereTheOrderOfTheSumMatters) {
    // Errors of 3e-7 in rows so wide that a part of their sum may need more than 53 bits.
    const ImageF a(4000, 12, 3, 0.001f);
    ImageF b = a;
    for (std::size_t i = 2; i < b.samples.size(); i += 3) b.samples[i] += 0x1p-29f;
    const ImageF map = map_of(a, b);
    ASSERT_LT(map.samples[0], 0x1p-21f);
    ASSERT_GT(map.samples[0], 0.0f);
    EXPECT_FALSE(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree));
}

TEST(FlipMean, LeavesTransparentPicturesToTheMap) {
    Image8 a(20, 20, 2, 100), b(20, 20, 2, 120);
    EXPECT_FALSE(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree));
    for (std::size_t i = 1; i < a.samples.size(); i += 2) a.samples[i] = b.samples[i] = 255;
    EXPECT_EQ(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree), mean_of(map_of(a, b)));
}

TEST(FlipMean, OfADiffIsTheSameHoweverMuchIsKept) {
    Random random(29);
    const Image8 a = scribble(random, constant(300, 90, {60, 60, 60}), 40), b = scribble(random, a, 25);
    for (const bool ignores : {false, true}) {
        raster::DiffOptions options;
        if (ignores) options.ignored = {{0, 0, 150, 90}};
        const auto all = raster::diff_images(a, b, options);
        ASSERT_TRUE(all);
        raster::Diff shown = *all;
        const raster::IndexedImage picture = raster::flip_picture(std::move(shown));
        for (const auto detail : {raster::FlipDetail::none, raster::FlipDetail::steps}) {
            options.flip_detail = detail;
            auto some = raster::diff_images(a, b, options);
            ASSERT_TRUE(some);
            EXPECT_EQ(some->figures->flip, all->figures->flip);
            EXPECT_EQ(some->flip_map.empty(), !ignores);
            EXPECT_EQ(some->flip_steps.empty(), ignores || detail == raster::FlipDetail::none);
            if (detail != raster::FlipDetail::steps) continue;
            const raster::IndexedImage same = raster::flip_picture(std::move(*some));
            EXPECT_EQ(same.indices, picture.indices);
            EXPECT_EQ(same.palette, picture.palette);
        }
    }
}

TEST(Flip, ADifferenceInAlphaAloneIsSeenWhateverTheColour) {
    for (const int grey : {0, 128, 255}) {
        Image8 a(20, 20, 2, std::uint8_t(grey)), b = a;
        for (std::size_t i = 1; i < a.samples.size(); i += 2) a.samples[i] = 255, b.samples[i] = 100;
        EXPECT_GT(mean_of(map_of(a, b)), 0.1) << grey;
    }
}

#if !defined(RASTER_NO_THREADS)
TEST(Flip, IsTheSameForEveryNumberOfThreads) {
    Random random(27);
    const Image8 a = scribble(random, constant(700, 500, {60, 60, 60}), 300), b = scribble(random, a, 50);
    const ImageF all = map_of(a, b);
    for (const int threads : {1, 2, 3}) {
        tbb::task_arena arena(threads);
        EXPECT_EQ(arena.execute([&] { return map_of(a, b); }), all) << threads;
    }
}
#endif

}  // namespace
