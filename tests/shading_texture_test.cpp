// Texture sampling: wrap tables, both filters, sRGB, and coordinates that are not even numbers.
#include <gtest/gtest.h>
#include <raster/shading/texture.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// A row of grey texels 0, 10, 20, ...
PackedTexture row_of(int size) {
    Image8 image(size, 1, 1);
    for (int i = 0; i < size; ++i) image.samples[std::size_t(i)] = std::uint8_t(10 * i);
    return pack_texture(image);
}

float grey_at(const PackedTexture& t, Wrap wrap, Filter filter, float u) {
    return sample<float>(TextureView(t, wrap, filter), {u, 0.5f}).x * 255.0f;
}

PackedTexture random_texture(int width, int height, std::uint64_t seed) {
    Random random(seed);
    Image8 image(width, height, 4);
    for (auto& s : image.samples) s = std::uint8_t(random.integer(0, 255));
    return pack_texture(image);
}

TEST(TextureNearest, TakesTheTexelOfTheWrappedCoordinate) {
    struct Row {
        float u;
        int repeat, clamp, mirror;
    };
    // Of five texels, each 0.2 wide.
    const Row table[] = {{0.0f, 0, 0, 0},   {0.1f, 0, 0, 0},  {0.3f, 1, 1, 1},   {0.95f, 4, 4, 4}, {1.0f, 0, 4, 4},
                         {1.1f, 0, 4, 4},   {1.3f, 1, 4, 3},  {1.95f, 4, 4, 0},  {2.1f, 0, 4, 0},  {3.3f, 1, 4, 3},
                         {-0.1f, 4, 0, 0},  {-0.3f, 3, 0, 1}, {-0.95f, 0, 0, 4}, {-1.1f, 4, 0, 4}, {-1.3f, 3, 0, 3},
                         {-2.1f, 4, 0, 0},  {100.5f, 2, 4, 2}, {-100.5f, 2, 0, 2}};
    for (const Row& row : table) {
        EXPECT_NEAR(grey_at(row_of(5), Wrap::repeat, Filter::nearest, row.u), 10 * row.repeat, 1e-3) << row.u;
        EXPECT_NEAR(grey_at(row_of(5), Wrap::clamp, Filter::nearest, row.u), 10 * row.clamp, 1e-3) << row.u;
        EXPECT_NEAR(grey_at(row_of(5), Wrap::mirror, Filter::nearest, row.u), 10 * row.mirror, 1e-3) << row.u;
    }
    // Of eight, where repeating is a bit mask.
    EXPECT_NEAR(grey_at(row_of(8), Wrap::repeat, Filter::nearest, -0.01f), 70, 1e-3);
    EXPECT_NEAR(grey_at(row_of(8), Wrap::repeat, Filter::nearest, 3.26f), 20, 1e-3);
}

TEST(TextureBilinear, MixesTheTwoNearestTexelsOfTheWrappedRow) {
    struct Row {
        float u;
        float repeat, clamp, mirror;
    };
    // Texel centres are at 0.125, 0.375, 0.625, 0.875.
    const Row table[] = {{0.125f, 0, 0, 0},  {0.25f, 5, 5, 5},      {0.3125f, 7.5f, 7.5f, 7.5f}, {0.875f, 30, 30, 30},
                         {1.0f, 15, 30, 30}, {0.0f, 15, 0, 0},      {-0.125f, 30, 0, 0},         {1.125f, 0, 30, 30},
                         {1.25f, 5, 30, 25}, {-0.0625f, 22.5f, 0, 0}};
    for (const Row& row : table) {
        EXPECT_NEAR(grey_at(row_of(4), Wrap::repeat, Filter::bilinear, row.u), row.repeat, 1e-3) << row.u;
        EXPECT_NEAR(grey_at(row_of(4), Wrap::clamp, Filter::bilinear, row.u), row.clamp, 1e-3) << row.u;
        EXPECT_NEAR(grey_at(row_of(4), Wrap::mirror, Filter::bilinear, row.u), row.mirror, 1e-3) << row.u;
    }
    // Three texels repeat without a mask: between the last and the first.
    EXPECT_NEAR(grey_at(row_of(3), Wrap::repeat, Filter::bilinear, 0.0f), 10, 1e-3);
    EXPECT_NEAR(grey_at(row_of(3), Wrap::repeat, Filter::bilinear, 1.0f - 1.0f / 12), 15, 1e-3);
}

