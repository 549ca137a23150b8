// tiling.h: the tiles of a target: how large they are, and how many.
#pragma once

#include <cstddef>

namespace raster::tiles {

inline constexpr int tile_bits = 6;
inline constexpr int tile_size = 1 << tile_bits;

/// So many tiles cover so many pixels.
inline constexpr int tiles_along(int pixels) { return (pixels + tile_size - 1) / tile_size; }
inline constexpr std::size_t tile_count(int width, int height) {
    return std::size_t(tiles_along(width)) * std::size_t(tiles_along(height));
}

}  // namespace raster::tiles
