// diff_images_test.cpp: verdicts, gates, what would pass, masks and named failures.
#include <raster/image/diff.h>

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#if !defined(RASTER_NO_THREADS)
#include <tbb/task_arena.h>
#endif

#include "random.h"

namespace {

using raster::AnyImage;
using raster::Diff;
using raster::diff_images;
using raster::DiffOptions;
using raster::ErrorKind;
using raster::Gates;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::Verdict;
using raster::testing::Random;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Diff compare(const AnyImage& expected, const AnyImage& actual, const Gates& gates = {}) {
    DiffOptions options;
    options.gates = gates;
    auto diff = diff_images(expected, actual, options);
    EXPECT_TRUE(diff) << diff.error().message;
    return diff ? *diff : Diff{};
}

Image8 grey(int width, int height, int value = 100) { return Image8(width, height, 3, std::uint8_t(value)); }

/// Six pixels that differ by 1 to 6.
Image8 six_steps(const Image8& image) {
    Image8 other = image;
    for (int i = 1; i <= 6; ++i) other.pixel(5 * i, 3)[1] = std::uint8_t(other.pixel(5 * i, 3)[1] + i);
    return other;
}

TEST(Diff, ExactIsTheDefault) {
    const Image8 a = grey(40, 20);
    EXPECT_EQ(compare(a, a).verdict, Verdict::same);
    Image8 b = a;
    b.pixel(39, 19)[2] += 60;
    const Diff diff = compare(a, b);
    EXPECT_EQ(diff.verdict, Verdict::different);
    EXPECT_EQ(diff.figures->differing, 1);
    EXPECT_EQ(diff.figures->max_x, 39);
    EXPECT_GT(diff.figures->flip, 0);
    EXPECT_LT(diff.figures->ssim, 1);
}

TEST(Diff, MaxDeltaIsTheLargestStepThatPasses) {
    const Image8 a = grey(40, 20), b = six_steps(a);
    EXPECT_EQ(compare(a, b, {.max_delta = 6}).verdict, Verdict::tolerated);
    const Diff diff = compare(a, b, {.max_delta = 4});
    EXPECT_EQ(diff.verdict, Verdict::different);
    EXPECT_EQ(diff.figures->failing, 2);
    EXPECT_EQ(diff.figures->differing, 6);
}

TEST(Diff, MaxPixelsCountsWhatIsBeyondMaxDelta) {
    const Image8 a = grey(40, 20), b = six_steps(a);
    EXPECT_EQ(compare(a, b, {.max_pixels = 6}).verdict, Verdict::tolerated);
    EXPECT_EQ(compare(a, b, {.max_pixels = 5}).verdict, Verdict::different);
    EXPECT_EQ(compare(a, b, {.max_delta = 4, .max_pixels = 2}).verdict, Verdict::tolerated);
    EXPECT_EQ(compare(a, b, {.max_delta = 4, .max_pixels = 1}).verdict, Verdict::different);
}

TEST(Diff, FlipAloneIsTheOnlyGate) {
    const Image8 a = grey(40, 20), b = six_steps(a);
    const double flip = compare(a, b).figures->flip;
    EXPECT_EQ(compare(a, b, {.flip = flip}).verdict, Verdict::tolerated);
    EXPECT_EQ(compare(a, b, {.flip = flip * 0.999}).verdict, Verdict::different);
    EXPECT_EQ(compare(a, b, {.max_delta = 5, .flip = 1}).verdict, Verdict::different);
    EXPECT_EQ(compare(a, b, {.max_delta = 6, .flip = 0}).verdict, Verdict::different);
}

TEST(Diff, AnEdgeOnePixelOverPassesWithShiftOne) {
    Image8 a = grey(40, 20, 20), b = a;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 3; ++c) {
                if (x >= 20) a.pixel(x, y)[c] = 200;
                if (x >= 21) b.pixel(x, y)[c] = 200;
            }
    EXPECT_EQ(compare(a, b).figures->failing, 20);
    EXPECT_EQ(compare(a, b, {.max_shift = 1}).verdict, Verdict::tolerated);
    EXPECT_THAT(compare(a, b).would_pass, Contains(Gates{.max_shift = 1}));
}

