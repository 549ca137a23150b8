// png_runs.h: packs the rows of pictures with few colours fast, by runs and Huffman codes.
#pragma once

#include <cstdint>
#include <functional>

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// Writes the bytes of row `y`. Called by several threads at once.
using RowWriter = std::function<void(int y, std::uint8_t* row)>;

/// Rows of bytes of a picture, each led by the number of its filter (PNG, 9.2), as a zlib stream (RFC 1950 and 1951).
/// `row_bytes` counts that number too; a pixel has 1 to 4 bytes. Of matches it knows only bytes and pixels that repeat
/// the last one, within a row. On all threads, and the same bytes for every number of them. Throws std::bad_alloc.
Bytes pack_runs(int rows, std::size_t row_bytes, int pixel_bytes, const RowWriter& write_row);
/// The rows of an image, without a filter.
Bytes pack_runs(const Image8& image);

}  // namespace raster
