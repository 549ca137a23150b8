// pipeline.h: draw(), the stages in order: the table of contents of this library.
//
//      1 vertex        object space to clip space                stages/vertex.h
//      2 assemble      indices to triangles                      stages/assemble.h
//      3 clip          cut at the view volume                    stages/clip.h
//      4 project       clip space to window and subpixel grid    stages/project.h
//      5 cull          which way it faces                        stages/cull.h
//      6 setup         edge functions and planes                 stages/setup.h
//      7 coverage      which pixel centres are inside            stages/coverage.h
//      8 depth         the z-buffer                              stages/depth.h
//      9 interpolate   varyings at a pixel                       stages/interpolate.h
//     10 fragment      varyings to colour                        stages/fragment.h
//     11 blend         colour into the target                    stages/blend.h
//
// Lines and points take the same way; stages/stroke.h has their stages 2 to 7. Stages 8 to 11 of one pixel are in pixel.h.
//
// A pixel is a pure function of (triangle setup, x, y), folded over the triangles in submission order. So the observed
// draw below, which takes one pixel after the other, and the fast one in tiles/draw.h give the same bits.
#pragma once

#include <raster/pixel.h>
#include <raster/shader.h>
#include <raster/stages/assemble.h>
#include <raster/stages/blend.h>
#include <raster/stages/clip.h>
#include <raster/stages/coverage.h>
#include <raster/stages/cull.h>
#include <raster/stages/depth.h>
#include <raster/stages/fragment.h>
#include <raster/stages/interpolate.h>
#include <raster/stages/project.h>
#include <raster/stages/setup.h>
#include <raster/stages/stroke.h>
#include <raster/stages/vertex.h>
#include <raster/state.h>
#include <raster/target.h>
#include <raster/tiles/draw.h>
#include <raster/tiles/strokes.h>
#include <raster/trace/events.h>

namespace raster {

/// Draws a mesh: lanes, tiles, all threads. `target` must have the extra planes that the shader's outputs fill; missing
/// ones are not written.
template <Shader S>
DrawCounts draw(Target& target, const S& shader,
                const std::type_identity_t<Mesh<typename S::template Vertex<float>>>& mesh, const State& state = {}) {
    if (corner_count(state.topology) < 3) return tiles::draw_strokes(target, shader, mesh, state);
    return tiles::draw(target, shader, mesh, state);
}

namespace detail {

/// A pipeline as it should be. A variant for teaching (bugs/variant.h) changes what some stages gave.
struct NoVariant {};
inline constexpr NoVariant no_variant;

/// One observed draw call: what its stages share.
template <Shader S, class Observer, class Variant = const NoVariant>
class ObservedDraw {
public:
    ObservedDraw(Target& target, const S& shader, const Mesh<typename S::template Vertex<float>>& mesh,
                 const State& state, Observer& observer, Variant& variant = no_variant)
        : target_(target),
          shader_(shader),
          mesh_(mesh),
          state_(state),
          viewport_(effective_viewport(state.viewport, target.width(), target.height())),
          limits_(drawable_pixels(state, target.width(), target.height())),
          observer_(observer),
          variant_(variant) {}

    DrawCounts run() {
        if (!is_valid(viewport_)) return {};
        shade_vertices();
        const std::size_t indices = mesh_.indices.empty() ? mesh_.vertices.size() : mesh_.indices.size();
        const std::size_t primitives = primitive_count(state_.topology, indices);
        const bool triangles = corner_count(state_.topology) == 3;
        const StrokeContext context{state_, ViewportTransform(viewport_), target_.width(), target_.height(), limits_};
        for (std::size_t i = 0; i < primitives; ++i)
            triangles ? draw_triangle(std::int64_t(i)) : draw_stroke(context, i, indices);
        return counts_;
    }

private:
    using Vertex = ShadedVertex<float, std::size_t(varying_count<S>)>;
    using Polygon = ClipPolygon<std::size_t(varying_count<S>)>;

    void shade_vertices() {
        shaded_.resize(mesh_.vertices.size());
        for (std::size_t i = 0; i < shaded_.size(); ++i) {
            shaded_[i] = shade_vertex<S, float>(shader_, mesh_.vertices[i]);
            std::array<float, std::size_t(attribute_count<S>)> attributes;  // outlives the event, which only refers to it
            notify<VertexEvent>(observer_, [&] {
                attributes = std::bit_cast<decltype(attributes)>(mesh_.vertices[i]);
                return VertexEvent{std::uint32_t(i), attributes, shaded_[i].clip, shaded_[i].varyings};
            });
        }
    }