TEST(Diff, ALineThatIsGoneFailsWhateverTheShift) {
    Image8 a = grey(40, 20, 20);
    const Image8 b = a;
    for (int y = 0; y < 20; ++y) a.pixel(20, y)[0] = 255;
    EXPECT_EQ(compare(a, b, {.max_shift = 3}).verdict, Verdict::different);
    EXPECT_EQ(compare(b, a, {.max_shift = 3}).verdict, Verdict::different);
}

TEST(Diff, WhatIsSaidToPassPassesAndNothingTighterDoes) {
    Random random(4);
    for (int round = 0; round < 30; ++round) {
        const Image8 a = grey(30, 20);
        Image8 b = a;
        for (int i = random.integer(1, 40); i > 0; --i)
            b.pixel(random.integer(0, 29), random.integer(0, 19))[random.integer(0, 2)] =
                std::uint8_t(random.integer(60, 180));
        Gates given;
        if (random.integer(0, 1) == 1) given.max_delta = random.integer(0, 10);
        if (random.integer(0, 1) == 1) given.max_pixels = random.integer(0, 5);
        if (random.integer(0, 3) == 0) given.flip = 1e-5 * random.integer(0, 100);
        const Diff diff = compare(a, b, given);
        if (raster::passes(diff.verdict)) continue;
        ASSERT_FALSE(diff.would_pass.empty());
        for (const Gates& gates : diff.would_pass) {
            EXPECT_EQ(compare(a, b, gates).verdict, Verdict::tolerated)
                << to_string(given) << " -> " << to_string(gates);
            Gates tighter = gates;
            if (gates.max_delta && gates.max_delta != given.max_delta) *tighter.max_delta -= 1;
            else if (gates.max_pixels && gates.max_pixels != given.max_pixels) *tighter.max_pixels -= 1;
            else if (gates.max_shift && gates.max_shift != given.max_shift) *tighter.max_shift -= 1;
            else *tighter.flip *= 0.8;
            EXPECT_EQ(compare(a, b, tighter).verdict, Verdict::different)
                << to_string(gates) << " -> " << to_string(tighter);
        }
    }
}

TEST(Diff, FloatGatesPassAsTheyArePrinted) {
    ImageF a(4, 4, 1, 0.25f), b = a;
    b.samples[5] = 0.35f;
    const Diff diff = compare(a, b);
    const std::string printed = to_string(diff.would_pass.at(0));
    ASSERT_THAT(printed, HasSubstr("--max-delta 0."));
    EXPECT_EQ(compare(a, b, {.max_delta = std::stod(printed.substr(12))}).verdict, Verdict::tolerated);
}

TEST(Diff, AGateFarLooserThanNeededIsWarnedOf) {
    const Image8 a = grey(40, 20), b = six_steps(a);
    EXPECT_THAT(compare(a, b, {.max_delta = 6}).warnings, IsEmpty());
    EXPECT_THAT(compare(a, b, {.max_delta = 10}).warnings, IsEmpty());
    EXPECT_THAT(compare(a, b, {.max_delta = 60}).warnings,
                Contains("--max-delta 60 is far looser than needed: 6 would pass"));
    EXPECT_THAT(compare(a, b, {.max_delta = 16}).warnings, IsEmpty());
    EXPECT_THAT(compare(a, b, {.max_delta = 17}).warnings, Not(IsEmpty()));
    EXPECT_THAT(compare(a, a, {.max_delta = 51}).warnings, Contains(HasSubstr("0 would pass")));
    EXPECT_THAT(compare(a, b, {.max_pixels = 500}).warnings,
                Contains("--max-pixels 500 is far looser than needed: 6 would pass"));
    EXPECT_THAT(compare(a, b, {.flip = 0.5}).warnings, Contains(HasSubstr("--flip 0.5 is far looser")));
    EXPECT_THAT(compare(a, b, {.max_delta = 6, .max_shift = 4}).warnings, Contains(HasSubstr("--max-shift 4")));
}

TEST(Diff, StepsOfSixteenBitsAreSmall) {
    const raster::Image16 a(9, 9, 3, 20000);
    raster::Image16 b = a;
    b.pixel(4, 4)[1] += 7;
    EXPECT_THAT(compare(a, b, {.max_delta = 18}).warnings, IsEmpty());
    EXPECT_THAT(compare(a, b, {.max_delta = 700}).warnings,
                Contains("--max-delta 700 is far looser than needed: 7 would pass"));
}

