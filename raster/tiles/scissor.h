// scissor.h: draws that may change a part of the target only: a tile is drawn as a whole, and the rest put back.
#pragma once

#include <raster/tiles/tile.h>

namespace raster::tiles {

/// The pixels of the 8 x 8 block at pixel (x, y) that lie in `limits`: bit 8 r + c is row r, column c.
std::uint64_t pixels_in(const PixelBox& limits, int x, int y);

/// Gives a tile's pixels outside of `limits` back to what the target held before the draw.
void restore_outside(TileBuffer& tile, const Target& target, const PixelBox& limits);

}  // namespace raster::tiles
