// image_pnm_test.cpp: PGM, PPM and PFM byte for byte, and what is wrong with a header is told.
#include <raster/image/pnm.h>

#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image_testing.h"

namespace {

using namespace std::string_literals;
using raster::ErrorKind;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::testing::bytes_of;
using raster::testing::random_image;
using raster::testing::text_of;
using testing::HasSubstr;

Image8 image8(int width, int height, int channels, std::vector<std::uint8_t> samples) {
    Image8 image(width, height, channels);
    image.samples = std::move(samples);
    return image;
}

TEST(Pnm, FilesAreTheHeaderAndTheSamples) {
    const Image8 rgb = image8(2, 1, 3, {1, 2, 3, 4, 5, 6}), grey = image8(1, 2, 1, {65, 66});
    EXPECT_EQ(text_of(*raster::encode_pnm(rgb)), "P6\n2 1\n255\n\1\2\3\4\5\6");
    EXPECT_EQ(text_of(*raster::encode_pnm(grey)), "P5\n1 2\n255\nAB");
    EXPECT_EQ(text_of(*raster::encode_pnm(Image16(1, 1, 1, 0x4142))), "P5\n1 1\n65535\nAB");
}

TEST(Pnm, AlphaIsLeftOut) {
    const Image8 rgba = image8(2, 1, 4, {65, 66, 67, 1, 68, 69, 70, 2});
    const Image8 grey = image8(2, 1, 2, {65, 1, 66, 2});
    EXPECT_EQ(text_of(*raster::encode_pnm(rgba)), "P6\n2 1\n255\nABCDEF");
    EXPECT_EQ(text_of(*raster::encode_pnm(grey)), "P5\n2 1\n255\nAB");
}

TEST(Pnm, WhatIsWrittenIsRead) {
    for (int channels : {1, 3}) {
        const Image8 image = random_image<std::uint8_t>(31, 17, channels, 1);
        const auto read = raster::decode_pnm(*raster::encode_pnm(image), "x");
        ASSERT_TRUE(read);
        EXPECT_TRUE(std::get<Image8>(*read) == image);
        const Image16 deep = random_image<std::uint16_t>(31, 17, channels, 2);
        const auto read_deep = raster::decode_pnm(*raster::encode_pnm(deep), "x");
        ASSERT_TRUE(read_deep);
        EXPECT_TRUE(std::get<Image16>(*read_deep) == deep);
    }
}

TEST(Pnm, HeadersMayHoldCommentsAndAnyWhiteSpace) {
    const auto file = bytes_of("P5 # a comment\r\n#another\n\t2\v1 #\n 255\nABignored");
    const auto read = raster::decode_pnm(file, "x");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(std::get<Image8>(*read).samples, (std::vector<std::uint8_t>{'A', 'B'}));
}

TEST(Pnm, ALargestValueOtherThan255Stretches) {
    const auto read = raster::decode_pnm(bytes_of("P5 4 1 3\n\0\1\2\3"s), "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(std::get<Image8>(*read).samples, (std::vector<std::uint8_t>{0, 85, 170, 255}));
    const auto deep = raster::decode_pnm(bytes_of("P5 2 1 256\n\0\1\1\0"s), "x");
    ASSERT_TRUE(deep);
    EXPECT_EQ(std::get<Image16>(*deep).samples, (std::vector<std::uint16_t>{256, 65535}));
}

TEST(Pnm, BadFilesAreToldApart) {
    const std::pair<std::string, std::string> cases[] = {
        {"", "not a PGM"},
        {"P4 1 1 255\nA", "not a PGM"},
        {"P5", "header"},
        {"P5 x 1 255\nA", "header"},
        {"P5 -1 1 255\nA", "header"},
        {"P5 1.5 1 255\nA", "header"},
        {"P5 1 1 0\nA", "header"},
        {"P5 1 1 65536\nAA", "header"},
        {"P5 99999999999999999999 1 255\nA", "header"},
        {"P5 0 1 255\n", "0x1 pixels"},
        {"P6 16385 1 255\n", "16385x1 pixels: more than 16384 a side"},
        {"P6 16384 16384 255\n", "more than 134217728 in all"},
        {"P6 16384 8192 255\nABC", "truncated"},
        {"P6 1 1 255\nAB", "truncated"},
        {"P6 1 1 255", "truncated"},
        {"P5 1 1 65535\nA", "truncated"},
        {"P5 1 1 100\ne", "a sample is 101, the header says at most 100"},
    };
    for (const auto& [text, words] : cases) {
        const auto read = raster::decode_pnm(bytes_of(text), "bad.ppm");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().kind, ErrorKind::bad_input);
        EXPECT_THAT(read.error().message, HasSubstr("bad.ppm: ")) << text;
        EXPECT_THAT(read.error().message, HasSubstr(words)) << text;
    }
}

TEST(Pnm, TheCallersLimitsHold) {
    const auto file = bytes_of("P5 3 2 255\nABCDEF");
    EXPECT_TRUE(raster::decode_pnm(file, "x", {3, 6}));
    EXPECT_FALSE(raster::decode_pnm(file, "x", {2, 6}));
    EXPECT_FALSE(raster::decode_pnm(file, "x", {3, 5}));
}

TEST(Pfm, IsLittleEndianAndStartsWithTheBottomRow) {
    ImageF image(1, 2, 1);
    *image.pixel(0, 0) = 1.0f;   // 3f800000
    *image.pixel(0, 1) = -2.0f;  // c0000000
    EXPECT_EQ(text_of(*raster::encode_pfm(image)), "Pf\n1 2\n-1.0\n\0\0\0\xc0\0\0\x80\x3f"s);
}

TEST(Pfm, BothByteOrdersAreRead) {
    const auto big = raster::decode_pfm(bytes_of("PF 1 1 +2.5e1\n\x3f\x80\0\0\xc0\0\0\0\0\0\0\0"s), "x");
    const auto little = raster::decode_pfm(bytes_of("PF 1 1 -1\n\0\0\x80\x3f\0\0\0\xc0\0\0\0\0"s), "x");
    ASSERT_TRUE(big && little);
    EXPECT_EQ(big->samples, (std::vector<float>{1.0f, -2.0f, 0.0f}));
    EXPECT_TRUE(*big == *little);
}

TEST(Pfm, EveryFloatComesBackBitForBit) {
    for (int channels : {1, 3}) {
        ImageF image = random_image<float>(31, 17, channels, 3);
        image.samples[0] = std::numeric_limits<float>::infinity();
        image.samples[1] = -0.0f;
        image.samples[2] = std::numeric_limits<float>::denorm_min();
        image.samples[3] = std::numeric_limits<float>::quiet_NaN();
        const auto read = raster::decode_pfm(*raster::encode_pfm(image), "x");
        ASSERT_TRUE(read);
        ASSERT_EQ(read->samples.size(), image.samples.size());
        EXPECT_EQ(std::memcmp(read->samples.data(), image.samples.data(), 4 * image.samples.size()), 0);
    }
}

TEST(Pfm, AlphaIsLeftOut) {
    ImageF image(1, 1, 4);
    image.samples = {1, 2, 3, 0.5f};
    const auto read = raster::decode_pfm(*raster::encode_pfm(image), "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->samples, (std::vector<float>{1, 2, 3}));
}

TEST(Pfm, BadFilesAreToldApart) {
    const std::pair<std::string, std::string> cases[] = {
        {"P6 1 1 -1\n", "not a PFM"},
        {"PF 1 1 0\n", "header"},
        {"PF 1 1 -0.0\n", "header"},
        {"PF 1 1 nan\n", "header"},
        {"PF 1 1 e5\n", "header"},
        {"PF 1 x -1\n", "header"},
        {"PF 0 1 -1\n", "0x1 pixels"},
        {"Pf 100000 1 -1\n", "100000x1 pixels"},
        {"Pf 1 1 -1\nabc", "truncated"},
    };
    for (const auto& [text, words] : cases) {
        const auto read = raster::decode_pfm(bytes_of(text), "bad.pfm");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().kind, ErrorKind::bad_input);
        EXPECT_THAT(read.error().message, HasSubstr(words)) << text;
    }
}

TEST(Pnm, ImpossibleImagesAreUsageErrors) {
    EXPECT_EQ(raster::encode_pnm(Image8()).error().kind, ErrorKind::usage);
    EXPECT_EQ(raster::encode_pnm(Image16(1, 1, 5)).error().kind, ErrorKind::usage);
    EXPECT_EQ(raster::encode_pfm(ImageF(0, 3, 1)).error().kind, ErrorKind::usage);
}

}  // namespace
