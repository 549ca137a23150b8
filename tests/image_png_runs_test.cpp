// image_png_runs_test.cpp: what pack_runs packs, libdeflate unpacks, checksum included; PNG files made so.
#include <raster/image/decode.h>
#include <raster/image/png.h>
#include <raster/image/png_runs.h>
#include <raster/testing/matchers.h>
#include <raster/tiles/parallel.h>

#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#if !defined(RASTER_NO_THREADS)
#include <latch>
#include <thread>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <gtest/gtest.h>

#include "random.h"

namespace {

using raster::Bytes;
using raster::Image8;
using raster::pack_runs;
using raster::testing::Random;

void expect_unpacks(const Image8& image) {
    const std::size_t width = std::size_t(image.width), rows = std::size_t(image.height);
    Bytes expected(rows * (width + 1));
    for (std::size_t y = 0; y < rows; ++y)
        std::memcpy(expected.data() + y * (width + 1) + 1, image.pixel(0, int(y)), width);
    const Bytes packed = pack_runs(image);
    Bytes unpacked(expected.size());
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    ASSERT_EQ(libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), unpacked.data(),
                                         unpacked.size(), nullptr),
              LIBDEFLATE_SUCCESS)
        << width << "x" << rows;
    EXPECT_TRUE(unpacked == expected) << width << "x" << rows;
}

Image8 made_of(int width, int height, const std::function<int()>& color) {
    Image8 image(width, height, 1);
    for (std::uint8_t& sample : image.samples) sample = std::uint8_t(color());
    return image;
}

TEST(PngRuns, NoiseOfAnyNumberOfColoursUnpacks) {
    Random random(40);
    for (const int colors : {1, 2, 3, 33, 256})
        for (const auto& [width, height] : {std::pair(1, 1), {2, 3}, {5, 1}, {1000, 7}, {700, 900}})
            expect_unpacks(made_of(width, height, [&] { return random.integer(0, colors - 1); }));
}

TEST(PngRuns, RunsOfEveryLengthUnpack) {
    Image8 image(1200, 1200, 1);
    for (int length = 1; length <= image.height; ++length) {
        std::uint8_t* const row = image.pixel(0, length - 1);
        for (int x = 0; x < image.width; ++x) row[x] = std::uint8_t(x / length % 2 == 0 ? 200 : 0);
    }
    expect_unpacks(image);
}

TEST(PngRuns, ARunWithinNoiseIsFoundWhereverItStarts) {
    Random random(42);
    for (const int channels : {1, 3, 4})
        for (const int step : {1, channels}) {
            Image8 noise(120, 1, channels);
            for (std::uint8_t& sample : noise.samples) sample = std::uint8_t(random.integer(0, 255));
            const int bytes = int(noise.samples.size());
            const std::size_t size = pack_runs(noise).size();
            for (int start = step; start < bytes - 60; ++start) {
                Image8 image = noise;
                for (int i = start; i < start + 60; ++i)
                    image.samples[std::size_t(i)] = image.samples[std::size_t(i - step)];
                EXPECT_LT(pack_runs(image).size(), size - 50) << channels << " " << step << " " << start;
            }
        }
}

TEST(PngRuns, CodesAreNeverLongerThanDeflateAllows) {
    // Counts like Fibonacci's numbers would make codes of 21 bits.
    Image8 image(1, 1 << 17, 1);
    std::size_t next = 0;
    for (std::size_t color = 1, count = 1, later = 1; next < image.samples.size(); ++color) {
        for (std::size_t i = 0; i < count && next < image.samples.size(); ++i)
            image.samples[next++] = std::uint8_t(color);
        count = std::exchange(later, count + later);
    }
    expect_unpacks(image);
}

TEST(PngRuns, ColoursWithTheLongestCodesMayStandSideBySide) {
    std::vector<std::uint8_t> colors;
    for (std::size_t color = 1, count = 1, later = 1; color <= 22; ++color) {
        colors.insert(colors.end(), count, std::uint8_t(color));
        count = std::exchange(later, count + later);
    }
    Random random(43);
    for (int i = int(colors.size()) - 1; i > 20; --i)
        std::swap(colors[std::size_t(i)], colors[std::size_t(random.integer(20, i))]);
    // Rare runs too, whose codes have five more bits and one for the distance.
    for (int color = 23; color < 27; ++color)
        colors.insert(colors.begin() + 4, std::size_t(140 + 35 * (color - 23)), std::uint8_t(color));
    Image8 image(int(colors.size()), 1, 1);
    image.samples = colors;
    expect_unpacks(image);
}

