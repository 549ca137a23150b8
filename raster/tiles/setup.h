// setup.h: driver of stage 6 inside a tile: from the entries of a bin to triangles in the tile's own pixels.
#pragma once

#include <raster/stages/coverage.h>
#include <raster/stages/setup.h>
#include <raster/tiles/bin.h>
#include <raster/tiles/lane_triangles.h>
#include <raster/tiles/tile.h>

namespace raster::tiles {

/// An edge in steps of whole pixels from the tile's first: inside where origin + step_x x + step_y y >= 0. All values
/// in the tile fit 32 bits.
struct TileEdge {
    std::int32_t origin, step_x, step_y;
};

/// A triangle as seen from one tile.
struct TileTriangle {
    std::array<TileEdge, 3> edges;
    DepthPlane<float> depth;
    DepthRange<float> range;  ///< of the depths in its box
    int x0, y0, x1, y1;  ///< its pixels in the tile, ends included; none when x0 > x1
    std::uint32_t entry;
    bool front_facing;
    bool covers_tile;    ///< no edge crosses the tile
};

/// What of a large triangle is enough to say that it is hidden in a tile: all but its edges.
inline TileTriangle box_of_large(const LargeTriangle& large, DepthFormat format, int tile_x, int tile_y) {
    const TriangleSetup& setup = large.setup;
    TileTriangle t;
    t.depth = setup.depth;
    t.front_facing = large.front_facing;
    t.x0 = std::max(setup.box.min_x - tile_x, 0), t.x1 = std::min(setup.box.max_x - tile_x, tile_size - 1);
    t.y0 = std::max(setup.box.min_y - tile_y, 0), t.y1 = std::min(setup.box.max_y - tile_y, tile_size - 1);
    t.range = depth_range(format, t.depth, tile_x + t.x0, tile_y + t.y0, tile_x + t.x1, tile_y + t.y1);
    return t;
}

/// Its edges in the tile, from exact 64-bit ones.
inline void place_edges(const LargeTriangle& large, int tile_x, int tile_y, TileTriangle& t) {
    t.covers_tile = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge<float>& e = large.setup.edges[i];
        const std::int64_t origin =
            pixel_origin(e) + std::int64_t(e.step_x) * tile_x + std::int64_t(e.step_y) * tile_y;
        const std::int64_t across = std::int64_t(e.step_x) * (tile_size - 1),
                           down = std::int64_t(e.step_y) * (tile_size - 1);
        const std::int64_t low = origin + std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0);
        const std::int64_t high = origin + std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0);
        if (high < 0) t.x1 = t.x0 - 1;
        // An edge that crosses the tile has values of both signs in it, so none is larger than the tile's extent of
        // steps: 2 * 63 * 2^23 < 2^31. One that does not cross needs no steps.
        const bool crosses = low < 0 && high >= 0;
        t.edges[i] = crosses ? TileEdge{std::int32_t(origin), e.step_x, e.step_y} : TileEdge{0, 0, 0};
        t.covers_tile = t.covers_tile && low >= 0;
    }
}

/// lanes<FloatN> triangles, each no larger than a tile, set up at once: the same stage functions over lanes, with positions
/// measured from the tile so that 32 bits suffice: steps are below 2^14 and positions below 2^15, so that the sum of two
/// products is below 2^31.
struct PackSetup {
    std::uint32_t with_pixels;  ///< lanes whose boxes hold any
    std::uint32_t dots;   ///< lanes that touch at most 2 x 2 pixel centres; `covered` and `dot_depth` are theirs
    std::uint32_t small;  ///< lanes of less than two blocks' extent; `left` and `starts` are theirs
    std::uint32_t front_facing;
    IntN x0, y0, x1, y1;
    std::array<Edge<FloatN>, 3> edges;
    std::array<IntN, 3> origins;  ///< pixel_origin of the edges
    DepthPlane<FloatN> depth;
    DepthRange<FloatN> range;
    IntN covered;                   ///< bit 0: pixel (x0, y0), bit 1: one to the right, bits 2 and 3: the row below
    std::array<IntN, 4> dot_depth;  ///< encoded, of those pixels
    IntN left;                      ///< where rows of packs begin: at the box, and before it where they would leave the tile
    std::array<IntN, 3> starts;     ///< the edges at (left, y0)