TEST(TextureBilinear, AgreesWithTheFormulaInDoublePrecision) {
    const int width = 7, height = 16;
    const PackedTexture texture = random_texture(width, height, 21);
    const TextureView view(texture, Wrap::repeat, Filter::bilinear);
    Random random(22);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 uv(random.uniform(-3, 3), random.uniform(-3, 3));
        const double x = double(uv.x) * width - 0.5, y = double(uv.y) * height - 0.5;
        const auto texel = [&](double column, double row, int channel) {
            const int c = int(column - width * std::floor(column / width));
            const int r = int(row - height * std::floor(row / height));
            return double(texture.texels[std::size_t((height - 1 - r) * width + c)] >> (8 * channel) & 255);
        };
        const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
        const auto value = sample<float>(view, uv);
        for (int c = 0; c < 4; ++c) {
            const double expected = (texel(x0, y0, c) * (1 - fx) + texel(x0 + 1, y0, c) * fx) * (1 - fy) +
                                    (texel(x0, y0 + 1, c) * (1 - fx) + texel(x0 + 1, y0 + 1, c) * fx) * fy;
            ASSERT_NEAR(value[c] * 255, expected, 0.01);
        }
    }
}

TEST(Texture, HasItsTopRowAtTheTop) {
    Image8 image(1, 2, 3);
    image.samples = {255, 0, 0, 0, 0, 255};  // red above blue
    const PackedTexture texture = pack_texture(image);
    const TextureView view(texture);
    EXPECT_EQ(sample<float>(view, {0.5f, 0.75f}), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(sample<float>(view, {0.5f, 0.25f}), glm::vec4(0, 0, 1, 1));
}

TEST(Texture, SpreadsGreyAndCompletesAlpha) {
    EXPECT_EQ(pack_texture(Image8(1, 1, 1, 7)).texels[0], std::int32_t(0xff070707u));
    Image8 grey_alpha(1, 1, 2);
    grey_alpha.samples = {7, 9};
    EXPECT_EQ(pack_texture(grey_alpha).texels[0], 0x09070707);
    Image8 rgba(1, 1, 4);
    rgba.samples = {1, 2, 3, 4};
    EXPECT_EQ(pack_texture(rgba).texels[0], 0x04030201);
    EXPECT_FALSE(TextureView(pack_texture(Image8())));
    EXPECT_FALSE(TextureView(pack_texture(Image8(max_texture_size + 1, 1, 1))));
}

TEST(Texture, DecodesSrgbColoursButNotAlpha) {
    const float* table = srgb_decode_table();
    for (int i = 0; i < 256; ++i) {
        const double s = i / 255.0;
        EXPECT_NEAR(table[i], s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4), 2e-6);
    }
    EXPECT_EQ(table[0], 0.0f);
    EXPECT_EQ(table[255], 1.0f);
    Image8 image(1, 1, 4);
    image.samples = {0, 128, 255, 128};
    const PackedTexture texture = pack_texture(image);
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
        const auto value = sample<float>(TextureView(texture, Wrap::repeat, filter, table), {0.3f, 0.3f});
        EXPECT_NEAR(value.y, 0.2158605f, 1e-5f);
        EXPECT_NEAR(value.w, 128 / 255.0f, 1e-6f);
    }
}

TEST(Texture, ReadsInsideTheImageForAnyCoordinate) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const float strange[] = {0, -0.0f, 1, nan, inf, -inf, 1e9f, -1e9f, 3e38f, -3e38f, 1e-40f, -1e-40f, 8388608.0f,
                             -8388607.5f, 2147483648.0f, -2147483648.0f, 4294967296.0f};
    for (const int width : {1, 5, 8}) {
        // One texel's memory on its own: an address beside it would be seen by the address sanitizer.
        const PackedTexture texture = random_texture(width, 3, 23);
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
            for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
                const TextureView view(texture, wrap, filter);
                for (const float u : strange) {
                    for (const float v : strange) {
                        const auto scalar = sample<float>(view, {u, v});
                        const auto packed = sample<FloatPack<8>>(view, {FloatPack<8>(u), FloatPack<8>(v)});
                        for (int c = 0; c < 4; ++c) {
                            ASSERT_TRUE(scalar[c] >= 0 && scalar[c] <= 1.0001f);
                            ASSERT_EQ(bits_of(scalar[c]), bits_of(lane(packed[c], 7)));
                        }
                    }
                }
            }
        }
    }
}

TEST(Texture, GivesLanesExactlyWhatItGivesTheScalar) {
    constexpr int n = 8;
    using F = FloatPack<n>;
    Random random(24);
    for (const int size : {4, 6}) {
        const PackedTexture texture = random_texture(size, 5, 25);
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
            for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
                for (const float* decode : {static_cast<const float*>(nullptr), srgb_decode_table()}) {
                    const TextureView view(texture, wrap, filter, decode);
                    for (int round = 0; round < 20; ++round) {
                        vec<2, F> uv;
                        for (int i = 0; i < n; ++i)
                            for (int c = 0; c < 2; ++c) set_lane(uv[c], i, random.uniform(-3, 3));
                        const auto packed = sample<F>(view, uv);
                        for (int i = 0; i < n; ++i) {
                            const auto scalar = sample<float>(view, {lane(uv.x, i), lane(uv.y, i)});
                            for (int c = 0; c < 4; ++c) ASSERT_EQ(bits_of(scalar[c]), bits_of(lane(packed[c], i)));
                        }
                    }
                }
            }
        }
    }
}

}  // namespace
