// Stage 8: depths as integers, and every comparison.
#include <raster/stages/depth.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Depth, TheEndsOfTheRange) {
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 0.0f), 0);
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 1.0f), 0xffffff);
    EXPECT_EQ(encode_depth(DepthFormat::float32, 0.0f), 0);
    EXPECT_EQ(encode_depth(DepthFormat::float32, 1.0f), 0x3f800000);
}

TEST(Depth, WhatLiesBeyondIsClampedAndNaNIsFar) {
    for (const auto format : {DepthFormat::unorm24, DepthFormat::float32}) {
        for (const float near : {-0.0f, -1e-30f, -5.0f, -infinity}) EXPECT_EQ(encode_depth(format, near), 0);
        for (const float far : {1.0000001f, 7.0f, infinity, NAN})
            EXPECT_EQ(encode_depth(format, far), encode_depth(format, 1.0f));
    }
}

TEST(Depth, TwentyFourBitsRoundHalvesToEven) {
    // z * 16777215 is rounded to a float first; between 2^22 and 2^23 floats have halves, and there are ties.
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 0.5f), 8388608) << "8388607.5 to even";
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 0.25f), 4194304) << "4194303.75";
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 4500001.0f / 16777216), 4500000)
        << "4500000.73 as a float is 4500000.5";
    EXPECT_EQ(encode_depth(DepthFormat::unorm24, 4500002.0f / 16777216), 4500002)
        << "4500001.73 as a float is 4500001.5";
    Random random(1);
    for (int round = 0; round < 100000; ++round) {
        const float z = random.uniform(0, 1);
        ASSERT_EQ(encode_depth(DepthFormat::unorm24, z), std::int32_t(std::nearbyint(z * 16777215.0f)));
    }
}

TEST(Depth, AClearRoundsOnce) {
    EXPECT_EQ(encode_clear_depth(DepthFormat::unorm24, 1), 0xffffffu);
    EXPECT_EQ(encode_clear_depth(DepthFormat::unorm24, 4500001.0f / 16777216), 4500001u);
    EXPECT_EQ(encode_clear_depth(DepthFormat::float32, 0.5f), 0x3f000000u);
    EXPECT_EQ(encode_clear_depth(DepthFormat::unorm24, NAN), 0xffffffu);
    EXPECT_EQ(encode_clear_depth(DepthFormat::unorm24, -3), 0u);
}

TEST(Depth, EncodingKeepsOrder) {
    Random random(2);
    for (const auto format : {DepthFormat::unorm24, DepthFormat::float32})
        for (int round = 0; round < 50000; ++round) {
            const float a = random.uniform(-0.1f, 1.1f), b = a + random.uniform(0, 1e-6f);
            ASSERT_LE(encode_depth(format, a), encode_depth(format, b));
        }
}

TEST(Depth, DecodingIsTheValueThatWasStored) {
    EXPECT_EQ(decode_depth(DepthFormat::unorm24, 0xffffff), 1);
    EXPECT_EQ(decode_depth(DepthFormat::unorm24, 0), 0);
    Random random(3);
    for (int round = 0; round < 50000; ++round) {
        const float z = random.uniform(0, 1);
        const auto bits = std::uint32_t(encode_depth(DepthFormat::float32, z));
        ASSERT_EQ(decode_depth(DepthFormat::float32, bits), z);
        const auto stored = std::uint32_t(encode_depth(DepthFormat::unorm24, z));
        ASSERT_NEAR(decode_depth(DepthFormat::unorm24, stored), z, 1.0 / 16777215);
    }
}

TEST(Depth, EveryComparisonOnBothSidesOfEqual) {
    const auto passes = [](Compare compare) {
        std::array<bool, 3> r;  // incoming nearer, equal, farther
        for (std::int32_t i = 0; i < 3; ++i) r[std::size_t(i)] = depth_passes(compare, 99 + i, 100);
        return r;
    };
    EXPECT_EQ(passes(Compare::never), (std::array{false, false, false}));
    EXPECT_EQ(passes(Compare::less), (std::array{true, false, false}));
    EXPECT_EQ(passes(Compare::equal), (std::array{false, true, false}));
    EXPECT_EQ(passes(Compare::less_equal), (std::array{true, true, false}));
    EXPECT_EQ(passes(Compare::greater), (std::array{false, false, true}));
    EXPECT_EQ(passes(Compare::not_equal), (std::array{true, false, true}));
    EXPECT_EQ(passes(Compare::greater_equal), (std::array{false, true, true}));
    EXPECT_EQ(passes(Compare::always), (std::array{true, true, true}));
}

TEST(Depth, LanesEncodeAndCompareAsScalars) {
    using F = FloatPack<8>;
    Random random(4);
    for (int round = 0; round < 2000; ++round) {
        F z;
        for (int l = 0; l < 8; ++l)
            z.v[l] = random.integer(0, 5) ? random.uniform(-0.2f, 1.2f)
                                          : as_float(std::int32_t(std::uint32_t(random.bits())));
        const auto compare = Compare(random.integer(0, 7));
        for (const auto format : {DepthFormat::unorm24, DepthFormat::float32}) {
            const auto packed = encode_depth(format, z);
            const std::int32_t stored = lane(packed, 3);
            const auto pass = depth_passes(compare, packed, Int<F>(stored));
            for (int l = 0; l < 8; ++l) {
                const std::int32_t one = encode_depth(format, lane(z, l));
                ASSERT_EQ(lane(packed, l), one) << lane(z, l);
                ASSERT_EQ(lane(pass, l), depth_passes(compare, one, stored));
            }
        }
    }
}

}  // namespace
