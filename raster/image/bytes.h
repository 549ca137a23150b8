// bytes.h: numbers in the bytes of a file. For the readers of pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace raster {

using File = std::span<const std::byte>;

/// The byte at i; 0 past the end.
inline std::uint32_t byte_at(File file, std::size_t i) { return i < file.size() ? std::uint32_t(file[i]) : 0; }

/// Four bytes from i on, the lowest first.
inline std::uint32_t little_endian_at(File file, std::size_t i) {
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;) value = value << 8 | byte_at(file, i + k);
    return value;
}

/// Four bytes from i on, the highest first.
inline std::uint32_t big_endian_at(File file, std::size_t i) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | byte_at(file, i + k);
    return value;
}

}  // namespace raster
