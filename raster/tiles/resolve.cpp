// resolve.cpp: the part of resolving a tile that needs no shader: depths, clears, and who is visible where.
#include <raster/tiles/resolve.h>

#include <bit>
#include <numeric>

namespace raster::tiles {

std::uint64_t pixels_in_target(const Target& target, int x, int y) {
    const int columns = std::clamp(target.width() - x, 0, block_size),
              rows = std::clamp(target.height() - y, 0, block_size);
    if (columns == 0 || rows == 0) return 0;
    const std::uint64_t row = 0xff >> (block_size - columns);
    return (row * first_column) & (~std::uint64_t(0) >> (block_size * (block_size - rows)));
}

int blocks_alike(const TileBuffer& tile, const Target& target, int block) {
    const int first = block % blocks_per_row;
    const int whole = (target.width() - tile.x) / block_size - first;
    if (tile.y + (block / blocks_per_row + 1) * block_size > target.height()) return 0;
    const int most = std::min(blocks_per_row - first, whole);
    int count = 0;
    while (count < most && (tile.uniform >> (block + count) & 1) &&
           tile.block_slot[block + count] == tile.block_slot[block])
        ++count;
    return count;
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

FewTriangles list_owners(const TileBuffer& tile, int block, std::uint64_t mask, int most) {
    FewTriangles few;
    for (std::uint64_t rest = mask; rest;) {
        if (few.count == most) return {};
        const int pixel = std::countr_zero(rest);
        const std::int32_t owner =
            tile.slot[first_pixel_of_block(block) + pixel / block_size * tile_size + pixel % block_size];
        rest &= ~pixels_where(tile, block, [owner](IntN slots) { return slots == IntN(owner); });
        few.at[few.count++] = owner;
    }
    return few;
}

namespace {

/// Writes the depths of one block to the target.
void write_block_depth(const TileBuffer& tile, int block, Target& target) {
    const int x = tile.x + block_x(block), y = tile.y + block_y(block);
    const int columns = std::min(block_size, target.width() - x), rows = std::min(block_size, target.height() - y);
    const bool uniform = tile.uniform >> block & 1;
    const DepthPlane<float> plane =
        uniform ? tile.slots[std::size_t(tile.block_slot[block])].depth : DepthPlane<float>{};
    const DepthFormat format = target.depth_format();
    for (int row = 0; row < rows; ++row) {
        std::int32_t line[block_size];
        if (uniform) {
            for (int c = 0; c < block_size; c += native_lanes)
                store_int(line + c, depth_row(format, plane, x + c, y + row));
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

/// Writes the depths of whole blocks beside each other that show one triangle: row by row, each column's part of the plane
/// computed once.
template <DepthFormat format>
void write_run_depth(const DepthPlane<float>& plane, Target& target, int x, int y, int blocks) {
    const int packs = blocks * block_size / native_lanes;
    Column<FloatN> columns[tile_size / native_lanes];
    for (int p = 0; p < packs; ++p)
        columns[p] = column_at(Plane<FloatN>{plane.origin, plane.dadx, plane.dady},
                               to_float(IntN(x + p * native_lanes) + lane_index<FloatN>()));
    FloatN offset(plane.offset);
    for (int row = y; row < y + block_size; ++row) {
        std::int32_t* const to = target.raw_depth() + target.index(x, row);
        for (int p = 0; p < packs; ++p)
            store_int(to + p * native_lanes, encode_depth(format, value_at(columns[p], FloatN(float(row))) + offset));
    }
}

/// The blocks of a row of the tile, as bits, whose pixels show the clear's colour, or will until they are shaded.
std::uint32_t blocks_to_clear(const TileBuffer& tile, int by, bool colors_follow) {
    std::uint32_t r = 0;
    for (int bx = 0; bx < blocks_per_row; ++bx) {
        const int block = by * blocks_per_row + bx;
        const bool uniform = tile.uniform >> block & 1;
        const bool hidden =
            uniform ? tile.block_slot[block] != 0 : colors_follow && visible_pixels(tile, block) == ~std::uint64_t(0);
        if (!hidden || !colors_follow) r |= 1u << bx;
    }
    return r;
}

/// The blocks of a row of the tile, as bits, in which no triangle passed.
std::uint32_t untouched_blocks(const TileBuffer& tile, int by) {
    std::uint32_t r = 0;
    for (int bx = 0; bx < blocks_per_row; ++bx) {
        const int block = by * blocks_per_row + bx;
        if ((tile.uniform >> block & 1) && tile.block_slot[block] == 0) r |= 1u << bx;
    }
    return r;
}

/// Calls write(x, y, width, height) for the blocks of such a row. Neighbours at one go: long rows are written faster.
template <class Write>
void for_runs(const TileBuffer& tile, int by, std::uint32_t blocks, const Write& write) {
    while (blocks) {
        const int first = std::countr_zero(blocks), run = std::countr_one(blocks >> first);
        write(tile.x + first * block_size, tile.y + by * block_size, run * block_size, block_size);
        blocks &= ~(((1u << run) - 1) << first);
    }
}

}  // namespace

void resolve_depth(TileBuffer& tile, Target& target, bool clear_color, bool depth_write, bool colors_follow) {
    if (tile.whole) split_tile(tile);
    for (int by = 0; by < blocks_per_row && tile.y + by * block_size < target.height(); ++by) {
        if (clear_color)
            for_runs(tile, by, blocks_to_clear(tile, by, colors_follow),
                     [&](int x, int y, int width, int height) { target.write_clear_color(x, y, width, height); });
        if (!depth_write && !tile.cleared) continue;
        const std::uint32_t untouched = untouched_blocks(tile, by);
        if (tile.cleared)
            for_runs(tile, by, untouched,
                     [&](int x, int y, int width, int height) { target.write_clear_depth(x, y, width, height); });
        for (int bx = 0; bx < blocks_per_row && tile.x + bx * block_size < target.width(); ++bx) {
            if (untouched >> bx & 1) continue;
            const int block = by * blocks_per_row + bx;
            const int alike = tile.uniform >> block & 1 ? blocks_alike(tile, target, block) : 0;
            if (alike == 0) {
                write_block_depth(tile, block, target);
                continue;
            }
            const DepthPlane<float>& plane = tile.slots[std::size_t(tile.block_slot[block])].depth;
            const int x = tile.x + bx * block_size, y = tile.y + by * block_size;
            if (target.depth_format() == DepthFormat::unorm24) {
                write_run_depth<DepthFormat::unorm24>(plane, target, x, y, alike);
            } else {
                write_run_depth<DepthFormat::float32>(plane, target, x, y, alike);
            }
            bx += alike - 1;
        }
    }
}

void list_visible_slots(Workspace& workspace) {
    TileBuffer& tile = workspace.tile;
    // To look at every pixel costs more than the planes of some slots that nobody sees.
    const std::size_t single_pixels = std::size_t(block_size * block_size * std::popcount(~tile.uniform));
    if (single_pixels > 8 * tile.slots.size()) {
        workspace.visible.resize(tile.slots.size());
        std::iota(workspace.visible.begin(), workspace.visible.end(), 0);
        return;
    }
    std::vector<std::int32_t>& place = workspace.place;
    place.assign(tile.slots.size(), -1);
    place[0] = 0;
    workspace.visible.resize(std::min<std::size_t>(tile.slots.size(), tile_pixels + 1) + 1);
    std::int32_t* const visible = workspace.visible.data();
    std::int32_t count = visible[0] = 0;
    ++count;
    // No branch: whether a slot was met before is hard to foretell. A slot that was met is written behind the list's end.
    const auto number = [&](std::int32_t& slot) {
        const std::int32_t known = place[std::size_t(slot)];
        visible[count] = slot;
        const std::int32_t at = known < 0 ? count : known;
        place[std::size_t(slot)] = at;
        slot = at;
        count += known < 0;
    };
    for (int block = 0; block < block_count; ++block) {
        if (tile.uniform >> block & 1) {
            number(tile.block_slot[block]);
            continue;
        }
        std::int32_t* const owners = tile.slot + first_pixel_of_block(block);
        for (int row = 0; row < block_size; ++row)
            for (int column = 0; column < block_size; ++column) number(owners[row * tile_size + column]);
    }
    workspace.visible.resize(std::size_t(count));
}

}  // namespace raster::tiles
