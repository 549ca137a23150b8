// planes.h: driver of the last part of stage 6: the planes of varyings, of triangles that are visible in a tile.
#pragma once

#include <bit>

#include <raster/stages/fragment.h>
#include <raster/stages/interpolate.h>
#include <raster/tiles/bin.h>
#include <raster/tiles/vertices.h>

namespace raster::tiles {

/// What shading adds to a DrawContext: the shader, and the varyings of vertices and of each chunk's clipped pieces.
template <Shader S>
struct ShadingContext {
    const DrawContext& draw;
    std::span<const ChunkBins> chunks;
    std::span<const char> touched;       ///< a tile: whether any chunk has entries for it
    std::span<const char> cleared_rows;  ///< a row of tiles: whether the pending clear was written over it
    const S& shader;
    std::span<const VaryingArray<S>> varyings;
    std::span<const std::vector<std::array<VaryingArray<S>, 3>>> piece_varyings;
};

/// How many numbers the planes of 1/w and of the varyings are, and those numbers, rounded up to fours.
template <Shader S>
inline constexpr std::size_t plane_floats = 3 * (1 + std::size_t(varying_count<S>));
template <Shader S, class F>
using PlaneNumbers = std::array<F, (plane_floats<S> + 3) / 4 * 4>;

template <Shader S, class F>
inline PlaneNumbers<S, F> to_numbers(const VaryingPlanes<S, F>& p) {
    PlaneNumbers<S, F> r{};
    r[0] = p.oow.origin, r[1] = p.oow.dadx, r[2] = p.oow.dady;
    for (std::size_t i = 0, k = 3; i < p.planes.size(); ++i, k += 3)
        r[k] = p.planes[i].origin, r[k + 1] = p.planes[i].dadx, r[k + 2] = p.planes[i].dady;
    return r;
}
template <Shader S, class F>
inline VaryingPlanes<S, F> from_numbers(const PlaneNumbers<S, F>& numbers) {
    const auto plane = [&](std::size_t k) { return Plane<F>{numbers[k], numbers[k + 1], numbers[k + 2]}; };
    VaryingPlanes<S, F> r;
    r.oow = plane(0);
    for (std::size_t i = 0; i < r.planes.size(); ++i) r.planes[i] = plane(3 + 3 * i);
    return r;
}

/// A triangle's planes, and what else its fragments are told, in groups of four numbers: packs whose lanes are of several
/// triangles gather them so.
template <Shader S>
struct alignas(16) ShadingPlanes {
    PlaneNumbers<S, float> varyings;
    float depth[4];               ///< origin, dadx, dady, offset
    std::int32_t triangle;
    std::int32_t front_facing;    ///< -1 where it is, 0 where not, as in a lane of a mask
    std::int32_t unused[2];
};

namespace detail {

/// In which order the corners of a triangle that faces so are set up.
inline auto corner_order(const DrawContext& draw, bool front_facing) {
    const bool counter_clockwise = front_facing == (draw.state.front_face == FrontFace::counter_clockwise);
    return setup_order(counter_clockwise ? 1 : -1);
}

/// The corners of a triangle in that order, as numbers among the shaded vertices.
inline std::array<std::int32_t, 3> ordered_corners(const DrawContext& draw, std::uint32_t triangle, bool front_facing) {
    const auto corners = draw.corners(triangle);
    const auto order = corner_order(draw, front_facing);
    std::array<std::int32_t, 3> r;
    for (std::size_t c = 0; c < 3; ++c) r[c] = std::int32_t(corners[std::size_t(order[c])] - draw.first_vertex);
    return r;
}

/// All that is not planes of varyings.
template <Shader S>
inline void describe(ShadingPlanes<S>& planes, const Slot& slot, std::uint32_t triangle) {
    const DepthPlane<float>& depth = slot.depth;
    planes.depth[0] = depth.origin, planes.depth[1] = depth.dadx, planes.depth[2] = depth.dady,
    planes.depth[3] = depth.offset;
    planes.triangle = std::int32_t(triangle);
    planes.front_facing = slot.front_facing ? -1 : 0;
}

}  // namespace detail

/// The planes of a bin's entry.
template <Shader S>
inline ShadingPlanes<S> make_shading_planes(const ShadingContext<S>& context, const Slot& slot) {
    const DrawContext& draw = context.draw;
    const ChunkBins& bins = context.chunks[slot.chunk];
    const LargeTriangle* large = slot.entry & large_bit ? &bins.large[slot.entry & ~large_bit] : nullptr;
    const std::uint32_t triangle = large ? large->triangle : slot.entry;
    std::array<const VaryingArray<S>*, 3> varyings;
    std::array<WindowVertex<float>, 3> window;
    if (large && large->piece >= 0) {
        const auto order = detail::corner_order(draw, slot.front_facing);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t from = std::size_t(order[c]);
            window[c] = large->window[from];
            varyings[c] = &context.piece_varyings[slot.chunk][std::size_t(large->piece)][from];
        }
    } else {
        const auto corners = detail::ordered_corners(draw, triangle, slot.front_facing);
        for (std::size_t c = 0; c < 3; ++c) {
            window[c] = draw.window[std::size_t(corners[c])];
            varyings[c] = &context.varyings[std::size_t(corners[c])];
        }
    }
    ShadingPlanes<S> r;
    r.varyings = to_numbers<S, float>(make_varying_planes<S, float>(make_plane_basis(window[0], window[1], window[2]),
                                                                    varyings,
                                                                    {window[0].oow, window[1].oow, window[2].oow}));
    detail::describe(r, slot, triangle);
    return r;
}

