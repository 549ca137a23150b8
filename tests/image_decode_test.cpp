// image_decode_test.cpp: pictures of every format are read, and no file, however damaged, does harm.
#include <raster/image/decode.h>

#include <cstring>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <raster/image/png.h>
#include <raster/image/pnm.h>

#include "image_testing.h"

namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;
using raster::AnyImage;
using raster::Bytes;
using raster::ErrorKind;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::Result;
using raster::testing::bytes_of;
using raster::testing::content;
using raster::testing::random_image;
using raster::testing::text_of;
using testing::HasSubstr;

std::string u16(int v) { return {char(v & 255), char(v >> 8 & 255)}; }
std::string u32(std::uint32_t v) { return u16(int(v & 0xffff)) + u16(int(v >> 16)); }

std::string bmp(std::int32_t width, std::int32_t height, int bits, const std::string& palette_and_pixels,
                std::size_t palette = 0) {
    const auto offset = std::uint32_t(54 + palette);
    return "BM" + u32(0) + u32(0) + u32(offset) + u32(40) + u32(std::uint32_t(width)) +
           u32(std::uint32_t(height)) + u16(1) + u16(bits) + std::string(24, '\0') + palette_and_pixels;
}

std::string tga(int type, int width, int height, int bits, const std::string& data) {
    const std::string top_row_first = "\x20";
    return "\0\0"s + char(type) + std::string(9, '\0') + u16(width) + u16(height) + char(bits) +
           top_row_first + data;
}

/// Every file of the seed corpus, by name.
std::vector<std::pair<std::string, std::string>> corpus() {
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : fs::directory_iterator(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image"))
        files.emplace_back(entry.path().filename().string(), content(entry.path().string()));
    std::sort(files.begin(), files.end());
    return files;
}

/// Equal bit for bit, or the same error.
bool same(const Result<AnyImage>& a, const Result<AnyImage>& b) {
    if (!a || !b) return bool(a) == bool(b) && a.error().message == b.error().message;
    return std::visit(
        []<class A, class B>(const raster::Image<A>& x, const raster::Image<B>& y) {
            return std::is_same_v<A, B> && x.width == y.width && x.height == y.height &&
                   x.channels == y.channels &&
                   std::memcmp(x.samples.data(), y.samples.data(), x.samples.size() * sizeof(A)) == 0;
        },
        *a, *b);
}

std::string error_of(const std::string& file, const std::string& name = "bad.tga") {
    const auto image = raster::decode_image(bytes_of(file), name);
    if (image) return "no error";
    EXPECT_EQ(image.error().kind, ErrorKind::bad_input);
    return image.error().message;
}

TEST(Decode, EveryFormatOfTheCorpusIsReadWithItsSizeAndChannels) {
    const auto files = corpus();
    ASSERT_GE(files.size(), 25u);
    for (const auto& [name, file] : files) {
        const auto image = raster::decode_image(bytes_of(file), name);
        ASSERT_TRUE(image) << image.error().message;
        std::visit(
            [name = name]<class T>(const raster::Image<T>& picture) {
                EXPECT_EQ(picture.width, 13) << name;
                EXPECT_EQ(picture.height, 11) << name;
                const bool grey = name.find("grey") == 0 || name == "bit1.png";
                const bool alpha = name.find("rgba") == 0 || name.find("alpha") != std::string::npos ||
                                   name == "rle.tga" || name == "key.png" ||
                                   name.find("transparent") != std::string::npos;
                EXPECT_EQ(picture.channels, (grey ? 1 : 3) + (alpha ? 1 : 0)) << name;
                const bool deep = name.find("16.p") != std::string::npos || name == "key.png";
                EXPECT_EQ(sizeof(T) == 2, deep) << name;
            },
            *image);
    }
}

TEST(Decode, SamplesBecomeTheTypeAskedFor) {
    Image16 deep(5, 1, 1);
    deep.samples = {0, 128, 129, 65406, 65535};  // divided by 257: 0, 0.498, 0.502, 254.498, 255
    const auto file = raster::encode_png(deep);
    EXPECT_EQ(raster::decode_image8(*file, "x")->samples, (std::vector<std::uint8_t>{0, 0, 1, 254, 255}));
    EXPECT_EQ(raster::decode_image16(*file, "x")->samples, deep.samples);
    EXPECT_EQ(raster::decode_image_float(*file, "x")->samples[4], 1.0f);

    Image8 flat(3, 1, 1);
    flat.samples = {0, 1, 255};
    const auto flat_file = raster::encode_pnm(flat);
    EXPECT_EQ(raster::decode_image8(*flat_file, "x")->samples, flat.samples);
    EXPECT_EQ(raster::decode_image16(*flat_file, "x")->samples, (std::vector<std::uint16_t>{0, 257, 65535}));
    EXPECT_EQ(raster::decode_image_float(*flat_file, "x")->samples, (std::vector<float>{0, 1 / 255.0f, 1}));
}

TEST(Decode, EightBitsSurviveSixteen) {
    Image8 all(256, 1, 1);
    for (int v = 0; v < 256; ++v) all.samples[std::size_t(v)] = std::uint8_t(v);
    const auto deep = raster::decode_image16(*raster::encode_png(all), "x");
    ASSERT_TRUE(deep);
    EXPECT_TRUE(*raster::decode_image8(*raster::encode_png(*deep), "x") == all);
}

TEST(Decode, FloatsDoNotBecomeWholeNumbers) {
    const auto file = raster::encode_pfm(ImageF(1, 1, 3, 0.5f));
    EXPECT_TRUE(raster::decode_image_float(*file, "x.pfm"));
    const auto image = raster::decode_image8(*file, "x.pfm");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().message, "x.pfm: holds floats, not whole numbers");
}

