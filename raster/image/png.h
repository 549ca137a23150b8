// png.h: PNG files out of images, by stb_image_write for 8 bits and a small writer of our own for 16 and for palettes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// A picture of at most 256 colours: for each pixel the number of its colour.
struct IndexedImage {
    Image8 indices;                                    ///< one channel
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< RGB

    bool empty() const { return indices.empty(); }
};

/// A PNG file (https://www.w3.org/TR/png/) of 1 to 4 channels: grey, grey and alpha, RGB, RGBA. Samples are
/// stored as given: no alpha is added, dropped or multiplied, no gamma applied, and no colour space named, so
/// viewers will take them for sRGB. The same samples give the same bytes (under one version of libdeflate).
/// Errors: usage for an image that is empty, inconsistent or above the default ImageLimits.
Result<Bytes> encode_png(const Image8& image);
Result<Bytes> encode_png(const Image16& image);
/// The same picture, packed fast, by runs of bytes only and on all threads: for pictures to look at once.
Result<Bytes> encode_png_fast(const Image8& image);
/// A third of the bytes of RGB to pack, by the fast way. Every index has its colour.
Result<Bytes> encode_png(const IndexedImage& image);

/// encode_png, then write_file.
Status write_png(const std::string& path, const Image8& image);
Status write_png(const std::string& path, const Image16& image);

}  // namespace raster
