// resolve.h: opaque draws: shade each visible pixel of a tile once, when all its triangles are known.
#pragma once

#include <raster/stages/blend.h>
#include <raster/tiles/shade.h>
#include <raster/tiles/tile.h>

namespace raster::tiles {

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
        store_int(to, all(passed) ? v : select(passed, v, load_int<FloatN>(to)));
    } else {
        std::uint32_t each[native_lanes];
        store_int(each, v);
        store_masked(to, each, bitmask(passed) & ((1u << count) - 1));
    }
}

/// Where a target's planes are. Held in a local variable, it need not be read again after each store.
struct TargetPlanes {
    Target& target;
    const bool is_rgba8 = target.color_format() == ColorFormat::rgba8;
    std::uint32_t* const color8 = target.raw_color8();
    std::uint32_t* const depth = target.raw_depth_bits();
};

/// Writes a fragment pack's colour and extra values to the target.
template <HasFragment S>
inline void write_outputs(const TargetPlanes& to, RowPlace place, MaskN passed, const OutputArray<S, FloatN>& out) {
    const vec<4, FloatN> color(out[0], out[1], out[2], out[3]);
    const std::uint32_t lanes_passed = bitmask(passed) & ((1u << place.count) - 1);
    Target& target = to.target;
    if (to.is_rgba8) {
        store_lanes(to.color8 + place.index, pack_rgba8(color), passed, place.count);
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
    /// `planes` is memory to be used again for the next tile.
    TileResolve(const ShadingContext<S>& context, TileBuffer& tile, Target& target, std::vector<ShadingPlanes<S>>& planes)
        : context_(context), state_(context.draw.state), tile_(tile), target_(target), planes_(planes) {}

    void run() {
        if (tile_.whole && tile_.whole_slot == 0) {
            if (tile_.cleared) target_.write_clear_tile(tile_.x, tile_.y, tile_size);
            return;
        }
        if (tile_.whole) split_tile(tile_);
        if (planes_.size() < tile_.slots.size()) planes_.resize(tile_.slots.size());
        ready_.assign(tile_.slots.size(), 0);
        columns_ = std::min(tile_size, target_.width() - tile_.x);
        rows_ = std::min(tile_size, target_.height() - tile_.y);
        for (int block = 0; block < block_count; ++block) {
            const int x = block % blocks_per_row * block_size, y = block / blocks_per_row * block_size;
            if (x >= columns_ || y >= rows_) continue;
            if (!(tile_.uniform >> block & 1)) {
                resolve_mixed(x, y);
            } else if (tile_.block_slot[block] != 0) {
                resolve_uniform(x, y, tile_.block_slot[block]);
            } else if (tile_.cleared) {
                clear_block(x, y);
            }
        }
    }

private:
    RowPlace place(int x, int y) const {
        return {target_.index(tile_.x + x, tile_.y + y), std::min(native_lanes, columns_ - x)};
    }
    void clear_block(int x, int y) {
        for (int row = y; row < std::min(y + block_size, rows_); ++row)
            target_.write_clear(target_.index(tile_.x + x, tile_.y + row), std::min(block_size, columns_ - x));
    }
    /// Extra planes that the shader does not fill keep the clear's value.
    bool fills_all_planes() const {
        if constexpr (HasFragment<S>) {
            return state_.color_write && output_count<S> - 4 >= target_.extra_channels();
        } else {
            return false;
        }
    }

    /// A block of one triangle.
    RASTER_FLATTEN void resolve_uniform(int x, int y, std::int32_t slot) {
        const DepthFormat format = target_.depth_format();
        if (tile_.cleared && !fills_all_planes()) clear_block(x, y);
        const TargetPlanes target{target_};
        // Copies, so that the compiler sees that stores to the target do not change them.
        const ShadingPlanes<S> p = planes(slot);
        const S shader = context_.shader;
        for (int row = y; row < std::min(y + block_size, rows_); ++row)
            for (int column = x; column < std::min(x + block_size, columns_); column += native_lanes) {
                const RowPlace to = place(column, row);
                store_lanes(target.depth + to.index, depth_row(format, p.depth, tile_.x + column, tile_.y + row),
                            MaskN(true), to.count);
                if constexpr (HasFragment<S>) {
                    if (!state_.color_write) continue;
                    const FloatN px = to_float(IntN(tile_.x + column) + lane_index<FloatN>()), py(float(tile_.y + row));
                    write_outputs<S>(target, to, MaskN(true), shade_pixels<S, FloatN>(shader, p, px, py));
                }
            }
    }

    /// A block of several triangles, or of some and what was there before.
    RASTER_FLATTEN void resolve_mixed(int x, int y) {
        if (tile_.cleared) clear_block(x, y);
        const TargetPlanes target{target_};
        const S shader = context_.shader;
        for (int row = y; row < std::min(y + block_size, rows_); ++row)
            for (int column = x; column < std::min(x + block_size, columns_); column += native_lanes) {
                const int i = row * tile_size + column;
                const RowPlace to = place(column, row);
                if (state_.depth_write || tile_.cleared)
                    store_lanes(target.depth + to.index, load_int<FloatN>(tile_.depth + i), MaskN(true), to.count);
                if constexpr (HasFragment<S>) {
                    if (!state_.color_write) continue;
                    const IntN slots = load_int<FloatN>(tile_.slot + i);
                    const FloatN px = to_float(IntN(tile_.x + column) + lane_index<FloatN>()), py(float(tile_.y + row));
                    std::uint32_t rest = bitmask(slots != IntN(0)) & ((1u << to.count) - 1);
                    while (rest) {
                        const std::int32_t slot = tile_.slot[i + std::countr_zero(rest)];
                        const MaskN mine = slots == IntN(slot);
                        rest &= ~bitmask(mine);
                        write_outputs<S>(target, to, mine, shade_pixels<S, FloatN>(shader, planes(slot), px, py));
                    }
                }
            }
    }

    const ShadingPlanes<S>& planes(std::int32_t slot) {
        const std::size_t i = std::size_t(slot);
        if (!ready_[i]) {
            planes_[i] = make_shading_planes(context_, tile_.slots[i]);
            ready_[i] = 1;
        }
        return planes_[i];
    }

    const ShadingContext<S>& context_;
    const State& state_;
    TileBuffer& tile_;
    Target& target_;
    std::vector<ShadingPlanes<S>>& planes_;
    std::vector<char> ready_;
    int columns_ = 0, rows_ = 0;
};

}  // namespace raster::tiles
