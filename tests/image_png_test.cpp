// image_png_test.cpp: what encode_png writes is a PNG of exactly the samples given.
#include <raster/image/png.h>

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <raster/image/decode.h>
#include <raster/testing/matchers.h>

#include "image_testing.h"

namespace {

using raster::Bytes;
using raster::ErrorKind;
using raster::Image16;
using raster::Image8;
using raster::testing::random_image;
using raster::testing::text_of;

template <class T>
class PngOf : public testing::Test {};
using SampleTypes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(PngOf, SampleTypes);

TYPED_TEST(PngOf, EverySizeAndChannelCountComesBackAsItWas) {
    const std::pair<int, int> sizes[] = {{1, 1}, {1, 7}, {7, 1}, {3, 5}, {64, 64}, {257, 33}, {1000, 2}};
    for (const auto& [width, height] : sizes) {
        for (int channels = 1; channels <= 4; ++channels) {
            const auto seed = std::uint64_t(width * 8 + channels);
            const auto image = random_image<TypeParam>(width, height, channels, seed);
            const auto file = raster::encode_png(image);
            ASSERT_TRUE(file);
            const auto decoded = raster::decode_image(*file, "x.png");
            ASSERT_TRUE(decoded) << decoded.error().message;
            const auto* same_type = std::get_if<raster::Image<TypeParam>>(&*decoded);
            ASSERT_NE(same_type, nullptr);
            EXPECT_TRUE(*same_type == image) << width << "x" << height << "x" << channels;
        }
    }
}

TYPED_TEST(PngOf, SmoothPicturesComeBackToo) {
    raster::Image<TypeParam> image(300, 200, 3);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 300; ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = TypeParam(x * (c + 1) + y * y);
    const auto file = raster::encode_png(image);
    ASSERT_TRUE(file);
    EXPECT_LT(file->size(), image.samples.size() * sizeof(TypeParam));
    const auto decoded = raster::decode_image(*file, "x.png");
    ASSERT_TRUE(decoded);
    EXPECT_TRUE(std::get<raster::Image<TypeParam>>(*decoded) == image);
}

TYPED_TEST(PngOf, TheSameSamplesGiveTheSameBytesOnEveryThread) {
    const auto image = random_image<TypeParam>(200, 100, 4, 7);
    const auto first = raster::encode_png(image);
    ASSERT_TRUE(first);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            const auto again = raster::encode_png(image);
            EXPECT_TRUE(again && *again == *first);
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TYPED_TEST(PngOf, ImpossibleImagesAreUsageErrors) {
    using Picture = raster::Image<TypeParam>;
    Picture torn(4, 4, 3);
    torn.samples.pop_back();
    Picture huge;  // 65536 squared, without the memory
    huge.width = huge.height = 65536;
    huge.channels = 4;
    Picture negative(1, 1, 1);
    negative.width = -1;
    for (const Picture& image : {Picture(), Picture(0, 5, 3), Picture(2, 2, 5), torn, huge, negative}) {
        const auto file = raster::encode_png(image);
        ASSERT_FALSE(file) << image.width << "x" << image.height << "x" << image.channels;
        EXPECT_EQ(file.error().kind, ErrorKind::usage);
    }
}

TEST(Png, TheHeaderSaysSizeDepthAndColourType) {
    const char color_types[] = {0, 4, 2, 6};
    for (int channels = 1; channels <= 4; ++channels) {
        const std::string type(1, color_types[channels - 1]);
        const std::string size("\0\0\1\2\0\0\0\3", 8), rest("\0\0\0", 3);
        const auto bits8 = raster::encode_png(Image8(258, 3, channels));
        const auto bits16 = raster::encode_png(Image16(258, 3, channels));
        ASSERT_TRUE(bits8 && bits16);
        EXPECT_EQ(text_of(*bits8).substr(16, 13), size + '\x08' + type + rest);
        EXPECT_EQ(text_of(*bits16).substr(16, 13), size + '\x10' + type + rest);
    }
}

class PngFile : public raster::testing::InFolder {};

TEST_F(PngFile, IsWrittenToItsPathAndErrorsNameIt) {
    const Image8 image = random_image<std::uint8_t>(20, 10, 4, 1);
    ASSERT_TRUE(raster::write_png(in_folder("x.png"), image));
    const auto loaded = raster::load_image8(in_folder("x.png"));
    ASSERT_TRUE(loaded);
    EXPECT_TRUE(*loaded == image);

    const auto status = raster::write_png(in_folder("none/x.png"), image);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::input_output);
    EXPECT_THAT(status.error().message, testing::HasSubstr(in_folder("none/x.png") + ": cannot write"));
}

TEST(PngOfAPalette, EveryPixelHasTheColourOfItsNumber) {
    raster::IndexedImage image = {random_image<std::uint8_t>(37, 21, 1, 5), {}};
    for (int i = 0; i < 256; ++i)
        image.palette.push_back({std::uint8_t(i), std::uint8_t(255 - i), std::uint8_t(i * 7)});
    const auto file = raster::encode_png(image);
    ASSERT_TRUE(file);
    const auto decoded = raster::decode_image8(*file, "x.png");
    ASSERT_TRUE(decoded) << decoded.error().message;
    ASSERT_EQ(decoded->channels, 3);
    for (std::size_t i = 0; i < image.indices.samples.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(decoded->samples[3 * i + c], image.palette[image.indices.samples[i]][c]);
}

}  // namespace
