// pnm.h: the plainest picture files there are: PGM and PPM for whole numbers, PFM for floats.
#pragma once

#include <span>
#include <string>
#include <variant>

#include <raster/image/file.h>
#include <raster/image/image.h>
#include <raster/image/limits.h>

namespace raster {

/// A PGM file ("P5") of 1 or 2 channels, a PPM file ("P6") of 3 or 4; 16 bits are big-endian. The formats
/// know no alpha: it is left out, not blended. https://netpbm.sourceforge.net/doc/ppm.html
/// Errors of all encoders here: usage for an image that is empty, inconsistent or above the default limits.
Result<Bytes> encode_pnm(const Image8& image);
Result<Bytes> encode_pnm(const Image16& image);

/// A PFM file ("Pf" of 1 or 2 channels, "PF" of 3 or 4, without alpha), little-endian, bit for bit what the
/// image holds, NaN and infinity included. https://www.pauldebevec.com/Research/HDR/PFM/
Result<Bytes> encode_pfm(const ImageF& image);

/// Reads P5 and P6. A largest value (maxval) below 256 gives 8 bits, else 16; samples are stretched so that
/// maxval becomes 255 or 65535, rounded to nearest. Bytes after the picture are ignored. `name` is for
/// messages only. Errors: bad_input; the size is checked against `limits`, and against the bytes there are,
/// before memory is taken.
Result<std::variant<Image8, Image16>> decode_pnm(std::span<const std::byte> file, const std::string& name,
                                                 const ImageLimits& limits = {});

/// Reads Pf and PF of either byte order, bit for bit. The magnitude of the scale is a unit that only the
/// file's maker knows, and is not applied. Errors as decode_pnm.
Result<ImageF> decode_pfm(std::span<const std::byte> file, const std::string& name,
                          const ImageLimits& limits = {});

}  // namespace raster
