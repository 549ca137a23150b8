// png_reader.h: a fast way through the PNG files that are common. For decode.cpp; others use decode.h.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include <raster/image/image.h>
#include <raster/image/limits.h>

namespace raster {

/// Decodes a PNG file of 8 or 16 bits a sample, grey or colour, with or without alpha, and gives exactly what
/// read_with_stb gives, several times as fast. Nothing for every other file, be it rarer (palette, interlaced,
/// tRNS, fewer bits), above `limits` or damaged, and when memory runs out: read_with_stb then decodes it, or
/// says what is wrong.
std::optional<std::variant<Image8, Image16>> read_common_png(std::span<const std::byte> file,
                                                             const ImageLimits& limits);

}  // namespace raster
