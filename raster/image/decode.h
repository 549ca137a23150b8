// decode.h: pictures out of files, whatever the format: textures, goldens, what a diff compares.
#pragma once

#include <span>
#include <string>
#include <variant>

#include <raster/image/image.h>
#include <raster/image/limits.h>
#include <raster/result.h>

namespace raster {

/// A picture in the type its file has: 8 or 16 bits, or floats.
using AnyImage = std::variant<Image8, Image16, ImageF>;

/// Reads PNG (any depth, palette, transparency, interlaced), JPEG (8 bits, baseline and progressive), BMP
/// (not RLE), TGA, PGM and PPM (P5, P6) and PFM, told apart by their first bytes; TGA has no signature and is
/// taken for one by its name (.tga) or its TRUEVISION-XFILE footer. Channels are those of the file, row 0 is
/// the top row, samples are as stored: no gamma, no colour profile, no Exif rotation is applied.
/// `name` is for messages. Errors: bad_input for a file that is damaged, cut short, in another format, or
/// whose header gives a size of zero or above `limits`, told before memory is taken for it; input_output if
/// memory runs out. Never undefined, never without end: equal bytes give equal results.
Result<AnyImage> decode_image(std::span<const std::byte> file, const std::string& name,
                              const ImageLimits& limits = {});

/// decode_image, then the type asked for. 16 bits become 8 by v * 255 / 65535 rounded to nearest, 8 become 16
/// by v * 257; floats are v / 255 or v / 65535. A PFM as whole numbers is bad_input: its range is unknown.
Result<Image8> decode_image8(std::span<const std::byte> file, const std::string& name,
                             const ImageLimits& limits = {});
Result<Image16> decode_image16(std::span<const std::byte> file, const std::string& name,
                               const ImageLimits& limits = {});
Result<ImageF> decode_image_float(std::span<const std::byte> file, const std::string& name,
                                  const ImageLimits& limits = {});

/// read_file, then decode. Only regular files are opened; files that no picture within the limits needs
/// (16 bytes a pixel and a megabyte) are refused.
Result<AnyImage> load_image(const std::string& path, const ImageLimits& limits = {});
Result<Image8> load_image8(const std::string& path, const ImageLimits& limits = {});
Result<Image16> load_image16(const std::string& path, const ImageLimits& limits = {});
Result<ImageF> load_image_float(const std::string& path, const ImageLimits& limits = {});

}  // namespace raster
