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

/// The outputs of the pixels (px, py), one in each lane.
template <HasFragment S, class F>
inline OutputArray<S, F> shade_pixels(const S& shader, const ShadingPlanes<S>& p, F px, F py) {
    VaryingPlanes<S, F> planes;
    const auto widen = [](const Plane<float>& plane) { return Plane<F>{plane.origin, plane.dadx, plane.dady}; };
    planes.oow = widen(p.varyings.oow);
    for (std::size_t i = 0; i < std::size_t(varying_count<S>); ++i) planes.planes[i] = widen(p.varyings.planes[i]);
    const FragmentInput<F> at{{px + F(0.5f), py + F(0.5f)},
                              value_at(widen(p.depth), px, py) + F(p.depth.offset),
                              value_at(planes.oow, px, py),
                              Mask<F>(p.front_facing),
                              Int<F>(p.triangle)};
    return shade_fragment<S, F>(shader, interpolate<S, F>(planes, px, py), at);
}

/// One pack of outputs blended into the target: lane i into the pixel `index` + i, where bit i of `bits` is set.
template <HasFragment S>
inline void write_outputs(Target& target, std::size_t index, std::uint32_t bits, Blend blend, const OutputArray<S, FloatN>& out) {
    const vec<4, FloatN> color(out[0], out[1], out[2], out[3]);
    constexpr std::uint32_t full = (1u << native_lanes) - 1;
    if (target.color_format() == ColorFormat::rgba8) {
        std::uint32_t* const to = target.raw_color8() + index;
        const IntN packed = pack_rgba8(color);
        if (bits == full) {
            store_int(to, blend_rgba8(blend, packed, load_int<FloatN>(to)));
        } else {
            for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
                const int lane = std::countr_zero(rest);
                to[lane] = blend_rgba8(blend, std::uint32_t(packed.v[lane]), to[lane]);
            }
        }
    } else {
        glm::vec4* const to = target.raw_color_float() + index;
        for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            to[lane] = blend_float(blend, glm::vec4(color.x.v[lane], color.y.v[lane], color.z.v[lane], color.w.v[lane]), to[lane]);
        }
    }
    if constexpr (output_count<S> > 4)
        for (int e = 0; e < std::min(output_count<S> - 4, target.extra_channels()); ++e)
            for (std::uint32_t rest = bits; rest; rest &= rest - 1) {
                const int lane = std::countr_zero(rest);
                target.raw_extra(e)[index + std::size_t(lane)] = out[std::size_t(4 + e)].v[lane];
            }
}

/// Shades pixels of one triangle in the 8 x 8 block that begins at pixel (x, y) of the target: bit 8 r + c of `mask` is the
/// pixel in row r and column c, and is set for pixels of the target only. The one place where a draw runs its shader's
/// fragment function.
template <HasFragment S>
RASTER_FLATTEN void shade_block(const S& shader_in, const ShadingPlanes<S>& planes_in, Target& target, Blend blend, int x, int y,
                                std::uint64_t mask) {
    // Copies, so that the compiler sees that stores to the target change neither.
    const S shader = shader_in;
    const ShadingPlanes<S> planes = planes_in;
    for (std::uint64_t rest = mask; rest;) {
        const int first = std::countr_zero(rest) / native_lanes * native_lanes;
        const std::uint32_t bits = std::uint32_t(mask >> first) & ((1u << native_lanes) - 1);
        rest &= ~(std::uint64_t(bits) << first);
        const int column = x + first % block_size, row = y + first / block_size;
        const FloatN px = to_float(IntN(column) + lane_index<FloatN>()), py = float(row);
        write_outputs<S>(target, target.index(column, row), bits, blend, shade_pixels<S, FloatN>(shader, planes, px, py));
    }
}

}  // namespace raster::tiles
