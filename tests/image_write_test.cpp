// image_write_test.cpp: the file name chooses the format, and says so before anything is rendered.
#include <raster/image/write.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <raster/image/decode.h>

#include "image_testing.h"

namespace {

using raster::ErrorKind;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::output_format;
using raster::OutputFormat;
using raster::testing::content;
using raster::testing::random_image;
using testing::HasSubstr;
using testing::StartsWith;

class Write : public raster::testing::InFolder {};

TEST_F(Write, TheExtensionChoosesTheFormat) {
    const Image8 rgb = random_image<std::uint8_t>(5, 4, 3, 1), grey = random_image<std::uint8_t>(5, 4, 1, 2);
    const Image16 deep = random_image<std::uint16_t>(5, 4, 3, 3);
    const ImageF floats = random_image<float>(5, 4, 3, 4);
    ASSERT_TRUE(raster::write_image(in_folder("a.png"), rgb));
    ASSERT_TRUE(raster::write_image(in_folder("b.PPM"), rgb));
    ASSERT_TRUE(raster::write_image(in_folder("c.pgm"), grey));
    ASSERT_TRUE(raster::write_image(in_folder("d.x.pfm"), floats));
    ASSERT_TRUE(raster::write_image(in_folder("e.png"), deep));
    ASSERT_TRUE(raster::write_image(in_folder("f.ppm"), deep));
    EXPECT_THAT(content(in_folder("a.png")), StartsWith("\x89PNG"));
    EXPECT_THAT(content(in_folder("b.PPM")), StartsWith("P6"));
    EXPECT_THAT(content(in_folder("c.pgm")), StartsWith("P5"));
    EXPECT_THAT(content(in_folder("d.x.pfm")), StartsWith("PF"));

    EXPECT_TRUE(*raster::load_image8(in_folder("a.png")) == rgb);
    EXPECT_TRUE(*raster::load_image8(in_folder("b.PPM")) == rgb);
    EXPECT_TRUE(*raster::load_image8(in_folder("c.pgm")) == grey);
    EXPECT_TRUE(*raster::load_image_float(in_folder("d.x.pfm")) == floats);
    EXPECT_TRUE(*raster::load_image16(in_folder("e.png")) == deep);
    EXPECT_TRUE(*raster::load_image16(in_folder("f.ppm")) == deep);
}

TEST_F(Write, PackedPixelsBecomeAnyFormatOfWholeNumbers) {
    const std::uint32_t pixels[] = {0x40434241, 0x80636261};
    const raster::PackedImage image{2, 1, pixels, false};
    ASSERT_TRUE(raster::write_image(in_folder("x.ppm"), image));
    EXPECT_EQ(content(in_folder("x.ppm")), "P6\n2 1\n255\nABCabc");
    ASSERT_TRUE(raster::write_image(in_folder("x.png"), image));
    EXPECT_EQ(raster::load_image8(in_folder("x.png"))->samples,
              (std::vector<std::uint8_t>{0x41, 0x42, 0x43, 0x61, 0x62, 0x63}));
    EXPECT_FALSE(raster::write_image(in_folder("y.pgm"), image));
    EXPECT_FALSE(raster::write_image(in_folder("y.ppm"), raster::PackedImage{3, 1, pixels, false}));
}

TEST_F(Write, GreyInAPpmIsRepeated) {
    Image8 grey(1, 1, 2);
    grey.samples = {'A', 1};
    ASSERT_TRUE(raster::write_image(in_folder("x.ppm"), grey));
    EXPECT_EQ(content(in_folder("x.ppm")), "P6\n1 1\n255\nAAA");
}

TEST_F(Write, UnknownExtensionsAndFormatsThatDoNotFitAreUsageErrorsAndWriteNothing) {
    const Image8 rgb(2, 2, 3);
    const ImageF floats(2, 2, 3);
    const std::pair<raster::Status, const char*> cases[] = {
        {raster::write_image(in_folder("x.jpg"), rgb), "x.jpg: the extension must be .png, .ppm, .pgm"},
        {raster::write_image(in_folder("x"), rgb), "the extension must be"},
        {raster::write_image(in_folder(".png"), rgb), "the extension must be"},
        {raster::write_image(in_folder("x.png."), rgb), "the extension must be"},
        {raster::write_image("", rgb), "the extension must be"},
        {raster::write_image(folder, rgb), "the extension must be"},
        {raster::write_image(in_folder("x.pfm"), rgb), "x.pfm: a PFM holds floats"},
        {raster::write_image(in_folder("x.pgm"), rgb), "x.pgm: a PGM holds grey"},
        {raster::write_image(in_folder("x.png"), floats), "x.png: floats are written as .pfm"},
        {raster::write_image(in_folder("x.png"), Image8()), "0x0 pixels"},
        {raster::write_image(in_folder("x.pfm"), ImageF(1, 1, 5)), "5 channels"},
    };
    for (const auto& [status, words] : cases) {
        ASSERT_FALSE(status) << words;
        EXPECT_EQ(status.error().kind, ErrorKind::usage);
        EXPECT_THAT(status.error().message, HasSubstr(words));
    }
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(Write, DevicesAndStandardOutputNeedNoExtension) {
    EXPECT_TRUE(raster::write_image("/dev/null", Image8(2, 2, 3)));
    EXPECT_TRUE(raster::write_image("/dev/null", ImageF(2, 2, 3)));
    EXPECT_EQ(*output_format("-", OutputFormat::png), OutputFormat::png);
    EXPECT_EQ(*output_format("-", OutputFormat::pfm), OutputFormat::pfm);
    const auto full = raster::write_image("/dev/full", Image8(2, 2, 3));
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().kind, ErrorKind::input_output);
}

}  // namespace