// ------------------------------------------------------------------------------------------- named failures

TEST(Diff, ADifferentSizeIsAFailureByName) {
    const Diff diff = compare(grey(1, 1), grey(106, 106), {.max_delta = 255, .max_pixels = 1000000, .flip = 1});
    EXPECT_EQ(diff.verdict, Verdict::size_mismatch);
    EXPECT_EQ(diff.reason, "expected 1x1, actual 106x106 pixels");
    EXPECT_FALSE(diff.figures);
}

TEST(Diff, NanFailsByNameEvenWhenBothHaveIt) {
    ImageF a(4, 4, 3, 0.5f);
    a.pixel(1, 2)[1] = std::numeric_limits<float>::quiet_NaN();
    for (const Gates& gates : {Gates{}, Gates{.max_delta = 1e30, .max_pixels = 100}}) {
        const Diff diff = compare(a, a, gates);
        EXPECT_EQ(diff.verdict, Verdict::not_a_number);
        EXPECT_THAT(diff.reason, HasSubstr("expected picture has 1 NaN, first at (1,2); the actual"));
    }
}

TEST(Diff, WholeNumbersAgainstFloatsIsAFailureByName) {
    EXPECT_EQ(compare(grey(4, 4), ImageF(4, 4, 3)).verdict, Verdict::type_mismatch);
}

TEST(Diff, OptionsOutOfTheirRangeAreUsageErrors) {
    const Image8 a = grey(4, 4);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Gates& gates : {Gates{.max_delta = -1},
                               {.max_delta = nan},
                               {.max_pixels = -1},
                               {.max_shift = 17},
                               {.max_shift = -1},
                               {.flip = 1.5},
                               {.flip = nan}}) {
        DiffOptions options;
        options.gates = gates;
        const auto diff = diff_images(a, a, options);
        ASSERT_FALSE(diff);
        EXPECT_EQ(diff.error().kind, ErrorKind::usage);
    }
}

// ----------------------------------------------------------------------------------------- what is adapted

TEST(Diff, GreyIsComparedAsColourAndAMissingAlphaAsOpaque) {
    const Image8 flat(6, 5, 1, 77);
    const Diff diff = compare(flat, Image8(6, 5, 3, 77));
    EXPECT_EQ(diff.verdict, Verdict::same);
    EXPECT_THAT(diff.notes, Contains("expected grey, actual RGB: compared as RGB"));
    Image8 rgba(6, 5, 4, 77);
    for (std::size_t i = 3; i < rgba.samples.size(); i += 4) rgba.samples[i] = 255;
    EXPECT_EQ(compare(flat, rgba).verdict, Verdict::same);
    rgba.samples[3] = 254;
    EXPECT_EQ(compare(flat, rgba).figures->differing, 1);
}

TEST(Diff, EightBitsAreComparedWithSixteenAsSixteen) {
    Image16 deep(6, 5, 3, 100 * 257);
    EXPECT_EQ(compare(grey(6, 5), deep).verdict, Verdict::same);
    deep.samples[4] += 1;
    const Diff diff = compare(grey(6, 5), deep);
    EXPECT_EQ(diff.figures->max, 1);
    EXPECT_THAT(diff.notes, Contains("expected 8 bits, actual 16 bits: compared as 16 bits"));
}

// ----------------------------------------------------------------------------------------- masks and rectangles

TEST(Diff, IgnoredPixelsCountForNothing) {
    const Image8 a = grey(60, 40);
    Image8 b = a;
    for (int y = 10; y < 20; ++y)
        for (int x = 30; x < 50; ++x) b.pixel(x, y)[0] = 255;
    DiffOptions options;
    options.ignored = {{30, 10, 20, 10}};
    auto diff = diff_images(a, b, options);
    ASSERT_TRUE(diff);
    EXPECT_EQ(diff->verdict, Verdict::same);
    EXPECT_EQ(diff->figures->compared, 60 * 40 - 200);
    EXPECT_EQ(diff->figures->flip, 0);
    options.ignored = {{31, 10, 2000000000, 2000000000}};
    diff = diff_images(a, b, options);
    ASSERT_TRUE(diff);
    EXPECT_EQ(diff->figures->differing, 10);
    EXPECT_NEAR(diff->figures->mean, 10.0 * 155 / (3.0 * double(diff->figures->compared)), 1e-12);
}