    Slot slot(int lane, std::uint32_t entry, std::uint32_t chunk) const {
        return {{{depth.origin.v[lane], depth.dadx.v[lane], depth.dady.v[lane]}, depth.offset.v[lane]}, chunk, entry,
                bool(front_facing >> lane & 1)};
    }

    TileTriangle at(int lane, std::uint32_t entry) const {
        TileTriangle t;
        t.entry = entry;
        for (std::size_t i = 0; i < 3; ++i)
            t.edges[i] = {origins[i].v[lane], edges[i].step_x.v[lane], edges[i].step_y.v[lane]};
        t.depth = {{depth.origin.v[lane], depth.dadx.v[lane], depth.dady.v[lane]}, depth.offset.v[lane]};
        t.range = {range.min.v[lane], range.max.v[lane]};
        t.x0 = x0.v[lane], t.y0 = y0.v[lane], t.x1 = x1.v[lane], t.y1 = y1.v[lane];
        t.front_facing = front_facing >> lane & 1;
        t.covers_tile = false;
        return t;
    }
};

inline void set_up_pack(PackSetup& r, const float* windows, const std::array<IntN, 3>& places, const State& state,
                        DepthFormat format, int tile_x, int tile_y, int width, int height) {
    std::array<WindowVertex<FloatN>, 3> v;
    std::array<SubpixelVertex<FloatN>, 3> s;
    for (std::size_t c = 0; c < 3; ++c) {
        gather4(windows, places[c], v[c].x, v[c].y, v[c].z, v[c].oow);
        s[c] = snap(v[c]);
        s[c].x = s[c].x - IntN(tile_x * subpixels);
        s[c].y = s[c].y - IntN(tile_y * subpixels);
    }
    const SubpixelBox<FloatN> box = bounding_box(s);
    const MaskN clockwise = order_corners(v, s);
    r.front_facing = state.front_face == FrontFace::clockwise ? bitmask(clockwise) : ~bitmask(clockwise);
    for (std::size_t i = 0; i < 3; ++i) {
        r.edges[i] = make_edge(s[i], s[(i + 1) % 3], state.fill_rule);
        r.origins[i] = pixel_origin(r.edges[i]);
    }
    r.depth = {make_plane(make_plane_basis(v[0], v[1], v[2]), v[0].z, v[1].z, v[2].z), FloatN(0)};
    if (state.depth_offset.is_on()) r.depth.offset = depth_offset(state.depth_offset, format, v[0], v[1], v[2]);
    r.x0 = max(box.first_x(), IntN(0)), r.y0 = max(box.first_y(), IntN(0));
    r.x1 = min(box.last_x(), IntN(std::min(tile_size, width - tile_x) - 1));
    r.y1 = min(box.last_y(), IntN(std::min(tile_size, height - tile_y) - 1));
    const auto absolute = [](int tile, IntN i) { return to_float(IntN(tile) + i); };
    r.range = depth_range(format, r.depth, absolute(tile_x, r.x0), absolute(tile_y, r.y0), absolute(tile_x, r.x1),
                          absolute(tile_y, r.y1));

    const IntN columns = r.x1 - r.x0, rows = r.y1 - r.y0;
    r.with_pixels = bitmask((columns >= IntN(0)) & (rows >= IntN(0)));
    r.small = bitmask((columns < IntN(2 * block_size)) & (rows < IntN(2 * block_size)));
    r.left = min(r.x0, IntN(tile_size - native_lanes) - (columns & IntN(-native_lanes)));
    for (std::size_t i = 0; i < 3; ++i)
        r.starts[i] = r.origins[i] + r.edges[i].step_x * r.left + r.edges[i].step_y * r.y0;
    r.dots = bitmask((columns <= IntN(1)) & (rows <= IntN(1)));
    if (r.dots) {
        r.covered = covered_2x2(r.edges, r.origins, r.x0, r.y0, columns, rows);
        const FloatN px = absolute(tile_x, r.x0), py = absolute(tile_y, r.y0);
        for (int k = 0; k < 4; ++k)
            r.dot_depth[std::size_t(k)] =
                encode_depth(format, value_at(r.depth, px + FloatN(float(k & 1)), py + FloatN(float(k >> 1))));
    }
}

}  // namespace raster::tiles
