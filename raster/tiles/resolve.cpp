// resolve.cpp: the part of resolving a tile that needs no shader: depths, clears, and who is visible where.
#include <raster/tiles/resolve.h>

namespace raster::tiles {

namespace {

/// Writes the depths of one block to the target.
void write_block_depth(const TileBuffer& tile, int block, Target& target) {
    const int x = tile.x + block_x(block), y = tile.y + block_y(block);
    const int columns = std::min(block_size, target.width() - x), rows = std::min(block_size, target.height() - y);
    const bool uniform = tile.uniform >> block & 1;
    const DepthPlane<float> plane = uniform ? tile.slots[std::size_t(tile.block_slot[block])].depth : DepthPlane<float>{};
    const DepthFormat format = target.depth_format();
    for (int row = 0; row < rows; ++row) {
        std::int32_t line[block_size];
        if (uniform) {
            for (int c = 0; c < block_size; c += native_lanes) store_int(line + c, depth_row(format, plane, x + c, y + row));
        } else {
            std::memcpy(line, tile.depth + first_pixel_of_block(block) + row * tile_size, sizeof line);
        }
        std::int32_t* const to = target.raw_depth() + target.index(x, y + row);
        if (columns == block_size) {
            std::memcpy(to, line, sizeof line);
        } else {
            std::memcpy(to, line, std::size_t(columns) * sizeof *line);
        }
    }
}

void clear_block(const TileBuffer& tile, int block, Target& target) {
    const int x = tile.x + block_x(block), y = tile.y + block_y(block);
    for (int row = y; row < std::min(y + block_size, target.height()); ++row)
        target.write_clear(target.index(x, row), std::min(block_size, target.width() - x));
}

}  // namespace

void resolve_depth(TileBuffer& tile, Target& target, bool depth_write, bool colors_follow) {
    if (tile.whole) split_tile(tile);
    for (int block = 0; block < block_count; ++block) {
        if (tile.x + block_x(block) >= target.width() || tile.y + block_y(block) >= target.height()) continue;
        const bool uniform = tile.uniform >> block & 1;
        const bool untouched = uniform && tile.block_slot[block] == 0;
        if (tile.cleared && (untouched || !uniform || !colors_follow)) clear_block(tile, block, target);
        if (!untouched && (depth_write || tile.cleared)) write_block_depth(tile, block, target);
    }
}

std::uint64_t pixels_in_target(const Target& target, int x, int y) {
    const int columns = std::clamp(target.width() - x, 0, block_size), rows = std::clamp(target.height() - y, 0, block_size);
    if (columns == 0 || rows == 0) return 0;
    const std::uint64_t row = 0xff >> (block_size - columns);
    return (row * 0x0101010101010101u) & (~std::uint64_t(0) >> (block_size * (block_size - rows)));
}

namespace {
/// One bit for each pixel of a block whose slot satisfies the test.
template <class Test>
std::uint64_t pixels_where(const TileBuffer& tile, int block, const Test& test) {
    const std::int32_t* p = tile.slot + first_pixel_of_block(block);
    std::uint64_t mask = 0;
    for (int row = 0; row < block_size; ++row)
        for (int c = 0; c < block_size; c += native_lanes)
            mask |= std::uint64_t(bitmask(test(load_int<FloatN>(p + row * tile_size + c)))) << (row * block_size + c);
    return mask;
}
}  // namespace

std::uint64_t visible_pixels(const TileBuffer& tile, int block) {
    return pixels_where(tile, block, [](IntN slots) { return slots != IntN(0); });
}

std::uint64_t pixels_of_slot(const TileBuffer& tile, int block, std::int32_t slot) {
    return pixels_where(tile, block, [slot](IntN slots) { return slots == IntN(slot); });
}

}  // namespace raster::tiles
