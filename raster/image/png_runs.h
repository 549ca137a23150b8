// png_runs.h: packs the rows of pictures with few colours fast, by runs and Huffman codes.
#pragma once

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// The rows of a picture of one channel, each led by the filter "none", as a zlib stream (RFC 1950 and 1951). Of
/// matches it knows only runs of one colour, within a row. The same bytes for every number of threads. Throws
/// std::bad_alloc.
Bytes pack_runs(const Image8& image);

}  // namespace raster
