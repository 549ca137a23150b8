// bin.cpp: bins a chunk of triangles, lanes at a time, and one by one where a corner is outside the view volume.
#include <raster/tiles/bin.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <raster/stages/cull.h>
#include <raster/stages/setup.h>
#include <raster/tiles/lane_triangles.h>
#include <raster/tiles/vertices.h>

namespace raster::tiles {

namespace {

/// The work on one chunk of triangles.
class ChunkBinner {
public:
    ChunkBinner(const DrawContext& draw, Clipper& clipper, ChunkBins& bins)
        : draw_(draw), clipper_(clipper), bins_(bins) {}

    RASTER_FLATTEN DrawCounts run(std::size_t begin, std::size_t end) {
        bins_.pairs.clear();
        bins_.large.clear();
        for (std::size_t i = begin; i < end; i += std::size_t(native_lanes)) bin_pack(i, end);
        sort_by_tile();
        return counts_;
    }

private:
    void bin_pack(std::size_t start, std::size_t end) {
        const int count = int(std::min(std::size_t(native_lanes), end - start));
        const std::uint32_t live = (1u << count) - 1;
        counts_.submitted += count;
        std::array<IntN, 3> places;
        MaskN bad(false);
        draw_.prefetch_corners(start);
        draw_.load_corners(start, count, places);
        for (IntN& p : places) {
            // Unsigned comparison by way of a signed one; entries before the first wrap to large numbers.
            const IntN bias(std::numeric_limits<std::int32_t>::min());
            p = p - IntN(std::int32_t(draw_.first_vertex));
            const MaskN missing = (p ^ bias) >= (IntN(std::int32_t(draw_.window.size())) ^ bias);
            p = select(missing, IntN(0), p);
            bad = bad | missing;
        }
        std::array<SubpixelVertex<FloatN>, 3> v;
        MaskN inside = !bad;
        for (std::size_t c = 0; c < 3; ++c) {
            WindowVertex<FloatN> window;
            gather4(&draw_.window[0].x, places[c], window.x, window.y, window.z, window.oow);
            inside = inside & (window.x == window.x);
            v[c] = snap(window);
        }
        const std::uint32_t slow = ~bitmask(inside) & live;
        const SubpixelBox<FloatN> box = bounding_box(v);
        const auto [positive, zero] = signs_of_area(v, box, live & ~slow);
        const std::uint32_t front = draw_.state.front_face == FrontFace::counter_clockwise ? positive : ~positive;
        const std::uint32_t culled = (is_culled(draw_.state.cull, true) ? front : 0) |
                                     (is_culled(draw_.state.cull, false) ? ~front : 0);
        const std::uint32_t kept = live & ~slow & ~zero & ~culled;
        counts_.zero_area += std::popcount(live & ~slow & zero);
        counts_.culled += std::popcount(live & ~slow & ~zero & culled);
        counts_.drawn += std::popcount(kept);

        const PixelBox& limits = draw_.limits;
        const IntN x0 = max(box.first_x(), IntN(limits.min_x)), y0 = max(box.first_y(), IntN(limits.min_y));
        const IntN x1 = min(box.last_x(), IntN(limits.max_x)), y1 = min(box.last_y(), IntN(limits.max_y));
        std::uint32_t visible = kept & bitmask((x0 <= x1) & (y0 <= y1));
        const std::uint32_t large =
            visible & bitmask(((box.max_x - box.min_x) | (box.max_y - box.min_y)) >= IntN(tile_size * subpixels));
        const std::uint32_t dots = visible & bitmask(((x1 - x0) <= IntN(1)) & ((y1 - y0) <= IntN(1)));
        if (dots) visible &= ~(dots & nothing_covered(v, x0, y0, x1 - x0, y1 - y0));
        for (std::uint32_t rest = visible | slow; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            const std::size_t triangle = start + std::size_t(lane);
            if (slow >> lane & 1) {
                bin_slow(triangle);
            } else if (large >> lane & 1) {
                bin_large(draw_.corner_windows(bins_, std::uint32_t(triangle)), std::uint32_t(triangle), -1);
            } else {
                emit({x0.v[lane], y0.v[lane], x1.v[lane], y1.v[lane]}, std::uint32_t(triangle));
            }
        }
    }

    /// Lanes whose area is positive, and lanes where it is 0. Slow lanes hold garbage.
    static std::pair<std::uint32_t, std::uint32_t> signs_of_area(const std::array<SubpixelVertex<FloatN>, 3>& v,
                                                                 const SubpixelBox<FloatN>& box, std::uint32_t live) {
        const IntN area = wrapping_area(v);
        std::uint32_t positive = bitmask(area > IntN(0)), zero = bitmask(area == IntN(0));
        const MaskN large = ((box.max_x - box.min_x) | (box.max_y - box.min_y)) >= IntN(1 << 15);
        for (std::uint32_t rest = bitmask(large) & live; rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const std::int64_t exact = signed_area(
                {{{v[0].x.v[k], v[0].y.v[k]}, {v[1].x.v[k], v[1].y.v[k]}, {v[2].x.v[k], v[2].y.v[k]}}});
            positive = (positive & ~(1u << k)) | std::uint32_t(exact > 0) << k;
            zero = (zero & ~(1u << k)) | std::uint32_t(exact == 0) << k;
        }
        return {positive, zero};
    }

