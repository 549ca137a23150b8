// Animated PNG: the first frame is a PNG that any reader shows, and the chunks are as the specification has them.
#include <gtest/gtest.h>

#include <string>

#include <raster/image/apng.h>
#include <raster/image/png.h>
#include <raster/step/stage_pictures.h>
#include <raster/scene/shapes.h>
#include <raster/testing/matchers.h>

namespace {

using namespace raster;

/// The types of the chunks in order, and the numbers that fcTL and fdAT begin with.
struct Chunks {
    std::string types;
    std::vector<std::uint32_t> sequence;
};
Chunks chunks_of(const Bytes& file) {
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(file[at + i]);
        return value;
    };
    Chunks chunks;
    for (std::size_t at = 8; at < file.size(); at += 12 + number(at)) {
        const std::string type(reinterpret_cast<const char*>(&file[at + 4]), 4);
        chunks.types += type + " ";
        if (type == "fcTL" || type == "fdAT") chunks.sequence.push_back(number(at + 8));
    }
    return chunks;
}

TEST(Apng, HasAControlChunkForEachFrameAndNumbersThemAll) {
    const std::vector<Image8> frames = {Image8(4, 3, 3, 10), Image8(4, 3, 3, 20), Image8(4, 3, 3, 30)};
    const Result<Bytes> file = encode_apng(frames, 500);
    ASSERT_TRUE(file);
    const Chunks chunks = chunks_of(*file);
    EXPECT_EQ(chunks.types, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
    EXPECT_EQ(chunks.sequence, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(Apng, RefusesFramesThatDiffer) {
    EXPECT_FALSE(encode_apng({}, 500));
    const std::vector<Image8> frames = {Image8(4, 3, 3), Image8(3, 4, 3)};
    EXPECT_FALSE(encode_apng(frames, 500));
}

TEST(StagePictures, EndWithThePictureAndShowSomethingEach) {
    Camera camera;
    camera.position = {2, 1.5f, 3};
    const int width = 60, height = 45;
    const CameraMatrices matrices = *camera_matrices(camera, double(width) / height);
    const auto pictures = stage_pictures(cube(), matrices, width, height, {});
    ASSERT_EQ(pictures.size(), 10u);
    Target target(width, height);
    render(target, cube(), matrices, {});
    for (int y = 0; y < height - 2; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(pictures.back().image.pixel(x, y)[c], target.color8()[target.index(x, y)] >> (8 * c) & 255);
    for (std::size_t i = 1; i < pictures.size(); ++i) EXPECT_NE(pictures[i].image, pictures[i - 1].image);
}

}  // namespace
