// stroke.h: a line or a point of a draw, from its shaded corners to all that its pixels share.
#pragma once

#include <optional>

#include <raster/stages/interpolate.h>
#include <raster/stages/line.h>
#include <raster/stages/point.h>

namespace raster {

/// Set up as triangles are, with other edges. Neither has a back.
template <Shader S>
struct Stroke {
    std::array<Edge<float>, 4> edges;
    int edge_count;  ///< 4 for a line; 0 for a point, which covers all of its box
    PixelBox box;
    DepthPlane<float> depth;
    VaryingPlanes<S, float> varyings;
    std::uint32_t primitive;  ///< its number in the draw
};

/// Whether the stroke covers the centre of pixel (x, y) of its box.
template <Shader S>
inline bool covers(const Stroke<S>& stroke, int x, int y) {
    bool covered = stroke.box.contains(x, y);
    for (int i = 0; i < stroke.edge_count; ++i) {
        const Edge<float>& edge = stroke.edges[std::size_t(i)];
        covered = covered && is_inside(edge, edge_at(edge, x, y));
    }
    return covered;
}

/// What strokes of one draw have in common.
struct StrokeContext {
    const State& state;
    ViewportTransform viewport;
    int width, height;  ///< of the target
    PixelBox limits;
};

/// The line from a to b; nothing when none of it is visible, which `counts` tells of.
template <Shader S, std::size_t N>
inline std::optional<Stroke<S>> make_line(const StrokeContext& context, ShadedVertex<float, N> a,
                                          ShadedVertex<float, N> b, DrawCounts& counts) {
    const State& state = context.state;
    if (!is_finite(a.clip) || !is_finite(b.clip)) return ++counts.not_finite, std::nullopt;
    const std::int32_t code_a = outcode(a.clip) | user_outcode(state.clip_planes, a.clip);
    const std::int32_t code_b = outcode(b.clip) | user_outcode(state.clip_planes, b.clip);
    if (code_a & code_b) return ++counts.outside, std::nullopt;
    const auto provoking = b.varyings;
    if (code_a | code_b) {
        const auto inside = clip_line<S>(a, b, code_a | code_b, state.clip_planes);
        if (!inside) return ++counts.outside, std::nullopt;
        a = (*inside)[0], b = (*inside)[1];
    }
    const auto wa = project(a.clip, context.viewport), wb = project(b.clip, context.viewport);
    const auto setup =
        make_line_setup(wa, wb, std::max(state.line_width, 1), state.fill_rule, context.width, context.height);
    if (!setup) return ++counts.zero_area, std::nullopt;
    ++counts.drawn;

    Stroke<S> stroke{setup->edges, 4, intersection(setup->box, context.limits), {setup->depth, 0.0f}, {}, 0};
    VaryingPlanes<S, float>& planes = stroke.varyings;
    planes.oow = make_line_plane(setup->basis, wa.oow, wb.oow);
    for (std::size_t i = 0; i < N; ++i) {
        switch (interpolation_of<S>(int(i))) {
            case Interpolation::smooth:
                planes.planes[i] = make_line_plane(setup->basis, a.varyings[i] * wa.oow, b.varyings[i] * wb.oow);
                break;
            case Interpolation::noperspective:
                planes.planes[i] = make_line_plane(setup->basis, a.varyings[i], b.varyings[i]);
                break;
            case Interpolation::flat: planes.planes[i] = {provoking[i], 0, 0}; break;
        }
    }
    return stroke;
}

/// The point at v; nothing when its centre is not visible.
template <Shader S, std::size_t N>
inline std::optional<Stroke<S>> make_point(const StrokeContext& context, const ShadedVertex<float, N>& v,
                                           DrawCounts& counts) {
    const State& state = context.state;
    if (!is_finite(v.clip)) return ++counts.not_finite, std::nullopt;
    if (!is_point_visible(v.clip, state.clip_planes)) return ++counts.outside, std::nullopt;
    ++counts.drawn;
    const auto window = project(v.clip, context.viewport);
    const PixelBox box = point_pixels(window, state.point_size, state.fill_rule, context.width, context.height);
    Stroke<S> stroke{{}, 0, intersection(box, context.limits), {{window.z, 0, 0}, 0}, {}, 0};
    stroke.varyings.oow = {window.oow, 0, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const bool smooth = interpolation_of<S>(int(i)) == Interpolation::smooth;
        stroke.varyings.planes[i] = {smooth ? v.varyings[i] * window.oow : v.varyings[i], 0, 0};
    }
    return stroke;
}

/// Stages 2 to 6 of primitive number i of a draw's lines or points. vertex(k) gives the shaded vertex that entry k of
/// the index list, which has `indices` entries, names; null where there is none.
template <Shader S, class VertexAt>
inline std::optional<Stroke<S>> make_stroke(const StrokeContext& context, std::size_t i, std::size_t indices,
                                            const VertexAt& vertex, DrawCounts& counts) {
    ++counts.submitted;
    std::optional<Stroke<S>> stroke;
    if (context.state.topology == Topology::points) {
        const auto* const v = vertex(i);
        if (!v) return ++counts.bad_index, std::nullopt;
        stroke = make_point<S>(context, *v, counts);
    } else {
        const auto ends = assemble_line(context.state.topology, i, indices);
        const auto *const a = vertex(ends[0]), *const b = vertex(ends[1]);
        if (!a || !b) return ++counts.bad_index, std::nullopt;
        stroke = make_line<S>(context, *a, *b, counts);
    }
    if (stroke) stroke->primitive = std::uint32_t(i);
    return stroke;
}

}  // namespace raster
