// resolve.h: opaque draws: shade each visible pixel of a tile once, when all its triangles are known.
#pragma once

#include <raster/tiles/shade.h>
#include <raster/tiles/workspace.h>

namespace raster::tiles {

/// Writes a tile's depths to the target, and its pending clear where no triangle is visible. A clear's colours are left out
/// below blocks of one triangle when `colors_follow`: when every plane of theirs is about to be written.
void resolve_depth(TileBuffer& tile, Target& target, bool depth_write, bool colors_follow);

/// The pixels of a block that belong to the target, as shade_block takes them.
std::uint64_t pixels_in_target(const Target& target, int x, int y);

/// The block's pixels that show a triangle, and those that show the triangle of a slot.
std::uint64_t visible_pixels(const TileBuffer& tile, int block);
std::uint64_t pixels_of_slot(const TileBuffer& tile, int block, std::int32_t slot);

/// Shades the visible pixels of the workspace's tile.
template <HasFragment S>
void resolve_color(const ShadingContext<S>& context, Workspace& workspace, Target& target) {
    const TileBuffer& tile = workspace.tile;
    static_assert(std::is_trivially_copyable_v<ShadingPlanes<S>>);
    const auto planes = workspace.planes.get<ShadingPlanes<S>>(tile.slots.size());
    std::vector<char>& ready = workspace.ready;
    ready.assign(tile.slots.size(), 0);
    const auto shade = [&](int block, std::int32_t slot, std::uint64_t mask) {
        const std::size_t s = std::size_t(slot);
        if (!ready[s]) planes[s] = make_shading_planes(context, tile.slots[s]), ready[s] = 1;
        shade_block(context.shader, planes[s], target, Blend::off, tile.x + block_x(block), tile.y + block_y(block), mask);
    };
    for (int block = 0; block < block_count; ++block) {
        const std::uint64_t in_target = pixels_in_target(target, tile.x + block_x(block), tile.y + block_y(block));
        if (in_target == 0) continue;
        if (tile.uniform >> block & 1) {
            if (tile.block_slot[block] != 0) shade(block, tile.block_slot[block], in_target);
            continue;
        }
        for (std::uint64_t rest = visible_pixels(tile, block) & in_target; rest;) {
            const int first = std::countr_zero(rest);
            const std::int32_t slot = tile.slot[first_pixel_of_block(block) + first / block_size * tile_size + first % block_size];
            const std::uint64_t mine = pixels_of_slot(tile, block, slot) & rest;
            rest &= ~mine;
            shade(block, slot, mine);
        }
    }
}

}  // namespace raster::tiles
