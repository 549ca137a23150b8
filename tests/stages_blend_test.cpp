// Stage 11: rounding to 8 bits and mixing there.
#include <raster/stages/blend.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();

std::uint32_t pack(std::uint32_t r, std::uint32_t g, std::uint32_t b, std::uint32_t a) {
    return r | g << 8 | b << 16 | a << 24;
}
std::uint32_t channel(std::uint32_t color, int i) { return color >> (8 * i) & 255; }
/// One channel's product.
std::uint32_t multiply(std::uint32_t x, std::uint32_t y) { return multiply_unorm8<std::uint32_t>(x, y); }

TEST(Blend, ChannelsAreClampedAndRoundedHalfToEven) {
    EXPECT_EQ(to_unorm8(0.0f), 0);
    EXPECT_EQ(to_unorm8(1.0f), 255);
    EXPECT_EQ(to_unorm8(0.5f), 128) << "127.5 to even";
    EXPECT_EQ(to_unorm8(0.5f / 255), 0) << "0.5 to even";
    EXPECT_EQ(to_unorm8(2.5f / 255), 2) << "2.5 to even";
    for (const float low : {-0.0f, -1.0f, -1e-30f, -infinity}) EXPECT_EQ(to_unorm8(low), 0);
    for (const float high : {1.0001f, 77.0f, infinity}) EXPECT_EQ(to_unorm8(high), 255);
    EXPECT_EQ(to_unorm8(NAN), 0);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(to_unorm8(float(i) / 255.0f), i);
}

TEST(Blend, PackingPutsRedLowest) {
    EXPECT_EQ(std::uint32_t(pack_rgba8(glm::vec4(1, 0, 0, 0))), 0x000000ffu);
    EXPECT_EQ(std::uint32_t(pack_rgba8(glm::vec4(0, 1, 0, 0))), 0x0000ff00u);
    EXPECT_EQ(std::uint32_t(pack_rgba8(glm::vec4(0, 0, 1, 0))), 0x00ff0000u);
    EXPECT_EQ(std::uint32_t(pack_rgba8(glm::vec4(0, 0, 0, 1))), 0xff000000u);
}

TEST(Blend, UnpackingIsPackingsInverse) {
    Random random(1);
    for (int round = 0; round < 10000; ++round) {
        const auto color = std::uint32_t(random.bits());
        ASSERT_EQ(std::uint32_t(pack_rgba8(unpack_rgba8(color))), color);
    }
}

TEST(Blend, ProductsAreRoundedButForTwelvePairs) {
    int low = 0;
    for (std::uint32_t x = 0; x < 256; ++x)
        for (std::uint32_t y = 0; y < 256; ++y) {
            const auto rounded = std::uint32_t(std::lround(x * y / 255.0));
            const std::uint32_t product = multiply(x, y);
            ASSERT_EQ(product, multiply(y, x));
            ASSERT_TRUE(product == rounded || product + 1 == rounded) << x << " " << y;
            low += product != rounded;
            // Two channels at once do not disturb each other.
            ASSERT_EQ(multiply_unorm8<std::uint32_t>(x << 16 | (255 - x), y), product << 16 | multiply(255 - x, y));
        }
    EXPECT_EQ(low, 24) << "as llvmpipe, whose shortcut this is; 12 pairs in both orders";
    for (std::uint32_t x = 0; x < 256; ++x) {
        EXPECT_EQ(multiply(x, 255), x);
        EXPECT_EQ(multiply(x, 0), 0u);
    }
}

TEST(Blend, OffReplaces) { EXPECT_EQ(blend_rgba8(Blend::off, pack(1, 2, 3, 4), pack(9, 9, 9, 9)), pack(1, 2, 3, 4)); }

TEST(Blend, SourceOverMixesByTheSourcesAlpha) {
    const std::uint32_t under = pack(10, 20, 30, 40);
    EXPECT_EQ(blend_rgba8(Blend::source_over, pack(200, 100, 50, 255), under), pack(200, 100, 50, 255));
    EXPECT_EQ(blend_rgba8(Blend::source_over, pack(200, 100, 50, 0), under), under);
    // Alpha 128: 255 * 128 / 255 = 128, and 0 + 255 * 127 / 255 = 127.
    EXPECT_EQ(blend_rgba8(Blend::source_over, pack(255, 0, 255, 128), pack(0, 255, 255, 255)),
              pack(128, 127, 255, 191));
}

TEST(Blend, AdditiveSaturates) {
    EXPECT_EQ(blend_rgba8(Blend::additive, pack(200, 100, 1, 255), pack(100, 100, 254, 255)), pack(255, 200, 255, 255));
}

TEST(Blend, EveryChannelIsBlendedAlone) {
    Random random(2);
    for (int round = 0; round < 200000; ++round) {
        const auto s = std::uint32_t(random.bits()), d = std::uint32_t(random.bits());
        const std::uint32_t over = blend_rgba8(Blend::source_over, s, d), sum = blend_rgba8(Blend::additive, s, d);
        const std::uint32_t a = s >> 24;
        for (int i = 0; i < 4; ++i) {
            ASSERT_EQ(channel(over, i), multiply(channel(s, i), a) + multiply(channel(d, i), 255 - a));
            ASSERT_EQ(channel(sum, i), std::min(channel(s, i) + channel(d, i), 255u));
            const double exact = (channel(s, i) * a + channel(d, i) * (255 - a)) / 255.0;
            ASSERT_LE(std::abs(channel(over, i) - exact), 1.5);
        }
    }
}

TEST(Blend, LanesAreBlendedAsScalars) {
    using F = FloatPack<8>;
    Random random(3);
    for (int round = 0; round < 5000; ++round) {
        Int<F> s, d;
        vec<4, F> color;
        for (int l = 0; l < 8; ++l) {
            s.v[l] = std::int32_t(std::uint32_t(random.bits()));
            d.v[l] = std::int32_t(std::uint32_t(random.bits()));
            for (int i = 0; i < 4; ++i)
                color[i].v[l] = random.integer(0, 3) ? random.uniform(-0.1f, 1.1f)
                                                     : as_float(std::int32_t(std::uint32_t(random.bits())));
        }
        const auto packed = pack_rgba8(color);
        for (int l = 0; l < 8; ++l) {
            const glm::vec4 one(lane(color.x, l), lane(color.y, l), lane(color.z, l), lane(color.w, l));
            ASSERT_EQ(lane(packed, l), pack_rgba8(one));
        }
        for (const auto blend : {Blend::off, Blend::source_over, Blend::additive}) {
            const auto mixed = blend_rgba8(blend, s, d);
            for (int l = 0; l < 8; ++l)
                ASSERT_EQ(std::uint32_t(lane(mixed, l)),
                          blend_rgba8(blend, std::uint32_t(lane(s, l)), std::uint32_t(lane(d, l))));
        }
    }
}

TEST(Blend, FloatTargetsNeitherRoundNorClamp) {
    const glm::vec4 s(2, 0.5f, -1, 0.25f), d(1, 1, 1, 4);
    EXPECT_EQ(blend_float(Blend::off, s, d), s);
    EXPECT_EQ(blend_float(Blend::additive, s, d), s + d);
    EXPECT_EQ(blend_float(Blend::source_over, s, d), glm::vec4(1.25f, 0.875f, 0.5f, 3.0625f));
}

}  // namespace