TEST(Diff, OfAMaskWhiteIsComparedAndBlackIsNot) {
    const Image8 a = grey(8, 1);
    const Image8 b = grey(8, 1, 101);
    DiffOptions options;
    options.mask = Image8(8, 1, 3, 0);
    for (int x = 0; x < 3; ++x) options.mask.pixel(x, 0)[1] = 255;
    const auto diff = diff_images(a, b, options);
    ASSERT_TRUE(diff);
    EXPECT_EQ(diff->figures->compared, 3);
    EXPECT_EQ(diff->figures->differing, 3);
    EXPECT_DOUBLE_EQ(diff->figures->mean, 1);
}

TEST(Diff, NanUnderAMaskIsIgnored) {
    ImageF a(4, 4, 3, 0.5f);
    const ImageF b = a;
    a.pixel(1, 2)[1] = std::numeric_limits<float>::quiet_NaN();
    DiffOptions options;
    options.ignored = {{1, 2, 1, 1}};
    const auto diff = diff_images(a, b, options);
    ASSERT_TRUE(diff);
    EXPECT_EQ(diff->verdict, Verdict::same);
}

TEST(Diff, AMaskThatLeavesNothingOrHasAnotherSizeIsAnError) {
    const Image8 a = grey(8, 4);
    DiffOptions options;
    options.mask = Image8(8, 5, 1, 255);
    EXPECT_FALSE(diff_images(a, a, options));
    options.mask = Image8(8, 4, 1, 0);
    EXPECT_FALSE(diff_images(a, a, options));
    options.mask = {};
    options.ignored = {{-5, -5, 100, 100}};
    EXPECT_FALSE(diff_images(a, a, options));
}

// ------------------------------------------------------------------------------------------------- regions

TEST(Diff, DistantPixelsAreRegionsOfTheirOwnTheLargestFirst) {
    const Image8 a = grey(200, 100);
    Image8 b = a;
    b.pixel(150, 80)[0] = 255;
    for (int i = 0; i < 30; ++i) b.pixel(10 + i, 20)[0] = std::uint8_t(110 + i);
    const Diff diff = compare(a, b);
    ASSERT_EQ(diff.regions.size(), 2u);
    EXPECT_EQ(diff.regions[0].box, (raster::PixelRect{10, 20, 30, 1}));
    EXPECT_EQ(diff.regions[0].pixels, 30);
    EXPECT_EQ(diff.regions[0].max_x, 39);
    EXPECT_EQ(diff.regions[1].box, (raster::PixelRect{150, 80, 1, 1}));
}

TEST(Diff, RegionsHoldEveryFailingPixel) {
    Random random(5);
    const Image8 a = grey(300, 200);
    Image8 b = a;
    for (int i = 0; i < 60; ++i) b.pixel(random.integer(0, 299), random.integer(0, 199))[0] ^= 0x55;
    const Diff diff = compare(a, b);
    std::int64_t pixels = 0;
    for (const auto& region : diff.regions) pixels += region.pixels;
    EXPECT_EQ(pixels, diff.figures->failing);
    EXPECT_EQ(diff.region_count, std::int64_t(diff.regions.size()));
}

#if !defined(RASTER_NO_THREADS)
TEST(Diff, IsTheSameForEveryNumberOfThreads) {
    Random random(6);
    ImageF a(300, 200, 3), b(300, 200, 3);
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        a.samples[i] = random.uniform(0, 1), b.samples[i] = a.samples[i] + random.uniform(-0.1f, 0.1f);
    const Diff all = compare(a, b, {.max_shift = 1});
    for (const int threads : {1, 2, 4}) {
        tbb::task_arena arena(threads);
        const Diff diff = arena.execute([&] { return compare(a, b, {.max_shift = 1}); });
        EXPECT_EQ(diff.figures->mean, all.figures->mean);
        EXPECT_EQ(diff.figures->rms, all.figures->rms);
        EXPECT_EQ(diff.figures->ssim, all.figures->ssim);
        EXPECT_EQ(diff.figures->flip, all.figures->flip);
        EXPECT_EQ(diff.deltas, all.deltas);
    }
}
#endif

}  // namespace
