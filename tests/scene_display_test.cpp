// The way from light to bytes: sRGB's transfer function, exposure, the clamp.
#include <raster/scene/display.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <raster/shading/texture.h>

namespace raster {
namespace {

Target light_of(const std::vector<glm::vec4>& colors) {
    Target target(int(colors.size()), 1, ColorFormat::rgba_float);
    target.color_float() = colors;
    return target;
}

TEST(Srgb, IsTheStandardsCurve) {
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        const double expected = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
        EXPECT_NEAR(srgb_encode(float(x)), expected, 2e-6) << x;
    }
    EXPECT_EQ(srgb_encode(0.0f), 0.0f);
    EXPECT_NEAR(srgb_encode(1.0f), 1.0f, 1e-6);
    EXPECT_EQ(srgb_encode(-1.0f), 0.0f);
    EXPECT_EQ(srgb_encode(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_NEAR(srgb_encode(std::numeric_limits<float>::infinity()), 1.0f, 1e-6);
}

TEST(Srgb, EveryByteComesBackAsItWas) {
    for (int i = 0; i < 256; ++i) {
        const float linear = srgb_decode_table()[i];
        EXPECT_EQ(std::lround(srgb_encode(linear) * 255.0f), i);
        EXPECT_NEAR(srgb_decode(float(i) / 255.0f), linear, 1e-6);
    }
}

TEST(Display, PlainLightIsClampedAndRounded) {
    const Target shown = displayed(light_of({{0.2f, 1.5f, -1, 0.5f}}), {});
    EXPECT_EQ(shown.color8()[0], 51u | 255u << 8 | 0u << 16 | 128u << 24);
}

TEST(Display, AStopDoublesTheLightAndLeavesAlpha) {
    const Target light = light_of({{0.1f, 0.2f, 0.3f, 0.2f}});
    EXPECT_EQ(displayed(light, {false, 1}).color8()[0], 51u | 102u << 8 | 153u << 16 | 51u << 24);
    EXPECT_EQ(displayed(light, {false, -1}).color8()[0] & 255u, 13u);
    Target exposed = light;
    expose(exposed, 2);
    EXPECT_FLOAT_EQ(exposed.color_float()[0].g, 0.8f);
    EXPECT_EQ(exposed.color_float()[0].a, 0.2f);
}

TEST(Display, HalfTheLightIsByte188InSrgb) {
    const Target shown = displayed(light_of({{0.5f, 0.25f, 1, 1}}), {true, 0});
    EXPECT_EQ(shown.color8()[0], 188u | 137u << 8 | 255u << 16 | 255u << 24);
    EXPECT_EQ(displayed(light_of({{0.25f, 0, 0, 1}}), {true, 1}).color8()[0] & 255u, 188u);
}

TEST(Display, ABackgroundIsShownAsItWasAskedFor) {
    const glm::vec4 color(0.2f, 0.4f, 0.9f, 0.6f);
    for (const Display& display : {Display{}, Display{true, 0}, Display{true, 3}, Display{false, -2}}) {
        const Target shown = displayed(light_of({light_for(color, display)}), display);
        EXPECT_EQ(shown.color8()[0], 51u | 102u << 8 | 230u << 16 | 153u << 24) << display.exposure;
    }
}

}  // namespace
}  // namespace raster
