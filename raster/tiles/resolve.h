// resolve.h: opaque draws: shade each visible pixel of a tile once, when all its triangles are known.
#pragma once

#include <raster/tiles/shade.h>
#include <raster/tiles/workspace.h>

namespace raster::tiles {

/// Writes a tile's depths to the target, and with `clear_wanted` its pending clear where no triangle is visible. The clear
/// is left out below blocks that triangles hide when `colors_follow`: when every plane of theirs is about to be written.
void resolve_depth(TileBuffer& tile, Target& target, bool clear_wanted, bool depth_write, bool colors_follow);

/// The pixels of a block that belong to the target, as shade_block takes them.
std::uint64_t pixels_in_target(const Target& target, int x, int y);

/// The block's pixels that show a triangle, and those that show the triangle of a slot.
std::uint64_t visible_pixels(const TileBuffer& tile, int block);
std::uint64_t pixels_of_slot(const TileBuffer& tile, int block, std::int32_t slot);

/// Lists the slots whose planes are wanted in `visible`, and puts their places in it where the tile named the slots.
void list_visible_slots(Workspace& workspace);

/// Shades the visible pixels of the workspace's tile.
template <HasFragment S>
void resolve_color(const ShadingContext<S>& context, Workspace& workspace, Target& target) {
    const TileBuffer& tile = workspace.tile;
    list_visible_slots(workspace);
    const std::span<const std::int32_t> visible = workspace.visible;
    static_assert(std::is_trivially_copyable_v<ShadingPlanes<S>>);
    ShadingPlanes<S>* const planes = workspace.planes.get<ShadingPlanes<S>>(visible.size()).data();
    constexpr std::size_t pack = native_lanes;
    const std::span<const Slot> slots = tile.slots;
    for (std::size_t i = 1; i < visible.size(); i += pack) {
        if (i + 3 * pack <= visible.size()) prefetch_varyings(context, slots, visible.subspan(i + 2 * pack, pack));
        make_shading_planes(context, slots, visible.subspan(i, std::min(pack, visible.size() - i)), planes + i);
    }

    for (int block = 0; block < block_count; ++block) {
        const int x = tile.x + block_x(block), y = tile.y + block_y(block);
        const std::uint64_t in_target = pixels_in_target(target, x, y);
        if (in_target == 0) continue;
        if (tile.uniform >> block & 1) {
            if (const std::int32_t owner = tile.block_slot[block]; owner != 0)
                shade_block(context.shader, planes[owner], target, Blend::off, x, y, in_target);
            continue;
        }
        const std::uint64_t mask = visible_pixels(tile, block) & in_target;
        if (mask == 0) continue;
        const std::int32_t* const owners = tile.slot + first_pixel_of_block(block);
        const int first = std::countr_zero(mask);
        const std::int32_t owner = owners[first / block_size * tile_size + first % block_size];
        if ((mask & ~pixels_of_slot(tile, block, owner)) == 0) {
            shade_block(context.shader, planes[owner], target, Blend::off, x, y, mask);
        } else {
            shade_mixed(context.shader, planes, owners, target, x, y, mask);
        }
    }
}

}  // namespace raster::tiles
