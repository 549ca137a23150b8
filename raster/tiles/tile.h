// tile.h: 64 x 64 pixels while they are worked on: depths, who is visible where, and what is known of each 8 x 8 block.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include <raster/lanes.h>
#include <raster/target.h>
#include <raster/tiles/bin.h>
#include <raster/tiles/coarse.h>

namespace raster::tiles {

inline constexpr int tile_pixels = tile_size * tile_size;
inline constexpr int block_size = 8;
inline constexpr int blocks_per_row = tile_size / block_size;
inline constexpr int block_count = blocks_per_row * blocks_per_row;

/// The depths and owners of a tile's pixels. A uniform block's pixels all belong to one slot, and are not written until
/// something else touches the block: full-screen triangles that hide each other then cost a few instructions a block.
struct TileBuffer {
    alignas(64) std::int32_t depth[tile_pixels];
    alignas(64) std::int32_t slot[tile_pixels];
    DepthRange range[block_count];
    std::int32_t block_slot[block_count];
    std::uint64_t uniform;    ///< one bit a block
    bool whole;               ///< the whole tile belongs to whole_slot: what is said of single blocks does not hold
    std::int32_t whole_slot;
    DepthRange whole_range;   ///< of the whole tile, always
    int x, y;                 ///< of the tile's first pixel
    bool cleared;             ///< slot 0 is the target's pending clear, not its memory
    std::int32_t clear_depth;
    std::vector<Slot> slots;  ///< 0 stands for what the target held before
    std::vector<TileEntry> entries;
};

inline int block_x(int block) { return block % blocks_per_row * block_size; }
inline int block_y(int block) { return block / blocks_per_row * block_size; }
inline int first_pixel_of_block(int block) { return block_y(block) * tile_size + block_x(block); }

/// The encoded depths of lanes<FloatN> pixels in a row that begins at absolute pixel (x, y).
inline IntN depth_row(DepthFormat format, const DepthPlane<float>& plane, int x, int y) {
    const DepthPlane<FloatN> p{{plane.origin, plane.dadx, plane.dady}, plane.offset};
    return encode_depth(format, value_at(p, to_float(IntN(x) + lane_index<FloatN>()), FloatN(float(y))));
}

/// Writes a uniform block's depths and owners out, pixel by pixel, so that single pixels can be changed.
inline void expand_block(TileBuffer& tile, int block, DepthFormat format) {
    const std::int32_t slot = tile.block_slot[block];
    const int first = first_pixel_of_block(block);
    for (int row = 0; row < block_size; ++row)
        for (int column = 0; column < block_size; column += native_lanes) {
            const int i = first + row * tile_size + column;
            store_int(tile.slot + i, IntN(slot));
            store_int(tile.depth + i,
                      slot == 0 ? IntN(tile.clear_depth)
                                : depth_row(format, tile.slots[std::size_t(slot)].depth,
                                            tile.x + i % tile_size, tile.y + i / tile_size));
        }
    tile.uniform &= ~(std::uint64_t(1) << block);
}

/// Says of each block what was known of the whole tile, so that single blocks can be changed.
inline void split_tile(TileBuffer& tile) {
    tile.uniform = ~std::uint64_t(0);
    for (int b = 0; b < block_count; ++b) tile.block_slot[b] = tile.whole_slot, tile.range[b] = tile.whole_range;
    tile.whole = false;
}

/// Reads a tile from the target, or notes that the target's pending clear stands for it.
inline void load_tile(TileBuffer& tile, const Target& target, int tile_x, int tile_y) {
    tile.x = tile_x * tile_size;
    tile.y = tile_y * tile_size;
    tile.slots.assign(1, Slot{});
    tile.cleared = target.clear_is_pending();
    tile.uniform = 0;
    tile.whole = tile.cleared;
    if (tile.cleared) {
        tile.clear_depth = std::int32_t(target.pending_depth());
        tile.whole_slot = 0;
        tile.whole_range = {tile.clear_depth, tile.clear_depth};
        return;
    }
    const int columns = std::min(tile_size, target.width() - tile.x),
              rows = std::min(tile_size, target.height() - tile.y);
    if (columns < tile_size || rows < tile_size) std::memset(tile.depth, 0, sizeof tile.depth);
    std::memset(tile.slot, 0, sizeof tile.slot);
    for (int row = 0; row < rows; ++row)
        std::memcpy(tile.depth + row * tile_size, target.raw_depth() + target.index(tile.x, tile.y + row),
                    std::size_t(columns) * sizeof(std::int32_t));
    for (int block = 0; block < block_count; ++block) {
        const std::int32_t* p = tile.depth + first_pixel_of_block(block);
        IntN low = load_int<FloatN>(p), high = low;
        for (int row = 0; row < block_size; ++row)
            for (int column = 0; column < block_size; column += native_lanes) {
                const IntN d = load_int<FloatN>(p + row * tile_size + column);
                low = min(low, d), high = max(high, d);
            }
        tile.range[block] = {low.v[0], high.v[0]};
        for (int lane = 1; lane < native_lanes; ++lane)
            tile.range[block] = {std::min(tile.range[block].min, low.v[lane]),
                                 std::max(tile.range[block].max, high.v[lane])};
        if (block == 0) tile.whole_range = tile.range[0];
        tile.whole_range = {std::min(tile.whole_range.min, tile.range[block].min),
                            std::max(tile.whole_range.max, tile.range[block].max)};
    }
}

/// Writes a tile's depths back.
inline void store_depth(TileBuffer& tile, Target& target) {
    if (tile.whole) split_tile(tile);
    for (std::uint64_t rest = tile.uniform; rest; rest &= rest - 1)
        expand_block(tile, std::countr_zero(rest), target.depth_format());
    const int columns = std::min(tile_size, target.width() - tile.x),
              rows = std::min(tile_size, target.height() - tile.y);
    for (int row = 0; row < rows; ++row)
        std::memcpy(target.raw_depth() + target.index(tile.x, tile.y + row), tile.depth + row * tile_size,
                    std::size_t(columns) * sizeof(std::int32_t));
}

}  // namespace raster::tiles
