// raster.h: driver of stages 7 and 8 inside a tile: walk a triangle's pixels in blocks and rows, test coverage and depth.
//
// What becomes of the pixels that pass is the Sink's business: to remember the triangle until tiles/resolve.h shades it, or
// to shade and blend at once (tiles/blend.h).
#pragma once

#include <bit>

#include <raster/tiles/setup.h>
#include <raster/tiles/tile.h>

namespace raster::tiles {

/// Depth state known when the code is compiled, for the most usual draws, and any other.
struct UsualDepth {
    static constexpr Compare compare = Compare::less;
    static constexpr bool write = true;
    static constexpr DepthFormat format = DepthFormat::unorm24;
};
struct AnyDepth {
    Compare compare;
    bool write;
    DepthFormat format;
};

/// Gives the current triangle a slot when it is first visible.
class SlotMaker {
public:
    explicit SlotMaker(TileBuffer& tile) : tile_(tile) {}

    /// `triangle` outlives all that is said about it, up to end().
    void begin(const TileTriangle& triangle, std::uint32_t chunk) {
        triangle_ = &triangle;
        chunk_ = chunk;
        slot_ = 0;
    }
    std::int32_t slot() {
        if (slot_ == 0) {
            slot_ = std::int32_t(tile_.slots.size());
            Slot& made = tile_.slots.emplace_back();
            made.depth = triangle_->depth;
            made.chunk = chunk_;
            made.entry = triangle_->entry;
            made.front_facing = triangle_->front_facing;
        }
        return slot_;
    }
    Slot current() const { return {triangle_->depth, chunk_, triangle_->entry, triangle_->front_facing}; }

protected:
    TileBuffer& tile_;

private:
    const TileTriangle* triangle_ = nullptr;
    std::uint32_t chunk_ = 0;
    std::int32_t slot_ = 0;
};

/// Puts triangles, in order, into one tile.
template <class Depth, class Sink>
class TileRaster {
public:
    TileRaster(TileBuffer& tile, const Depth& depth, Sink& sink) : tile_(tile), depth_(depth), sink_(sink) {}

    /// Of the box and the depths alone.
    bool hides(const TileTriangle& t) const {
        return t.x0 > t.x1 || t.y0 > t.y1 || none_passes(depth_.compare, t.range, tile_.whole_range);
    }

    void draw(const TileTriangle& t, std::uint32_t chunk) {
        if (hides(t)) return;
        sink_.begin(t, chunk);
        if (t.covers_tile && depth_.write && Sink::remembers) {
            const auto incoming = depth_range(depth_.format, t.depth, tile_.x, tile_.y, tile_.x + tile_size - 1,
                                              tile_.y + tile_size - 1);
            if (all_pass(depth_.compare, incoming, tile_.whole_range)) {
                tile_.whole_slot = sink_.slot();
                tile_.whole_range = incoming;
                tile_.whole = true;
                return;
            }
        }
        if (tile_.whole) split_tile(tile_);
        if (t.x1 - t.x0 < 2 * block_size && t.y1 - t.y0 < 2 * block_size) {
            draw_small(t);
        } else {
            for (int by = t.y0 / block_size; by <= t.y1 / block_size; ++by)
                for (int bx = 0; bx < blocks_per_row; bx += native_lanes) draw_blocks(t, bx, by);
            if (depth_.write) measure_tile(tile_);
        }
        sink_.end();
    }

    /// A lane of a pack whose pixels are few and already known: take them one by one.
    void draw_dots(const PackSetup& pack, int lane, std::uint32_t entry, std::uint32_t chunk) {
        const DepthRange<float> incoming{pack.range.min.v[lane], pack.range.max.v[lane]};
        if (none_passes(depth_.compare, incoming, tile_.whole_range)) return;
        if (tile_.whole) split_tile(tile_);
        bool begun = false;
        TileTriangle t;
        for (std::uint32_t rest = std::uint32_t(pack.covered.v[lane]); rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const int x = pack.x0.v[lane] + (k & 1), y = pack.y0.v[lane] + (k >> 1);
            const int block = y / block_size * blocks_per_row + x / block_size, i = y * tile_size + x;
            if (tile_.uniform >> block & 1) {
                if (none_passes(depth_.compare, incoming, tile_.block_range(block))) continue;
                expand_block(tile_, block, depth_.format);
            }
            const std::int32_t depth = pack.dot_depth[std::size_t(k)].v[lane];
            if (!depth_passes(depth_.compare, depth, tile_.depth[i])) continue;
            if (!begun) {
                t = pack.at(lane, entry);
                sink_.begin(t, chunk);
                begun = true;
            }
            note_write(block, incoming);
            if (depth_.write) tile_.depth[i] = depth;
            sink_.pixel(i);
        }
        if (begun) sink_.end();
    }

private:
    static MaskN inside(IntN e0, IntN e1, IntN e2) { return (e0 | e1 | e2) >= IntN(0); }

