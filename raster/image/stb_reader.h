// stb_reader.h: stb_image behind the checks it lacks. For decode.cpp; others use decode.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>

#include <raster/image/image.h>
#include <raster/image/limits.h>
#include <raster/result.h>

namespace raster {

enum class StbFormat { png, jpeg, bmp, tga };

/// Decodes a file of the given format with the channels it has; 16 bits only from PNG. The result depends on
/// nothing but the bytes. What stb_image (2.27) lets pass and this refuses, as bad_input:
/// - sizes above `limits`, and sizes that so few bytes cannot unpack to, before decoding;
/// - a file that ends early (stb leaves the rest of the picture uninitialised);
/// - a PNG chunk with a wrong checksum, Apple's CgBI dialect (stb swaps its red and blue), data that unpack
///   to far more than the header's size;
/// - a JPEG of so many scans that decoding would take minutes.
/// A pixel of a BMP that points past the palette is black.
Result<std::variant<Image8, Image16>> read_with_stb(std::span<const std::byte> file, const std::string& name,
                                                    StbFormat format, const ImageLimits& limits);

}  // namespace raster
