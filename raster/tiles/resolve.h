// resolve.h: opaque draws: remember who is visible at each pixel, then shade each visible pixel once.
#pragma once

#include <raster/stages/blend.h>
#include <raster/tiles/raster.h>
#include <raster/tiles/shade.h>

namespace raster::tiles {

/// The Sink that remembers. Without need of colours only uniform blocks keep their slots.
template <bool colors>
class RememberSink {
public:
    static constexpr bool remembers = true;

    explicit RememberSink(TileBuffer& tile) : tile_(tile) {}

    void begin(const TileTriangle& t, std::uint32_t chunk) {
        triangle_ = &t;
        chunk_ = chunk;
        slot_ = 0;
    }
    /// The current triangle's slot; made when it is first visible.
    std::int32_t slot() {
        if (slot_ == 0) {
            slot_ = std::int32_t(tile_.slots.size());
            tile_.slots.push_back({triangle_->depth, chunk_, triangle_->entry, triangle_->front_facing});
        }
        return slot_;
    }
    void cell(int i, MaskN passed, FloatN, FloatN) {
        if constexpr (colors)
            store_cell(tile_.slot + i, select(passed, IntN(slot()), load_cell<native_lanes>(tile_.slot + i)));
    }
    void row(int i, MaskN passed, FloatN, FloatN) {
        if constexpr (colors)
            store_int(tile_.slot + i, select(passed, IntN(slot()), load_int<FloatN>(tile_.slot + i)));
    }

private:
    TileBuffer& tile_;
    const TileTriangle* triangle_ = nullptr;
    std::uint32_t chunk_ = 0;
    std::int32_t slot_ = 0;
};

/// Where lanes<FloatN> pixels of a target's row go: the first `count` exist.
struct RowPlace {
    std::size_t index;
    int count;
};

/// Stores the lanes of `passed` that exist.
template <class T>
inline void store_masked(T* to, const T* lanes_from, std::uint32_t passed) {
    for (; passed; passed &= passed - 1) to[std::countr_zero(passed)] = lanes_from[std::countr_zero(passed)];
}
inline void store_lanes(std::uint32_t* to, IntN v, MaskN passed, int count) {
    if (count == native_lanes) {
        store_int(to, select(passed, v, load_int<FloatN>(to)));
    } else {
        std::uint32_t each[native_lanes];
        store_int(each, v);
        store_masked(to, each, bitmask(passed) & ((1u << count) - 1));
    }
}

/// Writes a fragment pack's colour and extra values to the target.
template <HasFragment S>
inline void write_outputs(Target& target, RowPlace place, MaskN passed, const OutputArray<S, FloatN>& out) {
    const vec<4, FloatN> color(out[0], out[1], out[2], out[3]);
    const std::uint32_t lanes_passed = bitmask(passed) & ((1u << place.count) - 1);
    if (target.color_format() == ColorFormat::rgba8) {
        store_lanes(target.raw_color8() + place.index, pack_rgba8(color), passed, place.count);
    } else {
        for (std::uint32_t rest = lanes_passed; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            target.raw_color_float()[place.index + std::size_t(lane)] = {color.x.v[lane], color.y.v[lane],
                                                                         color.z.v[lane], color.w.v[lane]};
        }
    }
    if constexpr (output_count<S> > 4) {
        for (int e = 0; e < std::min(output_count<S> - 4, target.extra_channels()); ++e) {
            float each[native_lanes];
            store(each, out[std::size_t(4 + e)]);
            store_masked(target.raw_extra(e) + place.index, each, lanes_passed);
        }
    }
}

/// Shades a tile's visible pixels and writes colour and depth to the target.
template <Shader S>
class TileResolve {
public:
    TileResolve(const DrawContext<S>& draw, const std::vector<std::vector<ClippedPiece<S>>>& pieces, TileBuffer& tile,
                Target& target)
        : draw_(draw), pieces_(pieces), tile_(tile), target_(target) {}

    void run() {
        planes_.resize(tile_.slots.size());
        ready_.assign(tile_.slots.size(), 0);
        const int columns = std::min(tile_size, draw_.width - tile_.x), rows = std::min(tile_size, draw_.height - tile_.y);
        for (int block = 0; block < block_count; ++block) {
            const int x = block % blocks_per_row * block_size, y = block / blocks_per_row * block_size;
            for (int row = y; row < std::min(y + block_size, rows); ++row)
                for (int column = x; column < std::min(x + block_size, columns); column += native_lanes)
                    resolve_row(block, column, row,
                                {target_.index(tile_.x + column, tile_.y + row), std::min(native_lanes, columns - column)});
        }
    }

private:
    void resolve_row(int block, int column, int row, RowPlace place) {
        const bool uniform = tile_.uniform >> block & 1;
        const int i = row * tile_size + column;
        const IntN slots = uniform ? IntN(tile_.block_slot[block]) : load_int<FloatN>(tile_.slot + i);
        const DepthFormat format = target_.depth_format();
        if (tile_.cleared) target_.write_clear(place.index, place.count);
        if (!uniform) {
            if (draw_.state.depth_write || tile_.cleared)
                store_lanes(target_.raw_depth_bits() + place.index, load_int<FloatN>(tile_.depth + i), MaskN(true), place.count);
        } else if (tile_.block_slot[block] != 0) {
            const Plane<float>& depth = tile_.slots[std::size_t(tile_.block_slot[block])].depth;
            store_lanes(target_.raw_depth_bits() + place.index, depth_row(format, depth, tile_.x + column, tile_.y + row),
                        MaskN(true), place.count);
        }
        if constexpr (HasFragment<S>) {
            if (!draw_.state.color_write) return;
            const FloatN px = to_float(IntN(tile_.x + column) + lane_index<FloatN>()), py(float(tile_.y + row));
            std::uint32_t rest = bitmask(slots != IntN(0)) & ((1u << place.count) - 1);
            while (rest) {
                const std::int32_t slot = slots.v[std::countr_zero(rest)];
                const MaskN mine = slots == IntN(slot);
                rest &= ~bitmask(mine);
                write_outputs<S>(target_, place, mine, shade_pixels<S, FloatN>(draw_.shader, planes(slot), px, py));
            }
        }
    }

    const ShadingPlanes<S>& planes(std::int32_t slot) {
        const std::size_t i = std::size_t(slot);
        if (!ready_[i]) {
            const Slot& s = tile_.slots[i];
            planes_[i] = make_shading_planes(draw_, pieces_[s.chunk], s.entry, s.depth, s.front_facing);
            ready_[i] = 1;
        }
        return planes_[i];
    }

    const DrawContext<S>& draw_;
    const std::vector<std::vector<ClippedPiece<S>>>& pieces_;
    TileBuffer& tile_;
    Target& target_;
    std::vector<ShadingPlanes<S>> planes_;
    std::vector<char> ready_;
};

}  // namespace raster::tiles
