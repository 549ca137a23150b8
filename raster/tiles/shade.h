// shade.h: driver of stages 9 to 11: interpolate, shade and blend pixels of one triangle.
#pragma once

#include <bit>

#include <raster/stages/blend.h>
#include <raster/stages/fragment.h>
#include <raster/stages/interpolate.h>
#include <raster/tiles/bin.h>
#include <raster/tiles/tile.h>
#include <raster/tiles/vertices.h>

namespace raster::tiles {

/// What shading adds to a DrawContext: the shader, and the varyings of vertices and of each chunk's clipped pieces.
template <Shader S>
struct ShadingContext {
    const DrawContext& draw;
    std::span<const ChunkBins> chunks;
    std::span<const char> touched;  ///< a tile: whether any chunk has entries for it
    const S& shader;
    std::span<const VaryingArray<S>> varyings;
    std::span<const std::vector<std::array<VaryingArray<S>, 3>>> piece_varyings;
};

/// A triangle's planes, and what else its fragments are told.
template <Shader S>
struct ShadingPlanes {
    VaryingPlanes<S, float> varyings;
    DepthPlane<float> depth;
    std::int32_t triangle;
    bool front_facing;
};

/// The planes of a bin's entry.
template <Shader S>
inline ShadingPlanes<S> make_shading_planes(const ShadingContext<S>& context, const Slot& slot) {
    const DrawContext& draw = context.draw;
    const ChunkBins& bins = context.chunks[slot.chunk];
    const LargeTriangle* large = slot.entry & large_bit ? &bins.large[slot.entry & ~large_bit] : nullptr;
    const std::uint32_t triangle = large ? large->triangle : slot.entry;
    const auto window = draw.corner_windows(bins, slot.entry);
    std::array<const VaryingArray<S>*, 3> varyings;
    if (large && large->piece >= 0) {
        for (std::size_t c = 0; c < 3; ++c)
            varyings[c] = &context.piece_varyings[slot.chunk][std::size_t(large->piece)][c];
    } else {
        const auto corners = draw.corners(triangle);
        for (std::size_t c = 0; c < 3; ++c) varyings[c] = &context.varyings[corners[c] - draw.first_vertex];
    }
    const bool counter_clockwise = slot.front_facing == (draw.state.front_face == FrontFace::counter_clockwise);
    const auto order = setup_order(counter_clockwise ? 1 : -1);
    const auto at = [&](std::size_t i) { return std::size_t(order[i]); };
    const PlaneBasis<float> basis = make_plane_basis(window[at(0)], window[at(1)], window[at(2)]);
    return {make_varying_planes<S, float>(basis, {varyings[at(0)], varyings[at(1)], varyings[at(2)]},
                                          {window[at(0)].oow, window[at(1)].oow, window[at(2)].oow}),
            slot.depth, std::int32_t(triangle), slot.front_facing};
}

/// One triangle's planes along a column of pixels.
template <HasFragment S, class F>
struct ShadingColumn {
    VaryingColumns<S, F> varyings;
    Column<F> depth;
    F depth_offset, px;

    ShadingColumn(const ShadingPlanes<S>& p, F px)
        : varyings(columns_at<S, F>(p.varyings, px)),
          depth(column_at(Plane<F>{p.depth.origin, p.depth.dadx, p.depth.dady}, px)),
          depth_offset(p.depth.offset),
          px(px) {}
};

/// The outputs of the pixels (px, py), one in each lane.
template <HasFragment S, class F>
inline OutputArray<S, F> shade_pixels(const S& shader, const ShadingPlanes<S>& p, const ShadingColumn<S, F>& column, F py) {
    F oow = value_at(column.varyings.oow, py);
    FragmentInput<F> at{{column.px + F(0.5f), py + F(0.5f)}, value_at(column.depth, py) + column.depth_offset, oow,
                        Mask<F>(p.front_facing), Int<F>(p.triangle)};
    return shade_fragment<S, F>(shader, interpolate<S, F>(column.varyings, py, oow), at);
}

/// One pack of outputs blended into the target: lane i into the pixel index[i], where bit i of `bits` is set.
template <HasFragment S>
inline void write_pixels(Target& target, const std::array<std::size_t, native_lanes>& index, std::uint32_t bits, Blend blend,
                         const OutputArray<S, FloatN>& out) {
    const vec<4, FloatN> color(out[0], out[1], out[2], out[3]);
    if (target.color_format() == ColorFormat::rgba8) {
        IntN packed = pack_rgba8(color);
        for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            std::uint32_t& to = target.raw_color8()[index[std::size_t(lane)]];
            to = blend_rgba8(blend, std::uint32_t(packed.v[lane]), to);
        }
    } else {
        for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            glm::vec4& to = target.raw_color_float()[index[std::size_t(lane)]];
            to = blend_float(blend, glm::vec4(color.x.v[lane], color.y.v[lane], color.z.v[lane], color.w.v[lane]), to);
        }
    }
    if constexpr (output_count<S> > 4)
        for (int e = 0; e < std::min(output_count<S> - 4, target.extra_channels()); ++e)
            for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
                const int lane = std::countr_zero(rest);
                target.raw_extra(e)[index[std::size_t(lane)]] = out[std::size_t(4 + e)].v[lane];
            }
}

