// shade.h: driver of stages 9 to 11: interpolate, shade and blend pixels, of one triangle or of several.
#pragma once

#include <bit>
#include <optional>

#include <raster/stages/blend.h>
#include <raster/stages/fragment.h>
#include <raster/tiles/columns.h>
#include <raster/tiles/fill.h>
#include <raster/tiles/tile.h>

namespace raster::tiles {

/// The outputs of the pixels (px, py), one in each lane.
template <HasFragment S, class F>
inline OutputArray<S, F> shade_pixels(const S& shader, const ShadingColumn<S, F>& column, F py) {
    F oow = value_at(column.varyings.oow, py);
    FragmentInput<F> at{{column.px + F(0.5f), py + F(0.5f)}, value_at(column.depth, py) + column.depth_offset, oow,
                        column.front_facing, column.triangle};
    return shade_fragment<S, F>(shader, interpolate<S, F>(column.varyings, py, oow), at);
}

/// Whether all that a draw writes of a fragment is a packed colour.
template <HasFragment S>
inline bool writes_rgba8_only(const Target& target) {
    return target.color_format() == ColorFormat::rgba8 && (output_count<S> == 4 || target.extra_channels() == 0);
}

/// The packed colour of all pixels of a triangle, where they have one and nothing else is written.
template <HasFragment S>
inline std::optional<std::uint32_t> constant_color(const S& shader, const ShadingPlanes<S>& planes,
                                                   const Target& target) {
    if constexpr (is_constant_fragment<S>) {
        if (writes_rgba8_only<S>(target)) {
            const ShadingColumn<S, FloatN> anywhere(planes, FloatN(0));
            const OutputArray<S, FloatN> out = shade_pixels<S, FloatN>(shader, anywhere, FloatN(0));
            return std::uint32_t(lane(pack_rgba8(vec<4, FloatN>(out[0], out[1], out[2], out[3])), 0));
        }
    }
    return std::nullopt;
}

/// One pack of outputs blended into the target: lane i into the pixel index[i], where bit i of `bits` is set.
template <HasFragment S>
inline void write_pixels(Target& target, const std::array<std::size_t, native_lanes>& index, std::uint32_t bits,
                         Blend blend, const OutputArray<S, FloatN>& out) {
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
inline void write_row(Target& target, std::size_t first, std::uint32_t bits, Blend blend,
                      const OutputArray<S, FloatN>& out) {
    if (writes_rgba8_only<S>(target)) {
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

/// The first pixels of a row as bits, a pack of them.
inline constexpr std::uint64_t pack_bits = (1u << native_lanes) - 1;

/// Whether a block's pixels are shaded row by row, because the rows are well filled; else pixels from anywhere in the block
/// share a pack.
inline bool worth_rows(const Target& target, int x, std::uint64_t mask) {
    std::uint64_t rows = mask | mask >> 4;
    rows = (rows | rows >> 2);
    rows = (rows | rows >> 1) & first_column;
    return x + block_size <= target.width() && 2 * std::popcount(mask) >= block_size * std::popcount(rows);
}

/// Takes the pixels of a mask in packs. For each, its columns and rows in lanes, dead lanes those of the block's first
/// pixel, and the places in the target.
template <class Function>
inline void for_packs(const Target& target, int x, int y, std::uint64_t mask, const Function& function) {
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
        function(px, py, bits, index);
    }
}

/// Shades the columns from x on of the rows y0 and y1, where their bits are set.
template <HasFragment S>
inline void shade_two_rows(const S& shader, const ShadingColumn<S, FloatPair>& column, Target& target, Blend blend,
                           int x, int y0, std::uint32_t bits0, int y1, std::uint32_t bits1) {
    const FloatPair py(FloatPair::V{FloatN(float(y0)).v, FloatN(float(y1)).v});
    const OutputArray<S, FloatPair> out = shade_pixels<S, FloatPair>(shader, column, py);
    OutputArray<S, FloatN> out0, out1;
    for (std::size_t i = 0; i < out.size(); ++i) out0[i] = out[i].v.half[0], out1[i] = out[i].v.half[1];
    if (bits0) write_row<S>(target, target.index(x, y0), bits0, blend, out0);
    if (bits1) write_row<S>(target, target.index(x, y1), bits1, blend, out1);
}

/// Shades pixels of one triangle in the block that begins at pixel (x, y) of the target; `mask` holds pixels of the target
/// only. With shade_run and shade_mixed the place where a draw runs its shader's fragment function.
template <HasFragment S>
RASTER_FLATTEN void shade_block(const S& shader_in, const ShadingPlanes<S>& planes_in, Target& target, Blend blend,
                                int x, int y, std::uint64_t mask) {
    // Copies, so that the compiler sees that stores to the target change neither.
    S shader = shader_in;
    ShadingPlanes<S> planes = planes_in;
    if (const auto color = constant_color(shader, planes, target))
        return fill_block(target, blend, *color, x, y, mask);
    if (!worth_rows(target, x, mask)) {
        for_packs(target, x, y, mask, [&](IntN px, IntN py, std::uint32_t bits, const auto& index) {
            ShadingColumn<S, FloatN> column(planes, to_float(px));
            write_pixels<S>(target, index, bits, blend, shade_pixels<S, FloatN>(shader, column, to_float(py)));
        });
        return;
    }
    // What the rows share is computed once.
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
        ShadingColumn<S, FloatPair> column(planes, twice(px));
        while (rest) {
            int row0, row1;
            const std::uint32_t bits0 = take_row(row0);
            row1 = row0;
            const std::uint32_t bits1 = rest ? take_row(row1) : 0;
            shade_two_rows(shader, column, target, blend, x + c, y + row0, bits0, y + row1, bits1);
        }
    }
}

/// Shades all pixels of `blocks` neighbouring blocks in a row of one triangle: row by row, so that memory is written in the
/// order of its addresses, and that of textures read so where they lie level.
template <HasFragment S>
RASTER_FLATTEN void shade_run(const S& shader_in, const ShadingPlanes<S>& planes_in, Target& target, Blend blend, int x,
                              int y, int blocks) {
    S shader = shader_in;
    ShadingPlanes<S> planes = planes_in;
    if (const auto color = constant_color(shader, planes, target))
        return fill_run(target, blend, *color, x, y, blocks);
    const int packs = blocks * block_size / native_lanes;
    ShadingColumn<S, FloatN> columns[tile_size / native_lanes];
    for (int p = 0; p < packs; ++p)
        columns[p] = ShadingColumn<S, FloatN>(planes, to_float(IntN(x + p * native_lanes) + lane_index<FloatN>()));
    for (int row = y; row < y + block_size; row += 2)
        for (int p = 0; p < packs; ++p)
            shade_two_rows(shader, twice(columns[p]), target, blend, x + p * native_lanes, row,
                           std::uint32_t(pack_bits), row + 1, std::uint32_t(pack_bits));
}

/// The triangles of a block that shows few of them, as places in a list of planes.
struct FewTriangles {
    static constexpr int most = 4;
    std::int32_t at[most];
    int count = 0;  ///< 0 where they are many
};

/// The same for pixels of several triangles: the pixel of bit i shows the triangle planes[owners[i % 8 + tile_size (i / 8)]].
/// A pack's lanes may then be of different triangles, however small these are.
template <HasFragment S>
RASTER_FLATTEN void shade_mixed(const S& shader_in, const ShadingPlanes<S>* planes, const std::int32_t* owners,
                                const FewTriangles& few, Target& target, int x, int y, std::uint64_t mask) {
    S shader = shader_in;
    if (!worth_rows(target, x, mask)) {
        const std::int32_t any_owner =
            owners[std::countr_zero(mask) / block_size * tile_size + std::countr_zero(mask) % block_size];
        for_packs(target, x, y, mask, [&](IntN px, IntN py, std::uint32_t bits, const auto& index) {
            IntN which(any_owner);
            for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
                const int lane = std::countr_zero(rest);
                which.v[lane] = owners[(py.v[lane] - y) * tile_size + px.v[lane] - x];
            }
            ShadingColumn<S, FloatN> column(planes, which, to_float(px));
            write_pixels<S>(target, index, bits, Blend::off, shade_pixels<S, FloatN>(shader, column, to_float(py)));
        });
        return;
    }
    for (int c = 0; c < block_size; c += native_lanes) {
        FloatN px = to_float(IntN(x + c) + lane_index<FloatN>());
        ShadingColumn<S, FloatN> columns[FewTriangles::most];
        for (int t = 0; t < few.count; ++t) columns[t] = ShadingColumn<S, FloatN>(planes[few.at[t]], px);
        for (int row = 0; row < block_size; row += 2) {
            const auto bits_of = [&](int r) { return std::uint32_t(mask >> (r * block_size + c) & pack_bits); };
            const std::uint32_t bits0 = bits_of(row), bits1 = bits_of(row + 1);
            if ((bits0 | bits1) == 0) continue;
            const std::int32_t* const owner0 = owners + row * tile_size + c;
            const std::int32_t* const owner1 = owner0 + tile_size;
            const Int<FloatPair> which = pair(load_int<FloatN>(owner0), load_int<FloatN>(owner1));
            ShadingColumn<S, FloatPair> column;
            if (few.count) {
                const auto shows = [&](int t) { return which == Int<FloatPair>(few.at[t]); };
                column = choose(shows(1), twice(columns[1]), twice(columns[0]));
                for (int t = 2; t < few.count; ++t) column = choose(shows(t), twice(columns[t]), column);
            } else {
                // Pixels that nobody owns take a neighbour's planes: garbage, but tame garbage.
                const IntN any_owner(bits0 ? owner0[std::countr_zero(bits0)] : owner1[std::countr_zero(bits1)]);
                const Mask<FloatPair> owned = pair(mask_of_bits<FloatN>(bits0), mask_of_bits<FloatN>(bits1));
                column = ShadingColumn<S, FloatPair>(planes, select(owned, which, twice(any_owner)), twice(px));
            }
            shade_two_rows(shader, column, target, Blend::off, x + c, y + row, bits0, y + row + 1, bits1);
        }
    }
}

}  // namespace raster::tiles
