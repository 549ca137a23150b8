// resolve.h: opaque draws: shade each visible pixel of a tile once, when all its triangles are known.
#pragma once

#include <raster/tiles/shade.h>
#include <raster/tiles/workspace.h>

namespace raster::tiles {

/// Writes a tile's depths to the target; and with `clear_color` the colour of its pending clear where no triangle is
/// visible. That is left out below blocks that triangles hide when `colors_follow`: when every plane of theirs is about to
/// be written.
void resolve_depth(TileBuffer& tile, Target& target, bool clear_color, bool depth_write, bool colors_follow);

/// The pixels of a block that belong to the target, as shade_block takes them.
std::uint64_t pixels_in_target(const Target& target, int x, int y);

/// How many blocks from this one on, to the end of its row, show the same triangle in all their pixels and lie whole in
/// the target. `block` is uniform.
int blocks_alike(const TileBuffer& tile, const Target& target, int block);

/// The block's pixels that show a triangle.
std::uint64_t visible_pixels(const TileBuffer& tile, int block);

/// Whose pixels those of the mask are, where that are at most `most` triangles.
FewTriangles list_owners(const TileBuffer& tile, int block, std::uint64_t mask, int most);

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

    // Where triangles are small it does not pay to look for blocks that show few.
    const int most = visible.size() > 2 * block_count ? 1 : FewTriangles::most;
    for (int block = 0; block < block_count; ++block) {
        const int x = tile.x + block_x(block), y = tile.y + block_y(block);
        const std::uint64_t in_target = pixels_in_target(target, x, y);
        if (in_target == 0) continue;
        if (tile.uniform >> block & 1) {
            const std::int32_t owner = tile.block_slot[block];
            if (owner == 0) continue;
            if (const int alike = blocks_alike(tile, target, block); alike > 0) {
                shade_run(context.shader, planes[owner], target, Blend::off, x, y, alike);
                block += alike - 1;
            } else {
                shade_block(context.shader, planes[owner], target, Blend::off, x, y, in_target);
            }
            continue;
        }
        const std::uint64_t mask = visible_pixels(tile, block) & in_target;
        if (mask == 0) continue;
        const std::int32_t* const owners = tile.slot + first_pixel_of_block(block);
        const FewTriangles few = list_owners(tile, block, mask, most);
        if (few.count == 1) {
            shade_block(context.shader, planes[few.at[0]], target, Blend::off, x, y, mask);
        } else {
            shade_mixed(context.shader, planes, owners, few, target, x, y, mask);
        }
    }
}

}  // namespace raster::tiles
