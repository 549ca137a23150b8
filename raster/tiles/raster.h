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

    /// The triangle of all that is said up to end().
    void begin(const Slot& triangle) {
        triangle_ = triangle;
        slot_ = 0;
    }
    std::int32_t slot() {
        if (slot_ == 0) {
            slot_ = std::int32_t(tile_.slots.size());
            tile_.slots.push_back(triangle_);
        }
        return slot_;
    }

protected:
    TileBuffer& tile_;
    Slot triangle_;

private:
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

    /// A triangle of two blocks' extent or more.
    void draw_large(const TileTriangle& t, std::uint32_t chunk) {
        if (hides(t)) return;
        measure_stale_blocks();
        sink_.begin({t.depth, chunk, t.entry, t.front_facing});
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
        for (int by = t.y0 / block_size; by <= t.y1 / block_size; ++by)
            for (int bx = 0; bx < blocks_per_row; bx += native_lanes) draw_blocks(t, bx, by);
        if (depth_.write) measure_tile(tile_);
        sink_.end();
    }

    /// The lanes of a pack whose triangles may have a pixel that passes.
    std::uint32_t may_pass(const PackSetup& pack) const {
        const DepthRange<FloatN> stored{IntN(tile_.whole_range.min), IntN(tile_.whole_range.max)};
        return pack.with_pixels & ~bitmask(none_passes(depth_.compare, pack.range, stored));
    }

    /// A lane of a pack, of less than two blocks' extent: every pixel of its box, row by row.
    void draw_small(const PackSetup& pack, int lane, std::uint32_t entry, std::uint32_t chunk) {
        if (tile_.whole) split_tile(tile_);
        const int y0 = pack.y0.v[lane], y1 = pack.y1.v[lane], left = pack.left.v[lane];
        const std::uint64_t blocks = blocks_between(pack.x0.v[lane], y0, pack.x1.v[lane], y1);
        const DepthRange<float> incoming{pack.range.min.v[lane], pack.range.max.v[lane]};
        bool hidden = true;
        for (std::uint64_t rest = blocks; hidden && rest; rest &= rest - 1)
            hidden = none_passes(depth_.compare, incoming, tile_.block_range(std::countr_zero(rest)));
        if (hidden) return;
        for (std::uint64_t rest = blocks & tile_.uniform; rest; rest &= rest - 1)
            expand_block(tile_, std::countr_zero(rest), depth_.format);
        stale_ |= blocks;
        sink_.begin(pack.slot(lane, entry, chunk));
        const Rows rows{{IntN(pack.edges[0].step_y.v[lane]), IntN(pack.edges[1].step_y.v[lane]),
                         IntN(pack.edges[2].step_y.v[lane])},
                        FloatN(pack.depth.offset.v[lane]), y0, y1};
        const Plane<FloatN> plane{pack.depth.origin.v[lane], pack.depth.dadx.v[lane], pack.depth.dady.v[lane]};
        for (int x = left; x <= pack.x1.v[lane]; x += native_lanes) {
            const IntN across = lane_index<FloatN>() + IntN(x - left);
            std::array<IntN, 3> e;
            for (std::size_t i = 0; i < 3; ++i)
                e[i] = IntN(pack.starts[i].v[lane]) + IntN(pack.edges[i].step_x.v[lane]) * across;
            draw_rows(rows, e, column_at(plane, to_float(IntN(tile_.x + left) + across)), x);
        }
        sink_.end();
    }

    /// A lane of a pack whose pixels are few and already known: take them one by one.
    void draw_dots(const PackSetup& pack, int lane, std::uint32_t entry, std::uint32_t chunk) {
        if (tile_.whole) split_tile(tile_);
        const DepthRange<float> incoming{pack.range.min.v[lane], pack.range.max.v[lane]};
        bool begun = false;
        for (std::uint32_t rest = std::uint32_t(pack.covered.v[lane]); rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const int x = pack.x0.v[lane] + (k & 1), y = pack.y0.v[lane] + (k >> 1);
            const int block = block_of(x, y), i = y * tile_size + x;
            if (tile_.uniform >> block & 1) {
                if (none_passes(depth_.compare, incoming, tile_.block_range(block))) continue;
                expand_block(tile_, block, depth_.format);
            }
            const std::int32_t depth = pack.dot_depth[std::size_t(k)].v[lane];
            if (!depth_passes(depth_.compare, depth, tile_.depth[i])) continue;
            if (!begun) {
                sink_.begin(pack.slot(lane, entry, chunk));
                begun = true;
            }
            stale_ |= std::uint64_t(1) << block;
            if (depth_.write) tile_.depth[i] = depth;
            sink_.pixel(i);
        }
        if (begun) sink_.end();
    }

