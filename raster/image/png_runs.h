// png_runs.h: packs the rows of pictures with few colours fast, by runs and Huffman codes.
#pragma once

#include <cstdint>
#include <span>

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// Rows of bytes of a picture, each led by the number of its filter (PNG, 9.2), as a zlib stream (RFC 1950 and 1951).
/// `row_bytes` counts that number too; a pixel has 1 to 4 bytes. Of matches it knows only bytes and pixels that repeat
/// the last one, within a row. On all threads, and the same bytes for every number of them. Throws std::bad_alloc.
Bytes pack_runs(std::span<const std::uint8_t> rows, std::size_t row_bytes, int pixel_bytes);
/// The rows of an image, without a filter.
Bytes pack_runs(const Image8& image);

}  // namespace raster