TEST(Decode, AnUnknownFormatIsToldAndJunkIsNotTakenForATarga) {
    EXPECT_EQ(error_of("", "x.png"), "x.png: empty");
    EXPECT_THAT(error_of("GIF89a...", "x.gif"), HasSubstr("x.gif: not a PNG, JPEG, BMP, TGA"));
    const std::string targa = tga(2, 1, 1, 24, "BGR");
    EXPECT_THAT(error_of(targa, "x.png"), HasSubstr("not a PNG"));
    EXPECT_TRUE(raster::decode_image(bytes_of(targa), "x.TGA"));
    const std::string footer = std::string(8, '\0') + "TRUEVISION-XFILE.\0"s;
    EXPECT_TRUE(raster::decode_image(bytes_of(targa + footer), "x.png"));
}

TEST(Decode, SizesOfZeroOrTooMuchAreRefusedFromTheHeader) {
    const std::string png = text_of(*raster::encode_png(Image8(3, 3, 1)));
    const auto with_size = [&](const std::string& size) { return png.substr(0, 16) + size + png.substr(24); };
    EXPECT_THAT(error_of(with_size("\0\0\0\0\0\0\0\3"s)), HasSubstr("bad.tga: "));
    EXPECT_THAT(error_of(with_size("\0\0\x40\1\0\0\0\3"s)), HasSubstr("16385x3 pixels: more than 16384"));
    EXPECT_THAT(error_of(with_size("\0\0\x40\0\0\0\x40\0"s)), HasSubstr("more than 134217728 in all"));
    EXPECT_THAT(error_of(with_size("\xff\xff\xff\xff\xff\xff\xff\xff")), HasSubstr("bad.tga: "));

    EXPECT_THAT(error_of(bmp(0, 3, 24, "")), HasSubstr("0x3 pixels"));
    EXPECT_THAT(error_of(bmp(-5, 3, 24, "")), HasSubstr("-5x3 pixels"));
    EXPECT_THAT(error_of(bmp(20000, 3, 24, "")), HasSubstr("20000x3 pixels"));
    const auto lowest = std::numeric_limits<std::int32_t>::min();
    EXPECT_THAT(error_of(bmp(3, lowest, 24, "")), HasSubstr("3x2147483648 pixels"));
    EXPECT_THAT(error_of(tga(2, 0, 3, 24, "")), HasSubstr("bad.tga: "));
    EXPECT_THAT(error_of(tga(2, 65535, 65535, 24, "")), HasSubstr("65535x65535 pixels"));

    std::string jpeg = content(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/baseline.jpg");
    const std::size_t frame = jpeg.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    EXPECT_THAT(error_of(jpeg.replace(frame + 5, 4, "\xff\xff\xff\xff")), HasSubstr("65535x65535 pixels"));
    EXPECT_THAT(error_of(jpeg.replace(frame + 5, 4, "\0\0\0\1"s)), HasSubstr("bad.tga: "));
}

TEST(Decode, ASmallFileThatClaimsALargePictureIsRefusedBeforeDecoding) {
    std::string jpeg = content(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/baseline.jpg");
    jpeg.replace(jpeg.find("\xff\xc0") + 5, 4, "\x20\0\x20\0"s);
    const std::string words = "truncated: too few bytes for its size";
    EXPECT_THAT(error_of(jpeg), HasSubstr(words));
    EXPECT_THAT(error_of(bmp(8192, 8192, 1, std::string(8, '\xff'), 8)), HasSubstr(words));
    EXPECT_THAT(error_of(tga(10, 8192, 8192, 24, "\xff\1\2\3")), HasSubstr(words));
}

TEST(Decode, APngThatUnpacksToFarMoreThanItsSizeIsRefused) {
    // The header of a 1x1 picture before the data of a 4096x4096 one, with right checksums.
    const std::string small = text_of(*raster::encode_png(Image8(1, 1, 4)));
    const std::string large = text_of(*raster::encode_png(Image8(4096, 4096, 4)));
    EXPECT_THAT(error_of(small.substr(0, 33) + large.substr(33)), HasSubstr("unpacks to more than the size"));
}

TEST(Decode, AJpegOfEndlessScansIsRefused) {
    const std::string jpeg = content(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/progressive.jpg");
    const std::size_t end = jpeg.rfind("\xff\xd9"), last_scan = jpeg.rfind("\xff\xda");
    std::string file = jpeg.substr(0, end);
    for (int i = 0; i < 200; ++i) file += jpeg.substr(last_scan, end - last_scan);
    file += jpeg.substr(end);
    const auto image = raster::decode_image(bytes_of(file), "x.jpg", {100, 1000});
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error().message, HasSubstr("too many scans"));
}

TEST(Decode, AJpegWhoseHuffmanTableIsTooLargeIsRefused) {
    std::string jpeg = content(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/baseline.jpg");
    const std::string lengths = std::string(14, '\0') + "\x80\x81";  // 257 codes of 15 and 16 bits
    const std::string table = "\xff\xc4\x01\x14"s + '\0' + lengths + std::string(257, '\0');
    EXPECT_THAT(error_of(jpeg.insert(2, table)), HasSubstr("a Huffman table of more than 256 codes"));
}

TEST(Decode, WhatAJpegLeavesOutIsTheSameOnEveryRun) {
    // A restart interval of one block, but no restart markers: stb stops after the first block.
    std::string jpeg = content(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/grey.jpg");
    ASSERT_TRUE(raster::decode_image8(bytes_of(jpeg), "x.jpg"));  // leaves its samples in freed memory
    jpeg.insert(jpeg.find("\xff\xda"), "\xff\xdd\0\4\0\1"s);
    const auto image = raster::decode_image8(bytes_of(jpeg), "x.jpg");
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_NE(*image->pixel(0, 0), 0);
    EXPECT_EQ(*image->pixel(12, 0), 0);
    EXPECT_EQ(*image->pixel(12, 10), 0);
}

TEST(Decode, AFileCutShortAnywhereIsAnErrorAndNeverHalfAPicture) {
    for (const auto& [name, file] : corpus()) {
        const auto whole = raster::decode_image(bytes_of(file), name);
        for (std::size_t length = 0; length < file.size(); ++length) {
            const auto cut = raster::decode_image(bytes_of(file.substr(0, length)), name);
            if (cut) {
                // What may miss is what no pixel needs: the footer of a TGA, the padding of a BMP's last row.
                EXPECT_TRUE(same(cut, whole)) << name << " cut to " << length << " of " << file.size();
                EXPECT_TRUE(name.ends_with(".tga") || (name.ends_with(".bmp") && length + 3 >= file.size()))
                    << name << " cut to " << length << " of " << file.size();
            } else {
                EXPECT_EQ(cut.error().kind, ErrorKind::bad_input);
            }
        }
    }
}

TEST(Decode, ADamagedFileGivesTheSameOnEveryRun) {
    raster::testing::Random random(11);
    for (const auto& [name, file] : corpus()) {
        for (int round = 0; round < 60; ++round) {
            std::string damaged = file;
            for (int changes = random.integer(1, 8); changes > 0; --changes)
                damaged[std::size_t(random.integer(0, int(file.size()) - 1))] = char(random.bits());
            const Bytes bytes = bytes_of(damaged);
            const raster::ImageLimits limits{512, 100000};
            const auto first = raster::decode_image(bytes, name, limits);
            const auto second = raster::decode_image(bytes, name, limits);
            EXPECT_TRUE(same(first, second)) << name << " round " << round;
        }
    }
}

TEST(Decode, ABitFlippedInAPngIsFoundByItsChecksum) {
    const std::string png = text_of(*raster::encode_png(random_image<std::uint8_t>(9, 9, 3, 5)));
    for (std::size_t i = 8; i < png.size(); ++i) {
        std::string damaged = png;
        damaged[i] = char(damaged[i] ^ 4);
        EXPECT_NE(error_of(damaged), "no error") << "byte " << i;
    }
}

TEST(Decode, ApplesPngDialectIsRefusedAndNotShownWithRedAndBlueSwapped) {
    const std::string png = text_of(*raster::encode_png(Image8(1, 1, 4, 7)));
    const std::string chunk = "\0\0\0\4CgBI\x30\0\x20\x06\0\0\0\0"s;
    EXPECT_THAT(error_of(png.substr(0, 8) + chunk + png.substr(8)), HasSubstr("the first chunk is not IHDR"));
}

TEST(Decode, BmpRowsComeFromTheBottomUnlessTheHeightIsNegative) {
    const std::string rows = "BGRbgr\0\0AAAaaa\0\0"s;
    const auto up = raster::decode_image8(bytes_of(bmp(2, 2, 24, rows)), "x.bmp");
    const auto down = raster::decode_image8(bytes_of(bmp(2, -2, 24, rows)), "x.bmp");
    ASSERT_TRUE(up && down);
    EXPECT_EQ(text_of(bytes_of(std::string(up->samples.begin(), up->samples.end()))), "AAAaaaRGBrgb");
    EXPECT_EQ(text_of(bytes_of(std::string(down->samples.begin(), down->samples.end()))), "RGBrgbAAAaaa");
}

TEST(Decode, ABmpIndexPastThePaletteIsBlack) {
    const std::string palette = "BGR\0bgr\0"s;
    const auto image = raster::decode_image8(bytes_of(bmp(4, 1, 8, palette + "\0\1\2\xff"s, 8)), "x.bmp");
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(std::string(image->samples.begin(), image->samples.end()), "RGBrgb\0\0\0\0\0\0"s);
}

TEST(Decode, AnOs2BmpKeepsTheLastColoursOfItsPalette) {
    std::string palette;
    for (int i = 0; i < 256; ++i) palette += std::string(3, char(255 - i));
    const std::string header = u32(12) + u16(4) + u16(1) + u16(1) + u16(8);
    const std::string file = "BM" + u32(0) + u32(0) + u32(26 + 768) + header + palette + "\x00\x01\xfe\xff"s;
    const auto image = raster::decode_image8(bytes_of(file), "x.bmp");
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->samples, (std::vector<std::uint8_t>{255, 255, 255, 254, 254, 254, 1, 1, 1, 0, 0, 0}));
}

TEST(Decode, TargaRunsAreUnpacked) {
    const std::string three_times = "\x82"s + "BGR", two_as_they_are = "\x01"s + "bgrxyz";
    const std::string file = tga(10, 5, 1, 24, three_times + two_as_they_are);
    const auto image = raster::decode_image8(bytes_of(file), "x.tga");
    ASSERT_TRUE(image);
    EXPECT_EQ(std::string(image->samples.begin(), image->samples.end()), "RGBRGBRGBrgbzyx");
    EXPECT_THAT(error_of(file.substr(0, file.size() - 1)), HasSubstr("truncated"));
    EXPECT_THAT(error_of(tga(2, 2, 1, 24, "BGRbg")), HasSubstr("truncated"));
}

class Load : public raster::testing::InFolder {};

TEST_F(Load, OnlyRegularFilesWithAPictureInThemAreLoaded) {
    const Image8 image = random_image<std::uint8_t>(4, 4, 3, 1);
    ASSERT_TRUE(raster::write_png(in_folder("x.png"), image));
    EXPECT_TRUE(*raster::load_image8(in_folder("x.png")) == image);
    EXPECT_EQ(raster::load_image16(in_folder("x.png"))->channels, 3);
    EXPECT_EQ(raster::load_image_float(in_folder("x.png"))->channels, 3);
    EXPECT_TRUE(std::holds_alternative<Image8>(*raster::load_image(in_folder("x.png"))));

    for (const std::string& path : {folder, in_folder("none.png"), "/dev/zero"s}) {
        const auto loaded = raster::load_image8(path);
        ASSERT_FALSE(loaded);
        EXPECT_EQ(loaded.error().kind, ErrorKind::input_output) << path;
    }
}

TEST_F(Load, AFileFarLargerThanAnyPictureIsRefusedUnread) {
    std::ofstream(in_folder("x.png")) << "x";
    fs::resize_file(in_folder("x.png"), std::uintmax_t(1) << 40);
    const auto loaded = raster::load_image8(in_folder("x.png"));
    ASSERT_FALSE(loaded);
    EXPECT_THAT(loaded.error().message, HasSubstr("larger than the limit"));
}

}  // namespace