    /// Among triangles of at most 2 x 2 pixel centres, those that cover none: most of a fine mesh.
    std::uint32_t nothing_covered(std::array<SubpixelVertex<FloatN>, 3> v, IntN x0, IntN y0, IntN columns,
                                  IntN rows) const {
        for (auto& corner : v) {
            corner.x = corner.x - (x0 << subpixel_bits);
            corner.y = corner.y - (y0 << subpixel_bits);
        }
        order_corners(v);
        std::array<Edge<FloatN>, 3> edges;
        std::array<IntN, 3> origins;
        for (std::size_t i = 0; i < 3; ++i) {
            edges[i] = make_edge(v[i], v[(i + 1) % 3], draw_.state.fill_rule);
            origins[i] = pixel_origin(edges[i]);
        }
        return bitmask(covered_2x2(edges, origins, IntN(0), IntN(0), columns, rows) == IntN(0));
    }

    /// A triangle with a corner outside, or without one: the clip stage decides.
    [[gnu::noinline]] void bin_slow(std::size_t triangle) {
        std::uint8_t all = 0xff, any = 0;
        for (const std::uint32_t v : draw_.corners(triangle)) {
            if (!draw_.exists(v)) {
                ++counts_.bad_index;
                return;
            }
            all &= draw_.outcodes[v - draw_.first_vertex];
            any |= draw_.outcodes[v - draw_.first_vertex];
        }
        if (any & not_finite_bit) {
            ++counts_.not_finite;
            return;
        }
        if (all & ~user_plane_bit) {
            ++counts_.outside;
            return;
        }
        const Clipper::Fan fan = clipper_.clip(triangle, any);
        if (fan.count == 0) {
            ++counts_.outside;
            return;
        }
        PieceFate fate;
        for (int piece = 0; piece < fan.count; ++piece)
            bin_piece(fan.pieces[std::size_t(piece)], piece, std::uint32_t(triangle), fate);
        fate.count(counts_);
    }

    void bin_piece(const std::array<WindowVertex<float>, 3>& window, int piece, std::uint32_t triangle,
                   PieceFate& fate) {
        const std::int64_t area = signed_area({snap(window[0]), snap(window[1]), snap(window[2])});
        if (area == 0) return;
        if (is_culled(draw_.state.cull, is_front_facing(draw_.state.front_face, area))) {
            fate.any_culled = true;
            return;
        }
        fate.any_drawn = true;
        if (bin_large(window, triangle, pieces_)) {
            clipper_.keep(piece);
            ++pieces_;
        }
    }

    [[gnu::noinline]] bool bin_large(const std::array<WindowVertex<float>, 3>& window, std::uint32_t triangle,
                                     std::int32_t piece) {
        const std::array<SubpixelVertex<float>, 3> subpixel{snap(window[0]), snap(window[1]), snap(window[2])};
        const std::int64_t area = signed_area(subpixel);
        TriangleSetup setup = make_setup(window, subpixel, area, draw_.state.fill_rule, draw_.width, draw_.height,
                                         draw_.state.depth_offset, draw_.depth_format);
        setup.box = intersection(setup.box, draw_.limits);
        if (setup.box.empty()) return false;
        emit(setup.box, large_bit | std::uint32_t(bins_.large.size()));
        bins_.large.push_back({window, setup, triangle, piece, is_front_facing(draw_.state.front_face, area)});
        return true;
    }

    void emit(const PixelBox& box, std::uint32_t triangle) {
        for (int ty = box.min_y >> tile_bits; ty <= box.max_y >> tile_bits; ++ty)
            for (int tx = box.min_x >> tile_bits; tx <= box.max_x >> tile_bits; ++tx)
                bins_.pairs.push_back({std::uint32_t(ty * draw_.tiles_x + tx), triangle});
    }

    /// A counting sort: stable, so that a tile sees its triangles in submission order.
    void sort_by_tile() {
        const std::size_t tiles = std::size_t(draw_.tiles_x) * std::size_t(draw_.tiles_y);
        auto& offsets = bins_.offsets;
        offsets.assign(tiles + 1, 0);
        for (const BinPair& p : bins_.pairs) ++offsets[p.tile + 1];
        for (std::size_t t = 0; t < tiles; ++t) offsets[t + 1] += offsets[t];
        bins_.entries.resize(bins_.pairs.size());
        // Placing moves each tile's start to its end; the last loop moves them back.
        for (const BinPair& p : bins_.pairs) bins_.entries[offsets[p.tile]++] = p.triangle;
        for (std::size_t t = tiles; t > 0; --t) offsets[t] = offsets[t - 1];
        offsets[0] = 0;
    }

    const DrawContext& draw_;
    Clipper& clipper_;
    ChunkBins& bins_;
    DrawCounts counts_;
    std::int32_t pieces_ = 0;
};

}  // namespace

DrawCounts bin_chunk(const DrawContext& draw, Clipper& clipper, std::size_t begin, std::size_t end, ChunkBins& bins) {
    return ChunkBinner(draw, clipper, bins).run(begin, end);
}

}  // namespace raster::tiles