/// The same for neighbours in a row, the first of them pixel `first`, all of them pixels of the target.
template <HasFragment S>
inline void write_row(Target& target, std::size_t first, std::uint32_t bits, Blend blend, const OutputArray<S, FloatN>& out) {
    if (target.color_format() == ColorFormat::rgba8 && (output_count<S> == 4 || target.extra_channels() == 0)) {
        std::uint32_t* const to = target.raw_color8() + first;
        IntN color = pack_rgba8(vec<4, FloatN>(out[0], out[1], out[2], out[3]));
        constexpr std::uint32_t full = (1u << native_lanes) - 1;
        if (blend != Blend::off || bits != full) {
            IntN before = load_int<FloatN>(to);
            color = select(mask_of_bits<FloatN>(bits), blend_rgba8(blend, color, before), before);
        }
        store_int(to, color);
    } else {
        std::array<std::size_t, native_lanes> index;
        for (std::size_t i = 0; i < index.size(); ++i) index[i] = first + i;
        write_pixels<S>(target, index, bits, blend, out);
    }
}

/// Shades pixels of one triangle in the 8 x 8 block that begins at pixel (x, y) of the target: bit 8 r + c of `mask` is the
/// pixel in row r and column c, and is set for pixels of the target only. The one place where a draw runs its shader's
/// fragment function.
template <HasFragment S>
RASTER_FLATTEN void shade_block(const S& shader_in, const ShadingPlanes<S>& planes_in, Target& target, Blend blend, int x, int y,
                                std::uint64_t mask) {
    // Copies, so that the compiler sees that stores to the target change neither.
    S shader = shader_in;
    ShadingPlanes<S> planes = planes_in;
    constexpr std::uint64_t pack_bits = (1u << native_lanes) - 1, first_column = 0x0101010101010101u;

    // Rows where they are well filled: what the rows share is computed once.
    const int pixels = std::popcount(mask);
    std::uint64_t rows = mask | mask >> 4;
    rows = (rows | rows >> 2);
    rows = (rows | rows >> 1) & first_column;
    if (x + block_size <= target.width() && 2 * pixels >= block_size * std::popcount(rows)) {
        for (int c = 0; c < block_size; c += native_lanes) {
            std::uint64_t rest = mask & (first_column * pack_bits) << c;
            if (rest == 0) continue;
            const auto take_row = [&](int& row) {
                row = std::countr_zero(rest) / block_size;
                const std::uint32_t bits = std::uint32_t(rest >> (row * block_size + c) & pack_bits);
                rest &= ~(pack_bits << (row * block_size + c));
                return bits;
            };
            FloatN px = to_float(IntN(x + c) + lane_index<FloatN>());
            ShadingColumn<S, FloatPair> column(planes, FloatPair(FloatPair::V{px.v, px.v}));
            while (rest) {
                int row0, row1;
                const std::uint32_t bits0 = take_row(row0);
                row1 = row0;
                const std::uint32_t bits1 = rest ? take_row(row1) : 0;
                FloatPair py(FloatPair::V{FloatN(float(y + row0)).v, FloatN(float(y + row1)).v});
                const OutputArray<S, FloatPair> out = shade_pixels<S, FloatPair>(shader, planes, column, py);
                OutputArray<S, FloatN> out0, out1;
                for (std::size_t i = 0; i < out.size(); ++i) out0[i] = out[i].v.half[0], out1[i] = out[i].v.half[1];
                write_row<S>(target, target.index(x + c, y + row0), bits0, blend, out0);
                if (bits1) write_row<S>(target, target.index(x + c, y + row1), bits1, blend, out1);
            }
        }
        return;
    }
    // Else pixels from anywhere in the block share a pack.
    for (std::uint64_t rest = mask; rest;) {
        std::array<std::size_t, native_lanes> index;
        IntN px(x), py(y);
        std::uint32_t bits = 0;
        for (int lane = 0; lane < native_lanes && rest; ++lane, rest &= rest - 1) {
            const int at = std::countr_zero(rest), column = x + at % block_size, row = y + at / block_size;
            index[std::size_t(lane)] = target.index(column, row);
            px.v[lane] = column, py.v[lane] = row;
            bits |= 1u << lane;
        }
        ShadingColumn<S, FloatN> column(planes, to_float(px));
        write_pixels<S>(target, index, bits, blend, shade_pixels<S, FloatN>(shader, planes, column, to_float(py)));
    }
}

}  // namespace raster::tiles
