// png_runs.h: packs the rows of pictures with few colours fast, by runs and Huffman codes.
#pragma once

#include <cstdint>
#include <functional>

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// PNG's numbers of how a row's bytes are written: as they are, or less those of the row above.
enum class RowFilter : std::uint8_t { none = 0, up = 2 };

/// A picture row by row, in whatever form its pixels are.
struct Rows {
    std::size_t bytes;  ///< of a row
    int count;
    int pixel_bytes;  ///< 1 to 4
    /// Writes the row of a number, and up to 8 bytes of anything behind it. Called by several threads at once.
    std::function<void(int, std::uint8_t*)> read;
};

/// The rows of a picture, filtered, each led by the number of its filter, as a zlib stream (RFC 1950 and 1951). Of
/// matches it knows only bytes and pixels that repeat the last one, within a row. The same bytes for every number of
/// threads. Throws std::bad_alloc.
Bytes pack_runs(const Rows& rows, RowFilter filter = RowFilter::none);
Bytes pack_runs(const Image8& image, RowFilter filter = RowFilter::none);

}  // namespace raster
