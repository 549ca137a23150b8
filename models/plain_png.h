// plain_png.h: PNG without compression, so that the bytes depend on no library's version.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include <raster/image/image.h>

namespace raster::models {

inline std::string big_endian(std::uint32_t x) {
    return {char(x >> 24), char(x >> 16), char(x >> 8), char(x)};
}

/// Length, type, data and CRC-32 (PNG specification, section 5.3 and annex D).
inline std::string chunk(std::string_view type, std::string_view data) {
    const std::string body = std::string(type) + std::string(data);
    std::uint32_t crc = 0xffffffffu;
    for (unsigned char byte : body) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return big_endian(std::uint32_t(data.size())) + body + big_endian(~crc);
}

/// An RGB image of at most 65,535 bytes with its row filters, which is one stored block (RFC 1951, 3.2.4).
inline std::string plain_png(const Image8& image) {
    std::string rows;
    for (int y = 0; y < image.height; ++y) {
        rows += '\0';  // row filter: none
        rows.append(reinterpret_cast<const char*>(image.pixel(0, y)), std::size_t(image.width) * 3);
    }
    std::uint32_t a = 1, b = 0;  // Adler-32 (RFC 1950)
    for (unsigned char byte : rows) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = std::uint32_t(rows.size());
    std::string stream = {0x78, 0x01, 0x01};
    for (std::uint32_t half : {size, ~size}) stream += {char(half), char(half >> 8)};
    stream += rows + big_endian(b << 16 | a);

    std::string header = big_endian(std::uint32_t(image.width)) + big_endian(std::uint32_t(image.height));
    header += {8, 2, 0, 0, 0};  // 8 bits, RGB, deflate, adaptive filters, not interlaced
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stream) + chunk("IEND", "");
}

}  // namespace raster::models
