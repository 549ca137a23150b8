// png_filters.h: undoes the five filters of PNG's rows.
#pragma once

#include <cstddef>
#include <cstdint>

namespace raster {

/// Undoes the filters of `height` rows (PNG, 9.2), each led by its filter's number. Row y goes to out + y * out_stride,
/// which may be where rows up to y were. `step` is the bytes of a pixel. False if there is no such filter.
bool undo_png_filters(int step, const std::uint8_t* in, std::size_t row_bytes, std::uint32_t height, std::uint8_t* out,
                      std::size_t out_stride);

}  // namespace raster
