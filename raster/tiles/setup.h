// setup.h: driver of stage 6 inside a tile: from the entries of a bin to triangles in the tile's own pixels.
#pragma once

#include <raster/stages/coverage.h>
#include <raster/stages/setup.h>
#include <raster/tiles/bin.h>
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
    Plane<float> depth;
    int x0, y0, x1, y1;  ///< its pixels in the tile, ends included; none when x0 > x1
    std::uint32_t entry;
    bool front_facing;
};

/// Positions of the three corners of a bin's entry.
template <Shader S>
inline std::array<WindowVertex<float>, 3> corner_windows(const DrawContext<S>& draw,
                                                         const std::vector<ClippedPiece<S>>& pieces, std::uint32_t entry) {
    if (entry & clipped_bit) return pieces[entry & ~clipped_bit].window;
    const auto v = draw.corners(entry);
    const auto window = [&](std::uint32_t i) { return draw.buffer.window[i - draw.buffer.first]; };
    return {window(v[0]), window(v[1]), window(v[2])};
}

/// Any triangle, one at a time, from exact 64-bit edges.
inline TileTriangle set_up_one(const std::array<WindowVertex<float>, 3>& window, const State& state, int tile_x,
                               int tile_y, int width, int height) {
    std::array<SubpixelVertex<float>, 3> subpixel;
    for (std::size_t c = 0; c < 3; ++c) subpixel[c] = snap(window[c]);
    const std::int64_t area = signed_area(subpixel);
    const TriangleSetup setup = make_setup(window, subpixel, area, state.fill_rule, width, height);
    TileTriangle t;
    t.depth = setup.depth;
    t.front_facing = is_front_facing(state.front_face, area);
    t.x0 = std::max(setup.box.min_x - tile_x, 0), t.x1 = std::min(setup.box.max_x - tile_x, tile_size - 1);
    t.y0 = std::max(setup.box.min_y - tile_y, 0), t.y1 = std::min(setup.box.max_y - tile_y, tile_size - 1);
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge<float>& e = setup.edges[i];
        const std::int64_t origin =
            pixel_origin(e) + std::int64_t(e.step_x) * tile_x + std::int64_t(e.step_y) * tile_y;
        const std::int64_t across = std::int64_t(e.step_x) * (tile_size - 1), down = std::int64_t(e.step_y) * (tile_size - 1);
        const std::int64_t low = origin + std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0);
        const std::int64_t high = origin + std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0);
        if (high < 0) t.x1 = t.x0 - 1;
        // An edge that crosses the tile has values of both signs in it, so none is larger than the tile's extent of
        // steps: 2 * 63 * 2^23 < 2^31. One that does not cross needs no steps.
        t.edges[i] = low >= 0 || high < 0 ? TileEdge{0, 0, 0} : TileEdge{std::int32_t(origin), e.step_x, e.step_y};
    }
    return t;
}

/// Sets up lanes<FloatN> entries at once; `wide` lanes, which exceed the tile's size, are left to set_up_one. The same
/// stage functions as there, with positions measured from the tile so that 32 bits suffice.
template <Shader S>
inline void set_up_pack(const DrawContext<S>& draw, const std::array<IntN, 3>& places, int tile_x, int tile_y,
                        std::uint32_t& wide, std::array<TileTriangle, native_lanes>& out) {
    std::array<WindowVertex<FloatN>, 3> v;
    std::array<SubpixelVertex<FloatN>, 3> s;
    for (std::size_t c = 0; c < 3; ++c) {
        gather4(&draw.buffer.window[0].x, places[c], v[c].x, v[c].y, v[c].z, v[c].oow);
        s[c] = snap(v[c]);
        s[c].x = s[c].x - IntN(tile_x * subpixels);
        s[c].y = s[c].y - IntN(tile_y * subpixels);
    }
    const IntN min_x = min(min(s[0].x, s[1].x), s[2].x), max_x = max(max(s[0].x, s[1].x), s[2].x);
    const IntN min_y = min(min(s[0].y, s[1].y), s[2].y), max_y = max(max(s[0].y, s[1].y), s[2].y);
    // Up to the tile's size, steps are below 2^14 and positions below 2^15, so products sum up below 2^31.
    wide = bitmask(((max_x - min_x) | (max_y - min_y)) >= IntN(tile_size * subpixels));

    const IntN area = (s[0].x - s[1].x) * (s[2].y - s[0].y) - (s[2].x - s[0].x) * (s[0].y - s[1].y);
    const MaskN clockwise = area < IntN(0);
    const auto exchange = [&](auto& a, auto& b) {
        const auto t = select(clockwise, b, a);
        b = select(clockwise, a, b);
        a = t;
    };
    exchange(v[0].x, v[1].x), exchange(v[0].y, v[1].y), exchange(v[0].z, v[1].z);
    exchange(s[0].x, s[1].x), exchange(s[0].y, s[1].y);

    alignas(32) std::int32_t edges[3][3][native_lanes];
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge<FloatN> e = make_edge(s[i], s[(i + 1) % 3], draw.state.fill_rule);
        store_int(edges[i][0], pixel_origin(e));
        store_int(edges[i][1], e.step_x);
        store_int(edges[i][2], e.step_y);
    }
    const Plane<FloatN> depth = make_plane(make_plane_basis(v[0], v[1], v[2]), v[0].z, v[1].z, v[2].z);
    const IntN last(subpixels - 1), zero(0);
    const IntN x0 = max((min_x + last) >> subpixel_bits, zero), y0 = max((min_y + last) >> subpixel_bits, zero);
    const IntN x1 = min(max_x >> subpixel_bits, IntN(std::min(tile_size, draw.width - tile_x) - 1));
    const IntN y1 = min(max_y >> subpixel_bits, IntN(std::min(tile_size, draw.height - tile_y) - 1));
    const bool front_is_clockwise = draw.state.front_face == FrontFace::clockwise;
    for (int lane = 0; lane < native_lanes; ++lane) {
        TileTriangle& t = out[std::size_t(lane)];
        for (std::size_t i = 0; i < 3; ++i) t.edges[i] = {edges[i][0][lane], edges[i][1][lane], edges[i][2][lane]};
        t.depth = {depth.origin.v[lane], depth.dadx.v[lane], depth.dady.v[lane]};
        t.x0 = x0.v[lane], t.y0 = y0.v[lane], t.x1 = x1.v[lane], t.y1 = y1.v[lane];
        t.front_facing = raster::lane(clockwise, lane) == front_is_clockwise;
    }
}

}  // namespace raster::tiles
