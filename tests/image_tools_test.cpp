// image_tools_test.cpp: our files read by programs we did not write, theirs read by us; skipped without them.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <raster/image/decode.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>
#include <raster/image/write.h>

#include "image_testing.h"

namespace {

namespace fs = std::filesystem;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::testing::content;
using raster::testing::random_image;

/// Whether the command ends with exit code 0.
testing::AssertionResult runs(const std::string& command) {
    if (std::system((command + " >/dev/null").c_str()) == 0) return testing::AssertionSuccess();
    return testing::AssertionFailure() << command;
}

bool has(const std::string& program) { return bool(runs("command -v " + program)); }

class Tools : public raster::testing::InFolder {
protected:
    /// Whether ImageMagick reads the samples of `image` from the file.
    template <class T>
    testing::AssertionResult image_magick_reads(const std::string& path, const raster::Image<T>& image) {
        const std::string theirs = raw(path, image.channels, 8 * int(sizeof(T)));
        const std::size_t size = image.samples.size() * sizeof(T);
        if (theirs.size() == size && std::memcmp(theirs.data(), image.samples.data(), size) == 0)
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << path << ": " << theirs.size() << " bytes, ours " << size;
    }

    /// The samples as ImageMagick reads them, little-endian.
    std::string raw(const std::string& path, int channels, int bits) {
        const char* const names[] = {"gray", "graya", "rgb", "rgba"};
        const std::string out = in_folder("raw"), format = std::string(names[channels - 1]) + ":" + out;
        EXPECT_TRUE(runs("convert '" + path + "' -auto-orient -depth " + std::to_string(bits) +
                         " -endian LSB " + format));
        return content(out);
    }
};

TEST_F(Tools, PngcheckFindsNothingWrong) {
    if (!has("pngcheck")) GTEST_SKIP() << "no pngcheck";
    for (int channels = 1; channels <= 4; ++channels) {
        ASSERT_TRUE(raster::write_png(in_folder("8.png"), random_image<std::uint8_t>(40, 30, channels, 1)));
        ASSERT_TRUE(raster::write_png(in_folder("16.png"), random_image<std::uint16_t>(40, 30, channels, 1)));
        EXPECT_TRUE(runs("pngcheck -q " + in_folder("8.png")));
        EXPECT_TRUE(runs("pngcheck -q " + in_folder("16.png")));
    }
}

TEST_F(Tools, ImageMagickReadsTheSamplesOfOurPng) {
    if (!has("convert")) GTEST_SKIP() << "no ImageMagick";
    for (int channels = 1; channels <= 4; ++channels) {
        const Image8 image = random_image<std::uint8_t>(40, 30, channels, 2);
        const Image16 deep = random_image<std::uint16_t>(40, 30, channels, 3);
        ASSERT_TRUE(raster::write_image(in_folder("8.png"), image));
        ASSERT_TRUE(raster::write_image(in_folder("16.png"), deep));
        EXPECT_TRUE(image_magick_reads(in_folder("8.png"), image));
        EXPECT_TRUE(image_magick_reads(in_folder("16.png"), deep));
    }
}

TEST_F(Tools, ImageMagickReadsTheSamplesOfOurPnm) {
    if (!has("convert")) GTEST_SKIP() << "no ImageMagick";
    for (int channels : {1, 3}) {
        const Image8 image = random_image<std::uint8_t>(40, 30, channels, 2);
        const Image16 deep = random_image<std::uint16_t>(40, 30, channels, 3);
        const std::string extension = channels == 1 ? ".pgm" : ".ppm";
        ASSERT_TRUE(raster::write_image(in_folder("8") + extension, image));
        ASSERT_TRUE(raster::write_image(in_folder("16") + extension, deep));
        EXPECT_TRUE(image_magick_reads(in_folder("8") + extension, image));
        EXPECT_TRUE(image_magick_reads(in_folder("16") + extension, deep));
    }
}

TEST_F(Tools, IdiffSeesNoDifferenceBetweenOurFormatsAndSeesOneSample) {
    if (!has("idiff")) GTEST_SKIP() << "no OpenImageIO";
    Image8 image = random_image<std::uint8_t>(40, 30, 3, 4);
    ImageF floats(40, 30, 3);
    std::transform(image.samples.begin(), image.samples.end(), floats.samples.begin(),
                   [](std::uint8_t v) { return float(v) / 255.0f; });
    ASSERT_TRUE(raster::write_image(in_folder("a.png"), image));
    ASSERT_TRUE(raster::write_image(in_folder("a.ppm"), image));
    ASSERT_TRUE(raster::write_image(in_folder("a.pfm"), floats));
    EXPECT_TRUE(runs("idiff " + in_folder("a.png") + " " + in_folder("a.ppm")));
    EXPECT_TRUE(runs("idiff -fail 1e-6 " + in_folder("a.png") + " " + in_folder("a.pfm")));
    image.pixel(39, 0)[1] ^= 1;
    ASSERT_TRUE(raster::write_image(in_folder("b.png"), image));
    EXPECT_FALSE(runs("idiff " + in_folder("a.png") + " " + in_folder("b.png")));
}

TEST_F(Tools, WeReadWhatImageMagickReads) {
    if (!has("convert")) GTEST_SKIP() << "no ImageMagick";
    for (const auto& entry : fs::directory_iterator(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image")) {
        const std::string path = entry.path().string(), extension = entry.path().extension().string();
        if (extension == ".pfm" || extension == ".jpg") continue;
        const auto image = raster::load_image(path);
        ASSERT_TRUE(image) << image.error().message;
        std::visit([&](const auto& ours) { EXPECT_TRUE(image_magick_reads(path, ours)); }, *image);
    }
}

// Decoders may differ by rounding and by how they stretch colour; not by much.
TEST_F(Tools, OurJpegIsCloseToImageMagicks) {
    if (!has("convert")) GTEST_SKIP() << "no ImageMagick";
    for (const char* name : {"baseline.jpg", "progressive.jpg", "grey.jpg", "full.jpg"}) {
        const std::string path = std::string(RASTER_SOURCE_DIR "/tests/fuzz/corpus/image/") + name;
        const auto image = raster::load_image8(path);
        ASSERT_TRUE(image);
        const std::string theirs = raw(path, image->channels, 8);
        ASSERT_EQ(theirs.size(), image->samples.size());
        int most = 0;
        for (std::size_t i = 0; i < theirs.size(); ++i)
            most = std::max(most, std::abs(int(image->samples[i]) - int(std::uint8_t(theirs[i]))));
        EXPECT_LE(most, 8) << name;
    }
}

TEST(Textures, AllPicturesOfAssimpsTestModelsAreRead) {
    const fs::path models = "/usr/share/assimp/models";
    if (!fs::exists(models)) GTEST_SKIP() << "no assimp-testmodels";
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        std::string extension = entry.path().extension().string();
        for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
        const std::string pictures = ".png .jpg .bmp .tga";
        if (extension.empty() || pictures.find(extension) == std::string::npos) continue;
        const auto image = raster::load_image8(entry.path().string());
        EXPECT_TRUE(image) << image.error().message;
        ++count;
    }
    EXPECT_GE(count, 60);
}

}  // namespace
