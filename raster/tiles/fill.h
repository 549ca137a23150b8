// fill.h: driver of stage 11 where all pixels get one colour, which is packed once.
#pragma once

#include <raster/tiles/tile.h>

namespace raster::tiles {

/// Blends a packed colour into pixels of the block that begins at pixel (x, y) of an rgba8 target without extra planes;
/// `mask` holds pixels of the target only, bit 8 r + c for row r and column c.
void fill_block(Target& target, Blend blend, std::uint32_t color, int x, int y, std::uint64_t mask);

/// The same for all pixels of `blocks` blocks beside each other.
void fill_run(Target& target, Blend blend, std::uint32_t color, int x, int y, int blocks);

}  // namespace raster::tiles
