// image_png_reader_test.cpp: the fast PNG reader gives what stb_image gives, or nothing; damage never gets through.
#include <raster/image/png_reader.h>

#include <raster/image/decode.h>
#include <raster/image/file.h>
#include <raster/image/stb_reader.h>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using raster::Bytes;
using raster::read_common_png;
using raster::read_with_stb;
using raster::StbFormat;
using raster::testing::Random;

// ------------------------------------------------------- a PNG writer that knows every filter and packs nothing

void append(Bytes& bytes, std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i) bytes.push_back(std::byte(value >> (8 * i)));
}

std::uint32_t crc32(const std::byte* data, std::size_t size) {
    std::uint32_t crc = 0xffffffff;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= std::uint32_t(data[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
    }
    return ~crc;
}

void append_chunk(Bytes& file, const char* type, const Bytes& data) {
    append(file, std::uint32_t(data.size()), 4);
    const std::size_t start = file.size();
    for (int i = 0; i < 4; ++i) file.push_back(std::byte(type[i]));
    file.insert(file.end(), data.begin(), data.end());
    append(file, crc32(file.data() + start, file.size() - start), 4);
}

/// A zlib stream of blocks that are stored as they are (RFC 1950, 1951).
Bytes stored(const Bytes& data) {
    Bytes out = {std::byte(0x78), std::byte(0x01)};
    for (std::size_t start = 0; start == 0 || start < data.size(); start += 65535) {
        const std::size_t size = std::min<std::size_t>(data.size() - start, 65535);
        out.push_back(std::byte(start + size == data.size()));
        for (const std::size_t v : {size, ~size})
            out.push_back(std::byte(v & 255)), out.push_back(std::byte(v >> 8 & 255));
        out.insert(out.end(), data.begin() + std::ptrdiff_t(start), data.begin() + std::ptrdiff_t(start + size));
    }
    std::uint32_t a = 1, b = 0;
    for (const std::byte v : data) a = (a + std::uint32_t(v)) % 65521, b = (b + a) % 65521;
    append(out, b << 16 | a, 4);
    return out;
}

/// Random bytes as filtered rows, which are a picture whatever they say: every filter, or only `filter`.
Bytes random_png(Random& random, int width, int height, int bits, int color_type, int filter, int pieces = 1) {
    constexpr int channels_of[] = {1, 0, 3, 1, 2, 0, 4};
    const int row = (width * channels_of[color_type] * bits + 7) / 8;
    Bytes rows;
    for (int y = 0; y < height; ++y) {
        rows.push_back(std::byte(filter >= 0 ? filter : random.integer(0, 4)));
        for (int i = 0; i < row; ++i) rows.push_back(std::byte(random.integer(0, 255)));
    }
    Bytes header, file;
    append(header, std::uint32_t(width), 4);
    append(header, std::uint32_t(height), 4);
    for (const int v : {bits, color_type, 0, 0, 0}) header.push_back(std::byte(v));
    for (const char v : {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'}) file.push_back(std::byte(v));
    append_chunk(file, "IHDR", header);
    append_chunk(file, "tEXt", Bytes(7, std::byte('x')));
    const Bytes packed = stored(rows);
    for (int i = 0; i < pieces; ++i) {
        const auto at = [&](int k) {
            return packed.begin() + std::ptrdiff_t(packed.size() * std::size_t(k) / std::size_t(pieces));
        };
        append_chunk(file, "IDAT", Bytes(at(i), at(i + 1)));
    }
    append_chunk(file, "IEND", {});
    return file;
}

TEST(PngReader, GivesWhatStbGivesForEveryKindAndFilter) {
    Random random(1);
    for (const int bits : {8, 16})
        for (const int color_type : {0, 2, 4, 6})
            for (int filter = -1; filter <= 4; ++filter)
                for (const int width : {1, 2, 3, 17}) {
                    const Bytes file = random_png(random, width, 9, bits, color_type, filter);
                    const auto fast = read_common_png(file, {});
                    const auto slow = read_with_stb(file, "a.png", StbFormat::png, {});
                    ASSERT_TRUE(fast) << bits << " " << color_type << " " << filter << " " << width;
                    ASSERT_TRUE(slow) << slow.error().message;
                    EXPECT_EQ(*fast, *slow) << bits << " " << color_type << " " << filter << " " << width;
                }
}

TEST(PngReader, JoinsDataInManyPieces) {
    Random random(2);
    const Bytes file = random_png(random, 200, 130, 8, 6, -1, 7);
    const auto fast = read_common_png(file, {});
    ASSERT_TRUE(fast);
    EXPECT_EQ(*fast, *read_with_stb(file, "a.png", StbFormat::png, {}));
}

TEST(PngReader, LeavesRareKindsToStb) {
    Random random(3);
    EXPECT_FALSE(read_common_png(random_png(random, 9, 4, 4, 0, 0), {}));
    EXPECT_FALSE(read_common_png(random_png(random, 9, 4, 8, 3, 0), {}));
    Bytes interlaced = random_png(random, 9, 4, 8, 2, 0);
    interlaced[28] = std::byte(1);
    EXPECT_FALSE(read_common_png(interlaced, {}));
}

TEST(PngReader, LeavesWhatIsAboveTheLimitsToStb) {
    Random random(4);
    const Bytes file = random_png(random, 50, 50, 8, 2, 0);
    EXPECT_FALSE(read_common_png(file, {.max_side = 49, .max_pixels = 1 << 20}));
    EXPECT_FALSE(read_common_png(file, {.max_side = 100, .max_pixels = 2499}));
}

TEST(PngReader, ADamagedFileGivesNothingOrWhatStbGives) {
    Random random(5);
    const Bytes whole = random_png(random, 20, 10, 8, 6, -1);
    for (std::size_t length = 0; length < whole.size(); length += 13)
        EXPECT_FALSE(read_common_png(std::span(whole).first(length), {}));
    for (int round = 0; round < 3000; ++round) {
        Bytes broken = whole;
        for (int i = random.integer(1, 3); i > 0; --i)
            broken[std::size_t(random.integer(0, int(broken.size()) - 1))] ^= std::byte(1 << random.integer(0, 7));
        const auto fast = read_common_png(broken, {});
        if (!fast) continue;
        const auto slow = read_with_stb(broken, "a.png", StbFormat::png, {});
        ASSERT_TRUE(slow) << slow.error().message;
        EXPECT_EQ(*fast, *slow);
    }
}

TEST(PngReader, AFilterThatDoesNotExistIsDamage) {
    Random random(6);
    EXPECT_FALSE(read_common_png(random_png(random, 5, 5, 8, 2, 5), {}));
}

}  // namespace
