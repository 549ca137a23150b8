// scissor.cpp: pixels inside and outside of a rectangle.
#include <raster/tiles/scissor.h>

#include <algorithm>

namespace raster::tiles {

std::uint64_t pixels_in(const PixelBox& limits, int x, int y) {
    const int x0 = std::clamp(limits.min_x - x, 0, block_size), x1 = std::clamp(limits.max_x + 1 - x, 0, block_size);
    const int y0 = std::clamp(limits.min_y - y, 0, block_size), y1 = std::clamp(limits.max_y + 1 - y, 0, block_size);
    if (x0 >= x1 || y0 >= y1) return 0;
    const std::uint64_t row = (0xffu >> (block_size - (x1 - x0))) << x0;
    const std::uint64_t rows = 0x0101010101010101u >> (block_size * (block_size - (y1 - y0))) << (block_size * y0);
    return row * rows;
}

void restore_outside(TileBuffer& tile, const Target& target, const PixelBox& limits) {
    const int right = std::min(tile.x + tile_size, target.width()) - 1;
    const int bottom = std::min(tile.y + tile_size, target.height()) - 1;
    if (limits.min_x <= tile.x && limits.min_y <= tile.y && limits.max_x >= right && limits.max_y >= bottom) return;
    if (tile.whole) split_tile(tile);
    for (int block = 0; block < block_count; ++block) {
        const int x = tile.x + block_x(block), y = tile.y + block_y(block);
        const PixelBox in_target{0, 0, target.width() - 1, target.height() - 1};
        std::uint64_t outside = pixels_in(in_target, x, y) & ~pixels_in(limits, x, y);
        if (outside == 0) continue;
        if (tile.uniform >> block & 1) {
            if (tile.block_slot[block] == 0) continue;
            expand_block(tile, block, target.depth_format());
        }
        for (; outside; outside &= outside - 1) {
            const int k = std::countr_zero(outside), column = k % block_size, row = k / block_size;
            const int i = first_pixel_of_block(block) + row * tile_size + column;
            tile.slot[i] = 0;
            tile.depth[i] = tile.cleared ? tile.clear_depth : target.raw_depth()[target.index(x + column, y + row)];
        }
    }
}

}  // namespace raster::tiles