private:
    static MaskN inside(IntN e0, IntN e1, IntN e2) { return (e0 | e1 | e2) >= IntN(0); }

    /// What the columns of a triangle's rows y0 to y1 share: the edges' steps from row to row, and the depth offset.
    struct Rows {
        std::array<IntN, 3> down;
        FloatN offset;
        int y0, y1;
    };

    /// The pixels of some rows in the lanes<FloatN> columns from `left` on, which are pixels of the tile: e are the edges
    /// in the first row, z the depths' column. No branch on what is covered or passes: nobody could foretell it.
    void draw_rows(const Rows& rows, const std::array<IntN, 3>& e, const Column<FloatN>& z_in, int left) {
        IntN e0 = e[0], e1 = e[1], e2 = e[2];
        const IntN down0 = rows.down[0], down1 = rows.down[1], down2 = rows.down[2];
        Column<FloatN> z = z_in;
        FloatN py = FloatN(float(tile_.y + rows.y0)), offset = rows.offset;
        const auto owner = sink_.owner();
        int i = rows.y0 * tile_size + left;
        for (int row = rows.y0; row <= rows.y1; ++row) {
            IntN incoming_depth = encode_depth(depth_.format, value_at(z, py) + offset);
            IntN stored = load_int<FloatN>(tile_.depth + i);
            MaskN passed = inside(e0, e1, e2) & depth_passes(depth_.compare, incoming_depth, stored);
            if (depth_.write) store_int(tile_.depth + i, select(passed, incoming_depth, stored));
            sink_.pack(i, passed, owner);
            e0 = e0 + down0, e1 = e1 + down1, e2 = e2 + down2;
            py = py + FloatN(1.0f);
            i += tile_size;
        }
    }

    static IntN edge_in_tile(const TileEdge& e, IntN x, int y) {
        return IntN(e.origin + e.step_y * y) + IntN(e.step_x) * x;
    }

    /// The blocks of a box of pixels, as bits.
    static std::uint64_t blocks_between(int x0, int y0, int x1, int y1) {
        const auto block = [](int pixel) { return std::uint32_t(pixel) / block_size; };
        constexpr std::uint32_t last = blocks_per_row - 1;
        const std::uint64_t row = (0xffu << block(x0)) & (0xffu >> (last - block(x1)));
        const std::uint64_t none = 0;
        return (row * first_column) & (~none << block(y0) * blocks_per_row) &
               (~none >> (last - block(y1)) * blocks_per_row);
    }

    /// Blocks that lost single pixels since they were measured keep their ranges: these are still bounds on the side that
    /// none_passes looks at, since depths move to one side only in a draw. all_pass wants the other.
    void measure_stale_blocks() {
        if (stale_ == 0 || !depth_.write) return;
        for (; stale_; stale_ &= stale_ - 1) measure_block(tile_, std::countr_zero(stale_));
        measure_tile(tile_);
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
        const Rows rows{{IntN(t.edges[0].step_y), IntN(t.edges[1].step_y), IntN(t.edges[2].step_y)}, plane.offset, y,
                        y + last};
        for (; rest; rest &= rest - 1) {
            const int block = first + std::countr_zero(rest);
            if (tile_.uniform >> block & 1) expand_block(tile_, block, depth_.format);
            for (int c = 0; c < block_size; c += native_lanes) {
                const int left = block_x(block) + c;
                const IntN px = IntN(left) + lane_index<FloatN>();
                draw_rows(rows,
                          {edge_in_tile(t.edges[0], px, y), edge_in_tile(t.edges[1], px, y),
                           edge_in_tile(t.edges[2], px, y)},
                          column_at(static_cast<const Plane<FloatN>&>(plane), to_float(IntN(tile_.x) + px)), left);
            }
            if (depth_.write) measure_block(tile_, block);
        }
    }

    TileBuffer& tile_;
    const Depth& depth_;
    Sink& sink_;
    std::uint64_t stale_ = 0;  ///< one bit a block
};

/// Puts the triangles of all bins of one tile, in order, into an opaque draw: tile.slot and tile.uniform say afterwards who
/// is visible where. Without `colors` only depths are kept.
void raster_opaque(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index, TileBuffer& tile,
                   DepthFormat format, bool colors);

}  // namespace raster::tiles
