// tile.h: 64 x 64 pixels while they are worked on: depths, who is visible where, and what is known of each 8 x 8 block.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
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

/// The first column of a block's pixels as bits, or of a tile's blocks: bit 8 r + c is the one in row r and column c.
inline constexpr std::uint64_t first_column = 0x0101010101010101u;

/// The depths and owners of a tile's pixels. A uniform block's pixels all belong to one slot, and are not written until
/// something else touches the block: full-screen triangles that hide each other then cost a few instructions a block.
struct TileBuffer {
    alignas(64) std::int32_t depth[tile_pixels];
    alignas(64) std::int32_t slot[tile_pixels];
    alignas(64) std::int32_t block_min[block_count];  ///< smallest depth in a block, or less
    alignas(64) std::int32_t block_max[block_count];  ///< largest depth in it, or more; below block_min beyond the target
    alignas(64) std::int32_t block_slot[block_count];
    std::uint64_t uniform;    ///< one bit a block
    bool whole;               ///< the whole tile belongs to whole_slot: what is said of single blocks does not hold
    std::int32_t whole_slot;
    DepthRange<float> whole_range;  ///< of the whole tile, always
    int block_columns, block_rows;  ///< so many of its blocks have pixels of the target
    int x, y;                 ///< of the tile's first pixel
    bool cleared;             ///< slot 0 is the target's pending clear, not its memory
    std::int32_t clear_depth;
    std::vector<Slot> slots;  ///< 0 stands for what the target held before
    std::vector<TileEntry> entries;

    DepthRange<float> block_range(int block) const { return {block_min[block], block_max[block]}; }
    void set_block_range(int block, DepthRange<float> r) { block_min[block] = r.min, block_max[block] = r.max; }
};

inline int block_x(int block) { return block % blocks_per_row * block_size; }
inline int block_y(int block) { return block / blocks_per_row * block_size; }
inline int block_of(int x, int y) { return y / block_size * blocks_per_row + x / block_size; }
inline int first_pixel_of_block(int block) { return block_y(block) * tile_size + block_x(block); }

/// Whether a block has pixels of the target.
inline bool in_target(const TileBuffer& tile, int block) {
    return block % blocks_per_row < tile.block_columns && block / blocks_per_row < tile.block_rows;
}
/// The range of a block that has none: neutral when ranges are joined.
inline constexpr DepthRange<float> no_depths{std::numeric_limits<std::int32_t>::max(),
                                             std::numeric_limits<std::int32_t>::min()};

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
    for (int b = 0; b < block_count; ++b) {
        tile.block_slot[b] = tile.whole_slot;
        tile.set_block_range(b, in_target(tile, b) ? tile.whole_range : no_depths);
    }
    tile.whole = false;
}

/// The extremes of `count` packs of depths, each `stride` after the one before.
inline DepthRange<float> extremes(const std::int32_t* smallest, const std::int32_t* largest, int count, int stride) {
    IntN low = load_int<FloatN>(smallest), high = load_int<FloatN>(largest);
    for (int i = 1; i < count; ++i) {
        low = min(low, load_int<FloatN>(smallest + i * stride));
        high = max(high, load_int<FloatN>(largest + i * stride));
    }
    DepthRange<float> r{low.v[0], high.v[0]};
    for (int lane = 1; lane < native_lanes; ++lane)
        r = {std::min(r.min, low.v[lane]), std::max(r.max, high.v[lane])};
    return r;
}

/// Looks at a block's depths, which are written out, for its range.
inline void measure_block(TileBuffer& tile, int block) {
    const std::int32_t* const p = tile.depth + first_pixel_of_block(block);
    DepthRange<float> r = extremes(p, p, block_size, tile_size);
    for (int column = native_lanes; column < block_size; column += native_lanes) {
        const DepthRange<float> more = extremes(p + column, p + column, block_size, tile_size);
        r = {std::min(r.min, more.min), std::max(r.max, more.max)};
    }
    tile.set_block_range(block, r);
}

/// Takes the tile's range from its blocks'.
inline void measure_tile(TileBuffer& tile) {
    tile.whole_range = extremes(tile.block_min, tile.block_max, block_count / native_lanes, native_lanes);
}

/// Reads a tile from the target, or notes that the target's pending clear stands for it.
inline void load_tile(TileBuffer& tile, const Target& target, int tile_x, int tile_y) {
    tile.x = tile_x * tile_size;
    tile.y = tile_y * tile_size;
    const int columns = std::min(tile_size, target.width() - tile.x),
              rows = std::min(tile_size, target.height() - tile.y);
    tile.block_columns = (columns + block_size - 1) / block_size,
    tile.block_rows = (rows + block_size - 1) / block_size;
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
    if (columns < tile_size || rows < tile_size) std::memset(tile.depth, 0, sizeof tile.depth);
    std::memset(tile.slot, 0, sizeof tile.slot);
    for (int row = 0; row < rows; ++row)
        std::memcpy(tile.depth + row * tile_size, target.raw_depth() + target.index(tile.x, tile.y + row),
                    std::size_t(columns) * sizeof(std::int32_t));
    for (int block = 0; block < block_count; ++block) {
        if (in_target(tile, block)) {
            measure_block(tile, block);
        } else {
            tile.set_block_range(block, no_depths);
        }
    }
    measure_tile(tile);
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
