// png.h: PNG files out of images, by stb_image_write for 8 bits and a small writer of our own for the rest.
#pragma once

#include <array>
#include <cstdint>
#include <span>
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

/// A picture in packed pixels, as a Target has it: r | g << 8 | b << 16 | a << 24, rows from top to bottom.
struct PackedImage {
    int width, height;
    std::span<const std::uint32_t> pixels;
    bool has_alpha;  ///< or it is left out
};

/// Whether it can be written, as check_image of limits.h tells of others.
Status check_image(const PackedImage& image);

/// RGB, or RGBA where it has alpha. Made on all threads. Throws std::bad_alloc.
Image8 unpacked(const PackedImage& image);

/// A PNG file (https://www.w3.org/TR/png/) of 1 to 4 channels: grey, grey and alpha, RGB, RGBA. Samples are
/// stored as given: no alpha is added, dropped or multiplied, no gamma applied, and no colour space named, so
/// viewers will take them for sRGB. The same samples give the same bytes (under one version of libdeflate).
/// Errors: usage for an image that is empty, inconsistent or above the default ImageLimits.
Result<Bytes> encode_png(const Image8& image);
Result<Bytes> encode_png(const Image16& image);
/// The same picture, packed fast, by runs of bytes and pixels only and on all threads: 3 to 8 ms on two cores where
/// encode_png takes 20 to 30, for 0.95 to 1.5 times the bytes (pictures of 1920x1080).
Result<Bytes> encode_png_fast(const Image8& image);
/// A third of the bytes of RGB to pack, by the fast way. Every index has its colour.
Result<Bytes> encode_png(const IndexedImage& image);

/// encode_png, then write_file.
Status write_png(const std::string& path, const Image8& image);
Status write_png(const std::string& path, const Image16& image);

}  // namespace raster