    void draw_triangle(std::int64_t triangle) {
        ++counts_.submitted;

        std::array<std::uint32_t, 3> vertices;
        const auto places = assemble(state_.topology, std::size_t(triangle));
        for (std::size_t c = 0; c < 3; ++c)
            vertices[c] = mesh_.indices.empty() ? std::uint32_t(places[c]) : mesh_.indices[places[c]];
        const bool bad_index = std::ranges::any_of(vertices, [&](std::uint32_t v) { return v >= shaded_.size(); });
        notify<AssembleEvent>(observer_, [&] { return AssembleEvent{triangle, vertices, bad_index}; });
        if (bad_index) {
            ++counts_.bad_index;
            return;
        }

        const Polygon polygon = clip(triangle, {shaded_[vertices[0]], shaded_[vertices[1]], shaded_[vertices[2]]});
        PieceFate fate;
        for (int piece = 0; piece + 2 < polygon.count; ++piece) {
            const auto fan = polygon.clipped ? clip_fan(piece) : std::array{0, 1, 2};
            draw_piece(triangle, piece,
                       {polygon.corners[std::size_t(fan[0])], polygon.corners[std::size_t(fan[1])],
                        polygon.corners[std::size_t(fan[2])]},
                       fate);
        }
        if (polygon.count >= 3) fate.count(counts_);
    }

    Polygon clip(std::int64_t triangle, const std::array<Vertex, 3>& corners) {
        using Verdict = ClipEvent::Verdict;
        const auto tell = [&](const std::array<std::int32_t, 3>& outcodes, Verdict verdict, int pieces) {
            notify<ClipEvent>(observer_, [&] {
                return ClipEvent{
                    triangle, {corners[0].clip, corners[1].clip, corners[2].clip}, outcodes, verdict, pieces};
            });
        };
        std::array<std::int32_t, 3> outcodes;
        Polygon polygon;
        bool finite = true;
        for (std::size_t c = 0; c < 3; ++c) {
            outcodes[c] = outcode(corners[c].clip) | user_outcode(state_.clip_planes, corners[c].clip);
            if constexpr (requires { variant_.change_outcode(outcodes[c]); }) variant_.change_outcode(outcodes[c]);
            finite = finite && is_finite(corners[c].clip);
            polygon.add(corners[c]);
        }
        if (!finite) {
            ++counts_.not_finite;
            tell(outcodes, Verdict::not_finite, 0);
            return {};
        }
        if (outcodes[0] & outcodes[1] & outcodes[2]) {
            ++counts_.outside;
            tell(outcodes, Verdict::outside, 0);
            return {};
        }
        const std::int32_t outside = outcodes[0] | outcodes[1] | outcodes[2];
        if (!outside) {
            tell(outcodes, Verdict::inside, 1);
            return polygon;
        }
        const auto seen = [&](ClipPlane plane, const Polygon& before, const Polygon& after) {
            notify<ClipPlaneEvent>(observer_, [&] {
                return ClipPlaneEvent{triangle, plane, describe(before_corners_, plane, before),
                                      describe(after_corners_, plane, after)};
            });
        };
        polygon = clip_triangle<S>(polygon, outside, seen, state_.clip_planes);
        keep_flat_varyings<S>(polygon, corners[2]);
        if (polygon.count < 3) ++counts_.outside;
        tell(outcodes, Verdict::clipped, std::max(polygon.count - 2, 0));
        return polygon;
    }

    std::span<const ClipCorner> describe(std::array<ClipCorner, 3 + max_clip_planes>& room, ClipPlane plane,
                                         const Polygon& polygon) const {
        for (std::size_t i = 0; i < std::size_t(polygon.count); ++i)
            room[i] = {polygon.corners[i].clip, clip_distance(plane, polygon.corners[i].clip, state_.clip_planes),
                       polygon.corners[i].varyings};
        return {room.data(), std::size_t(polygon.count)};
    }

