// shade.h: driver of stages 9 and 10: interpolate and shade a pack of pixels of one triangle.
#pragma once

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
    const S& shader;
    std::span<const VaryingArray<S>> varyings;
    std::span<const std::vector<std::array<VaryingArray<S>, 3>>> piece_varyings;
};

/// A triangle's planes, and what else its fragments are told.
template <Shader S>
struct ShadingPlanes {
    VaryingPlanes<S, float> varyings;
    Plane<float> depth;
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
                              value_at(widen(p.depth), px, py),
                              value_at(planes.oow, px, py),
                              Mask<F>(p.front_facing),
                              Int<F>(p.triangle)};
    return shade_fragment<S, F>(shader, interpolate<S, F>(planes, px, py), at);
}

}  // namespace raster::tiles