    /// Small triangles: every pixel of the box, row by row.
    void draw_small(const TileTriangle& t) {
        const int bx0 = t.x0 / block_size, bx1 = t.x1 / block_size, by0 = t.y0 / block_size, by1 = t.y1 / block_size;
        bool hidden = true;
        for (int by = by0; by <= by1; ++by)
            for (int bx = bx0; bx <= bx1; ++bx)
                hidden = hidden && none_passes(depth_.compare, t.range, tile_.block_range(by * blocks_per_row + bx));
        if (hidden) return;
        for (int by = by0; by <= by1; ++by)
            for (int bx = bx0; bx <= bx1; ++bx) make_single(by * blocks_per_row + bx, t.range);
        // Rows begin at the box, and before it only where they would leave the tile.
        const int wide = (t.x1 - t.x0) / native_lanes + 1, left = std::min(t.x0, tile_size - wide * native_lanes);
        for (int column = 0; column < wide; ++column) draw_rows(t, left + column * native_lanes, t.y0, t.y1);
    }

    /// The pixels of rows y0 to y1 in the lanes<FloatN> columns from `left` on, which are pixels of the tile. No branch on
    /// what is covered or passes: nobody could foretell it.
    void draw_rows(const TileTriangle& t, int left, int y0, int y1) {
        IntN x = IntN(left) + lane_index<FloatN>(), y(y0);
        IntN e0 = edge_in_tile(t.edges[0], x, y), e1 = edge_in_tile(t.edges[1], x, y),
             e2 = edge_in_tile(t.edges[2], x, y);
        const IntN down0(t.edges[0].step_y), down1(t.edges[1].step_y), down2(t.edges[2].step_y);
        Column<FloatN> z =
            column_at(Plane<FloatN>{t.depth.origin, t.depth.dadx, t.depth.dady}, to_float(IntN(tile_.x) + x));
        FloatN py = to_float(IntN(tile_.y) + y);
        int i = y0 * tile_size + left;
        for (int row = y0; row <= y1; ++row) {
            IntN incoming_depth = encode_depth(depth_.format, value_at(z, py) + FloatN(t.depth.offset));
            IntN stored = load_int<FloatN>(tile_.depth + i);
            MaskN passed = inside(e0, e1, e2) & depth_passes(depth_.compare, incoming_depth, stored);
            if (depth_.write) store_int(tile_.depth + i, select(passed, incoming_depth, stored));
            sink_.pack(i, passed);
            e0 = e0 + down0, e1 = e1 + down1, e2 = e2 + down2;
            py = py + FloatN(1.0f);
            i += tile_size;
        }
    }

    static IntN edge_in_tile(const TileEdge& e, IntN x, IntN y) {
        return IntN(e.origin) + IntN(e.step_x) * x + IntN(e.step_y) * y;
    }

    /// Writes a block's pixels out if they are not, and readies its range for some of them to change.
    void make_single(int block, DepthRange<float> incoming) {
        if (tile_.uniform >> block & 1) expand_block(tile_, block, depth_.format);
        note_write(block, incoming);
    }

    /// Keeps the ranges true when some of a block's pixels change.
    void note_write(int block, DepthRange<float> incoming) {
        if (!depth_.write) return;
        tile_.set_block_range(block, merged(depth_.compare, incoming, tile_.block_range(block)));
        tile_.whole_range = merged(depth_.compare, incoming, tile_.whole_range);
    }

