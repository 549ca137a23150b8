// blend.h: draws that blend: shade and mix each fragment when it passes, in submission order.
#pragma once

#include <raster/tiles/raster.h>
#include <raster/tiles/resolve.h>

namespace raster::tiles {

/// The Sink that shades at once, straight into the target. The target's pending clear was written before.
template <HasFragment S>
class BlendSink : public SlotMaker {
public:
    static constexpr bool remembers = false;

    BlendSink(const ShadingContext<S>& context, TileBuffer& tile, Target& target)
        : SlotMaker(tile), context_(context), blend_(context.draw.state.blend), target_(target) {}

    void begin(const Plane<float>& depth, bool front_facing, std::uint32_t entry, std::uint32_t chunk) {
        SlotMaker::begin(depth, front_facing, entry, chunk);
        ready_ = false;
    }
    void pixel(int i, float px, float py) {
        const IntN lane = lane_index<FloatN>();
        blend(i, lane == IntN(0), FloatN(px) + to_float(lane), FloatN(py), native_lanes);
    }
    void cell(int i, MaskN passed, FloatN px, FloatN py) { blend(i, passed, px, py, cell_width); }
    void row(int i, MaskN passed, FloatN px, FloatN py) { blend(i, passed, px, py, native_lanes); }

    /// All pixels of a block.
    RASTER_FLATTEN void block(int x, int y) {
        make_planes();
        // Copies, so that the compiler sees that stores to the target do not change them.
        const ShadingPlanes<S> planes = planes_;
        const S shader = context_.shader;
        const Blend mode = blend_;
        const bool inside = tile_.x + x + block_size <= target_.width() && tile_.y + y + block_size <= target_.height();
        const bool simple = inside && target_.color_format() == ColorFormat::rgba8 && output_count<S> == 4;
        std::uint32_t* const color = target_.raw_color8();
        const std::size_t first = target_.index(tile_.x, tile_.y), pitch = std::size_t(target_.width());
        const int tile_x = tile_.x, tile_y = tile_.y;
        for (int row = y; row < y + block_size; ++row)
            for (int column = x; column < x + block_size; column += native_lanes) {
                const FloatN px = to_float(IntN(tile_x + column) + lane_index<FloatN>()), py(float(tile_y + row));
                if (!simple) {
                    blend(row * tile_size + column, MaskN(true), px, py, native_lanes);
                    continue;
                }
                const auto out = shade_pixels<S, FloatN>(shader, planes, px, py);
                std::uint32_t* to = color + first + std::size_t(row) * pitch + std::size_t(column);
                const IntN packed = pack_rgba8(vec<4, FloatN>(out[0], out[1], out[2], out[3]));
                store_int(to, blend_rgba8(mode, packed, load_int<FloatN>(to)));
            }
    }

private:
    void make_planes() {
        if (ready_) return;
        planes_ = make_shading_planes(context_, current());
        ready_ = true;
    }

    /// Lanes run along rows of `width` pixels, the first at tile pixel i.
    [[gnu::noinline]] RASTER_FLATTEN void blend(int i, MaskN passed, FloatN px, FloatN py, int width) {
        make_planes();
        OutputArray<S, FloatN> out = shade_pixels<S, FloatN>(context_.shader, planes_, px, py);
        const int x = tile_.x + i % tile_size, y = tile_.y + i / tile_size;
        for (int lane = 0; lane < native_lanes; lane += width) {
            const RowPlace place{target_.index(x, y + lane / width), std::clamp(target_.width() - x, 0, width)};
            const std::uint32_t mine = bitmask(passed) >> lane & ((1u << place.count) - 1);
            if (y + lane / width >= target_.height() || mine == 0) continue;
            blend_row(place, mine, lane, out);
        }
    }

    void blend_row(RowPlace place, std::uint32_t mine, int first_lane, const OutputArray<S, FloatN>& out) {
        const vec<4, FloatN> color(out[0], out[1], out[2], out[3]);
        if (target_.color_format() == ColorFormat::rgba8) {
            const IntN packed = pack_rgba8(color);
            std::uint32_t* to = target_.raw_color8() + place.index;
            if (first_lane == 0 && place.count == native_lanes) {
                const IntN stored = load_int<FloatN>(to);
                store_lanes(to, blend_rgba8(blend_, packed, stored), mask_of(mine), native_lanes);
            } else {
                for (std::uint32_t rest = mine; rest; rest &= rest - 1) {
                    const int k = std::countr_zero(rest);
                    to[k] = blend_rgba8(blend_, std::uint32_t(packed.v[first_lane + k]), to[k]);
                }
            }
        } else {
            for (std::uint32_t rest = mine; rest; rest &= rest - 1) {
                const int k = std::countr_zero(rest), lane = first_lane + k;
                glm::vec4& to = target_.raw_color_float()[place.index + std::size_t(k)];
                to = blend_float(blend_,
                                 glm::vec4(color.x.v[lane], color.y.v[lane], color.z.v[lane], color.w.v[lane]), to);
            }
        }
        if constexpr (output_count<S> > 4)
            for (int e = 0; e < std::min(output_count<S> - 4, target_.extra_channels()); ++e)
                for (std::uint32_t rest = mine; rest; rest &= rest - 1) {
                    const int k = std::countr_zero(rest);
                    target_.raw_extra(e)[place.index + std::size_t(k)] = out[std::size_t(4 + e)].v[first_lane + k];
                }
    }

    static MaskN mask_of(std::uint32_t bits) {
        IntN lane_bit;
        for (int i = 0; i < native_lanes; ++i) lane_bit.v[i] = 1 << i;
        return (IntN(std::int32_t(bits)) & lane_bit) != IntN(0);
    }

    const ShadingContext<S>& context_;
    Blend blend_;
    Target& target_;
    bool ready_ = false;
    ShadingPlanes<S> planes_;
};

}  // namespace raster::tiles
