// image_data_url_test.cpp: base64 of every length and every byte against RFC 4648, bit by bit.
#include <raster/image/data_url.h>

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using raster::Bytes;

std::string by_bits(const Bytes& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
        std::size_t value = 0;
        for (std::size_t i = bit; i < bit + 6; ++i)
            value = 2 * value + (i / 8 < bytes.size() ? std::size_t(bytes[i / 8]) >> (7 - i % 8) & 1 : 0);
        text += digits[value];
    }
    while (text.size() % 4 != 0) text += '=';
    return text;
}

TEST(Base64, OfTheRfc) {
    const auto of = [](std::string text) {
        const auto bytes = std::as_bytes(std::span(text));
        return raster::base64(bytes);
    };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(Base64, OfEveryLengthAndByteIsAsBitByBit) {
    raster::testing::Random random(61);
    for (int size = 0; size < 300; ++size) {
        Bytes bytes;
        for (int i = 0; i < size; ++i) bytes.push_back(std::byte(random.integer(0, 255)));
        ASSERT_EQ(raster::base64(bytes), by_bits(bytes)) << size;
    }
    // Every digit at every place.
    Bytes bytes;
    for (int place = 0; place < 4; ++place)
        for (int value = 0; value < 64; ++value)
            for (int i = 0; i < 24; ++i) {
                const int bits = value << (18 - 6 * place);
                bytes.push_back(std::byte(bits >> (16 - 8 * (i % 3)) & 255));
            }
    EXPECT_EQ(raster::base64(bytes), by_bits(bytes));
}

TEST(Base64, IntoAStringThatIsThereLeavesNothingOfIt) {
    std::string text(1000, 'x');
    raster::base64(Bytes(5, std::byte(0)), text);
    EXPECT_EQ(text, "AAAAAAA=");
}

}  // namespace