    void draw_piece(std::int64_t triangle, int piece, const std::array<Vertex, 3>& corners, PieceFate& fate) {
        const ViewportTransform viewport(viewport_);
        std::array<WindowVertex<float>, 3> window;
        std::array<SubpixelVertex<float>, 3> subpixel;
        for (std::size_t c = 0; c < 3; ++c) {
            window[c] = project(corners[c].clip, viewport);
            if constexpr (requires { variant_.change_window(window[c]); }) variant_.change_window(window[c]);
            subpixel[c] = snap(window[c]);
            if constexpr (requires { variant_.change_subpixel(subpixel[c]); }) variant_.change_subpixel(subpixel[c]);
        }
        notify<ProjectEvent>(observer_, [&] {
            return ProjectEvent{triangle, piece, {corners[0].clip, corners[1].clip, corners[2].clip}, window, subpixel};
        });

        const std::int64_t area = signed_area(subpixel);
        const bool front_facing = is_front_facing(state_.front_face, area);
        const CullEvent::Verdict verdict = area == 0                                ? CullEvent::Verdict::zero_area
                                           : is_culled(state_.cull, front_facing) ? CullEvent::Verdict::culled
                                                                                    : CullEvent::Verdict::kept;
        notify<CullEvent>(observer_, [&] { return CullEvent{triangle, piece, area, front_facing, verdict}; });
        fate.any_drawn |= verdict == CullEvent::Verdict::kept;
        fate.any_culled |= verdict == CullEvent::Verdict::culled;
        if (verdict != CullEvent::Verdict::kept) return;

        TriangleSetup setup = make_setup(window, subpixel, area, state_.fill_rule, target_.width(), target_.height(),
                                         state_.depth_offset, target_.depth_format());
        setup.box = intersection(setup.box, limits_);
        if constexpr (requires { variant_.change_setup(setup); }) variant_.change_setup(setup);
        const auto corner = [&](std::size_t i) { return std::size_t(setup.order[i]); };
        std::array<float, 3> oow = {window[corner(0)].oow, window[corner(1)].oow, window[corner(2)].oow};
        if constexpr (requires { variant_.change_perspective(oow); }) variant_.change_perspective(oow);
        const auto planes = make_varying_planes<S, float>(
            setup.basis, {&corners[corner(0)].varyings, &corners[corner(1)].varyings, &corners[corner(2)].varyings},
            oow);
        notify<SetupEvent>(observer_, [&] { return SetupEvent{triangle, piece, setup, planes.oow, planes.planes}; });

        const PixelBox box = pixels_to_run(observer_, setup.box);
        for (int y = box.min_y; y <= box.max_y; ++y)
            for (int x = box.min_x; x <= box.max_x; ++x)
                draw_pixel(triangle, piece, x, y, setup, planes, front_facing);
    }

    void draw_pixel(std::int64_t triangle, int piece, int x, int y, const TriangleSetup& setup,
                    const VaryingPlanes<S, float>& planes, bool front_facing) {
        std::array<std::int64_t, 3> edges;
        bool covered = setup.box.contains(x, y);  // an observer may look beyond
        for (std::size_t i = 0; i < 3; ++i) {
            edges[i] = edge_at(setup.edges[i], x, y);
            covered = covered && is_inside(setup.edges[i], edges[i]);
        }
        notify<CoverageEvent>(observer_, [&] { return CoverageEvent{triangle, piece, x, y, edges, covered}; });
        if (!covered) return;

        raster::draw_pixel<S>(target_, shader_, state_, {triangle, piece, x, y, front_facing}, setup.depth, planes,
                              observer_);
    }

    /// Lines and points: stages 8 to 11 are told of, with the primitive's number.
    void draw_stroke(const StrokeContext& context, std::size_t primitive, std::size_t indices) {
        const auto vertex = [&](std::size_t k) {
            const std::size_t v = mesh_.indices.empty() ? k : mesh_.indices[k];
            return v < shaded_.size() ? &shaded_[v] : nullptr;
        };
        const auto stroke = make_stroke<S>(context, primitive, indices, vertex, counts_);
        if (!stroke) return;
        const PixelBox box = pixels_to_run(observer_, stroke->box);
        for (int y = box.min_y; y <= box.max_y; ++y)
            for (int x = box.min_x; x <= box.max_x; ++x)
                if (covers(*stroke, x, y))
                    raster::draw_pixel<S>(target_, shader_, state_, {stroke->primitive, 0, x, y, true}, stroke->depth,
                                          stroke->varyings, observer_);
    }

    Target& target_;
    const S& shader_;
    const Mesh<typename S::template Vertex<float>>& mesh_;
    const State& state_;
    Viewport viewport_;
    PixelBox limits_;
    Observer& observer_;
    Variant& variant_;
    std::vector<Vertex> shaded_;
    std::array<ClipCorner, 3 + max_clip_planes> before_corners_, after_corners_;
    DrawCounts counts_;
};

}  // namespace detail

/// The same draw one pixel after the other, with an observer that is told of every stage (trace/events.h).
template <Shader S, class Observer>
DrawCounts draw(Target& target, const S& shader,
                const std::type_identity_t<Mesh<typename S::template Vertex<float>>>& mesh, const State& state,
                Observer&& observer) {
    return detail::ObservedDraw<S, std::remove_reference_t<Observer>>(target, shader, mesh, state, observer).run();
}

}  // namespace raster
