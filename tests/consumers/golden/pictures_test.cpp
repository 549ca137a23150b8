// pictures_test.cpp: what a user's golden test looks like; once it passes and once it fails as it should.
#include <filesystem>

#include <gtest/gtest.h>

#include <raster/testing/matchers.h>

namespace {

raster::Image8 gradient() {
    raster::Image8 image(24, 16, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            image.pixel(x, y)[0] = std::uint8_t(x * 10);
            image.pixel(x, y)[1] = std::uint8_t(y * 16);
            image.pixel(x, y)[2] = 128;
        }
    return image;
}

TEST(Pictures, TheGradientIsTheApprovedOne) {
    EXPECT_THAT(gradient(), raster::testing::MatchesGolden("gradient"));
}

TEST(Pictures, AnotherGradientIsNot) {
    raster::Image8 other = gradient();
    other.pixel(3, 4)[2] += 1;
    EXPECT_THAT(other, ::testing::Not(raster::testing::MatchesGolden("gradient")));
    EXPECT_THAT(other, raster::testing::MatchesGolden("gradient", {.max_delta = 1}));
}

}  // namespace
