// png_runs.h: packs the rows of pictures with few colours fast, by runs and Huffman codes.
#pragma once

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// Rows of bytes, each led by the number of its PNG filter, as a zlib stream (RFC 1950 and 1951). Of matches it knows
/// only runs of one byte, within a row. The same bytes for every number of threads. Throws std::bad_alloc.
Bytes pack_runs(const Image8& rows, std::uint8_t filter = 0);

}  // namespace raster