    /// Large triangles: lanes<FloatN> blocks beside each other at once, each rejected or accepted as a whole where edges and
    /// depths allow it.
    void draw_blocks(const TileTriangle& t, int bx, int by) {
        constexpr int last = block_size - 1;
        const int y = by * block_size, first = by * blocks_per_row + bx;
        const IntN column = IntN(bx) + lane_index<FloatN>(), x = column * IntN(block_size);
        MaskN touched = (column >= IntN(t.x0 / block_size)) & (column <= IntN(t.x1 / block_size)), full(true);
        for (const TileEdge& e : t.edges) {
            const IntN corner = IntN(e.origin + e.step_y * y) + IntN(e.step_x) * x;
            const std::int32_t across = e.step_x * last, down = e.step_y * last;
            touched = touched & (corner + IntN(std::max(across, 0) + std::max(down, 0)) >= IntN(0));
            full = full & (corner + IntN(std::min(across, 0) + std::min(down, 0)) >= IntN(0));
        }
        const DepthPlane<FloatN> plane{{t.depth.origin, t.depth.dadx, t.depth.dady}, t.depth.offset};
        const DepthRange<FloatN> incoming =
            depth_range<FloatN>(depth_.format, plane, to_float(IntN(tile_.x) + x), FloatN(float(tile_.y + y)),
                                to_float(IntN(tile_.x + last) + x), FloatN(float(tile_.y + y + last)));
        const DepthRange<FloatN> stored{load_int<FloatN>(tile_.block_min + first),
                                        load_int<FloatN>(tile_.block_max + first)};
        touched = touched & !none_passes(depth_.compare, incoming, stored);
        std::uint32_t rest = bitmask(touched);
        if (rest == 0) return;
        if (depth_.write) {
            const MaskN replaced = touched & full & all_pass(depth_.compare, incoming, stored);
            if (const std::uint32_t bits = bitmask(replaced)) {
                store_int(tile_.block_min + first, select(replaced, incoming.min, stored.min));
                store_int(tile_.block_max + first, select(replaced, incoming.max, stored.max));
                std::int32_t* const slots = tile_.block_slot + first;
                store_int(slots, select(replaced, IntN(sink_.slot()), load_int<FloatN>(slots)));
                tile_.uniform |= std::uint64_t(bits) << first;
                if constexpr (!Sink::remembers)
                    for (std::uint32_t b = bits; b; b &= b - 1) sink_.block((bx + std::countr_zero(b)) * block_size, y);
                rest &= ~bits;
            }
        }
        for (; rest; rest &= rest - 1) {
            const int block = first + std::countr_zero(rest);
            if (tile_.uniform >> block & 1) expand_block(tile_, block, depth_.format);
            for (int c = 0; c < block_size; c += native_lanes) draw_rows(t, block_x(block) + c, y, y + last);
            if (depth_.write) measure_block(tile_, block);
        }
    }

    TileBuffer& tile_;
    const Depth& depth_;
    Sink& sink_;
};

/// Gathers the entries of all bins of one tile, in order.
inline void collect_entries(std::span<const ChunkBins> chunks, std::size_t tile_index, std::vector<TileEntry>& out) {
    out.clear();
    for (std::uint32_t c = 0; c < chunks.size(); ++c)
        for (std::uint32_t i = chunks[c].offsets[tile_index]; i < chunks[c].offsets[tile_index + 1]; ++i)
            out.push_back({c, chunks[c].entries[i]});
}

/// Feeds the triangles of all bins of one tile to a sink, in order.
template <class Depth, class Sink>
inline void raster_tile(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index,
                        TileBuffer& tile, const Depth& depth, Sink& sink) {
    TileRaster<Depth, Sink> raster(tile, depth, sink);
    PackSetup pack;
    collect_entries(chunks, tile_index, tile.entries);
    const std::span<const TileEntry> entries = tile.entries;
    for (std::size_t start = 0; start < entries.size(); start += std::size_t(native_lanes)) {
        const std::span<const TileEntry> some =
            entries.subspan(start, std::min(entries.size() - start, std::size_t(native_lanes)));
        draw.prefetch_entries(entries.subspan(start));
        std::array<IntN, 3> places{IntN(0), IntN(0), IntN(0)};
        std::uint32_t large = 0;
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            if (some[lane].entry & large_bit) {
                large |= 1u << lane;
            } else {
                const auto v = draw.corners(some[lane].entry);
                for (std::size_t k = 0; k < 3; ++k) places[k].v[int(lane)] = std::int32_t(v[k] - draw.first_vertex);
            }
        }
        if (large != (1u << some.size()) - 1)
            set_up_pack(pack, &draw.window[0].x, places, draw.state, depth.format, tile.x, tile.y, draw.width,
                        draw.height);
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            const auto [chunk, entry] = some[lane];
            if (large >> lane & 1) {
                const LargeTriangle& in_target = chunks[chunk].large[entry & ~large_bit];
                TileTriangle t = box_of_large(in_target, depth.format, tile.x, tile.y);
                if (raster.hides(t)) continue;
                place_edges(in_target, tile.x, tile.y, t);
                t.entry = entry;
                raster.draw(t, chunk);
            } else if (pack.dots >> lane & 1) {
                raster.draw_dots(pack, int(lane), entry, chunk);
            } else {
                raster.draw(pack.at(int(lane), entry), chunk);
            }
        }
    }
}

/// The same for opaque draws: tile.slot and tile.uniform say afterwards who is visible where. Without `colors` only depths
/// are kept.
void raster_opaque(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index, TileBuffer& tile,
                   DepthFormat format, bool colors);

}  // namespace raster::tiles