/// Asks for the varyings of the corners of slots whose planes are made soon.
template <Shader S>
inline void prefetch_varyings(const ShadingContext<S>& context, std::span<const Slot> slots,
                              std::span<const std::int32_t> which) {
    if (std::size_t(varying_count<S>) == 0) return;
    for (const std::int32_t w : which) {
        const Slot& slot = slots[std::size_t(w)];
        if (slot.entry & large_bit) continue;
        for (const std::uint32_t v : context.draw.corners(slot.entry))
            prefetch(context.varyings.data() + (v - context.draw.first_vertex));
    }
}

/// The planes of the slots `which`, at most lanes<FloatN> of them, a slot a lane: out[i] are those of slots[which[i]].
template <Shader S>
RASTER_ONE_CALL void make_shading_planes(const ShadingContext<S>& context, std::span<const Slot> slots,
                                         std::span<const std::int32_t> which, ShadingPlanes<S>* out) {
    const DrawContext& draw = context.draw;
    std::array<IntN, 3> places{IntN(0), IntN(0), IntN(0)};
    std::array<std::uint32_t, native_lanes> triangles;
    std::uint32_t pieces = 0;
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Slot& slot = slots[std::size_t(which[i])];
        triangles[i] = slot.entry;
        if (slot.entry & large_bit) {
            const LargeTriangle& large = context.chunks[slot.chunk].large[slot.entry & ~large_bit];
            triangles[i] = large.triangle;
            if (large.piece >= 0) pieces |= 1u << i;
        }
        const auto corners = detail::ordered_corners(draw, triangles[i], slot.front_facing);
        for (std::size_t c = 0; c < 3; ++c) places[c].v[int(i)] = corners[c];
    }
    constexpr std::size_t count = std::size_t(varying_count<S>);
    std::array<WindowVertex<FloatN>, 3> window;
    std::array<VaryingArray<S, FloatN>, 3> varyings;
    for (std::size_t c = 0; c < 3; ++c) {
        WindowVertex<FloatN>& w = window[c];
        gather4(&draw.window[0].x, places[c], w.x, w.y, w.z, w.oow);
        // The last four may end behind the vertex's own; ScratchBuffer has room behind the last vertex's.
        std::array<FloatN, (count + 3) / 4 * 4> four_by_four;
        for (std::size_t k = 0; k < count; k += 4)
            gather4(context.varyings[0].data() + k, places[c], four_by_four[k], four_by_four[k + 1],
                    four_by_four[k + 2], four_by_four[k + 3], std::ptrdiff_t(count));
        std::copy_n(four_by_four.begin(), count, varyings[c].begin());
    }
    const auto numbers = to_numbers<S, FloatN>(make_varying_planes<S, FloatN>(
        make_plane_basis(window[0], window[1], window[2]), {&varyings[0], &varyings[1], &varyings[2]},
        {window[0].oow, window[1].oow, window[2].oow}));
    for (std::size_t k = 0; k < numbers.size(); k += 4)
        scatter4(out->varyings.data() + k, int(which.size()), sizeof(ShadingPlanes<S>) / sizeof(float),
                 numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3]);
    for (std::size_t i = 0; i < which.size(); ++i)
        detail::describe(out[i], slots[std::size_t(which[i])], triangles[i]);
    for (; pieces; pieces &= pieces - 1) {
        const std::size_t i = std::size_t(std::countr_zero(pieces));
        out[i] = make_shading_planes(context, slots[std::size_t(which[i])]);
    }
}

}  // namespace raster::tiles