TEST(PngRuns, AWholeColourIsNextToNothing) { EXPECT_LT(pack_runs(Image8(3840, 2160, 1, 7)).size(), 20'000u); }

TEST(PngRuns, TheFastWayHoldsTheSamePictures) {
    Random random(42);
    for (int channels = 1; channels <= 4; ++channels)
        for (const auto& [width, height] : {std::pair(1, 1), {1, 9}, {31, 17}, {800, 300}}) {
            Image8 image(width, height, channels);
            for (std::size_t i = 0; i < image.samples.size(); ++i)
                image.samples[i] = std::uint8_t(i / 1000 % 2 == 0 ? random.integer(0, 255) : 100);
            const raster::Result<Bytes> file = raster::encode_png_fast(image);
            ASSERT_TRUE(file);
            const raster::Result<Image8> back = raster::decode_image8(*file, "fast.png");
            ASSERT_TRUE(back) << channels << " " << width << "x" << height;
            EXPECT_EQ(*back, image);
        }
    EXPECT_FALSE(raster::encode_png_fast(Image8{}));
}

// Repeated pixels and repeated bytes of every length, at any place of a row, and what is in between.
Image8 patterned(int width, int height, int channels, Random& random) {
    Image8 image(width, height, channels);
    for (std::size_t i = 0; i < image.samples.size();) {
        const std::size_t back = random.integer(0, 1) == 0 ? 1 : std::size_t(channels);
        const auto end = std::min(image.samples.size(), i + std::size_t(random.integer(1, random.integer(1, 600))));
        const bool repeats = random.integer(0, 3) > 0 && i >= back;
        for (; i < end; ++i)
            image.samples[i] = repeats ? image.samples[i - back] : std::uint8_t(random.integer(0, 255));
    }
    return image;
}

TEST(PngRuns, PixelsAndBytesThatRepeatComeBack) {
    Random random(43);
    for (int channels = 1; channels <= 4; ++channels)
        for (const auto& [width, height] : {std::pair(1, 3), {2, 2}, {3, 50}, {33, 21}, {1500, 300}}) {
            const Image8 image = patterned(width, height, channels, random);
            const raster::Result<Image8> back = raster::decode_image8(*raster::encode_png_fast(image), "fast.png");
            ASSERT_TRUE(back) << channels << " " << width << "x" << height;
            EXPECT_EQ(*back, image) << channels << " " << width << "x" << height;
        }
}

TEST(PngRuns, PackedPixelsGiveTheSamePicture) {
    Random random(44);
    for (const bool has_alpha : {false, true})
        for (const auto& [width, height] : {std::pair(1, 1), {2, 3}, {6, 4}, {7, 5}, {9, 2}, {700, 200}}) {
            const Image8 image = patterned(width, height, has_alpha ? 4 : 3, random);
            std::vector<std::uint32_t> pixels;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const std::uint8_t* const p = image.pixel(x, y);
                    pixels.push_back(p[0] | p[1] << 8 | p[2] << 16 | std::uint32_t(has_alpha ? p[3] : 99) << 24);
                }
            const raster::PackedImage packed{width, height, pixels, has_alpha};
            EXPECT_TRUE(check_image(packed));
            EXPECT_EQ(unpacked(packed), image) << width << "x" << height;
            pixels.pop_back();
            EXPECT_FALSE(check_image(raster::PackedImage{width, height, pixels, has_alpha}));
        }
    EXPECT_FALSE(check_image(raster::PackedImage{0, 5, {}, false}));
    EXPECT_FALSE(check_image(raster::PackedImage{-1, -1, {}, false}));
}

#if !defined(RASTER_NO_THREADS)
TEST(PngRuns, AreTheSameForEveryNumberOfThreads) {
    Random random(41);
    const Image8 image = made_of(900, 900, [&] { return random.integer(0, 3); });
    const Bytes all = pack_runs(image);
    for (const int threads : {1, 2, 3}) {
        tbb::task_arena arena(threads);
        EXPECT_TRUE(arena.execute([&] { return pack_runs(image); }) == all) << threads;
    }
}

#if !defined(RASTER_PLAIN_THREADS)
// A thread that waits for the bands of one picture may be given another picture to write in the meantime.
TEST(PngRuns, PicturesWrittenAtOnceAreThoseWrittenOneByOne) {
    Random random(45);
    const Image8 large = patterned(1500, 500, 3, random), small = patterned(20, 10, 4, random);
    raster::Image16 deep(24, 12, 3);
    for (std::uint16_t& sample : deep.samples) sample = std::uint16_t(random.integer(0, 65535));
    const auto write = [&](int i) {
        if (i % 4 == 0) return *raster::encode_png_fast(large);
        if (i % 4 == 1) return *raster::encode_png(deep);
        return i % 4 == 2 ? *raster::encode_png(small) : *raster::encode_png_fast(small);
    };
    const Bytes expected[] = {write(0), write(1), write(2), write(3)};
    // One thread leaves many pictures for others to take and waits, until a second has written its large ones.
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(4, 2);
    std::vector<Bytes> files(3000), large_files(20);
    std::latch left(1), written(1);
    std::thread other([&] {
        arena.execute([&] {
            tbb::task_group group;
            for (std::size_t i = 0; i < files.size(); ++i) group.run([&, i] { files[i] = write(1 + int(i % 3)); });
            left.count_down();
            written.wait();
            group.wait();
        });
    });
    left.wait();
    arena.execute([&] {
        for (Bytes& file : large_files) file = write(0);
    });
    written.count_down();
    other.join();
    for (std::size_t i = 0; i < files.size(); ++i) ASSERT_TRUE(files[i] == expected[1 + i % 3]) << i;
    for (const Bytes& file : large_files) ASSERT_TRUE(file == expected[0]);
}
#endif
#endif

}  // namespace
