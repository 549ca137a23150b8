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
// A pixel is a pure function of (triangle setup, x, y), folded over the triangles in submission order. So the observed
// draw below, which takes one pixel after the other, and the fast one in tiles/draw.h give the same bits.
#pragma once

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
#include <raster/stages/vertex.h>
#include <raster/state.h>
#include <raster/target.h>
#include <raster/tiles/draw.h>
#include <raster/trace/events.h>

namespace raster {

/// Draws a mesh: lanes, tiles, all threads. `target` must have the extra planes that the shader's outputs fill; missing
/// ones are not written.
template <Shader S>
DrawCounts draw(Target& target, const S& shader, const std::type_identity_t<Mesh<typename S::template Vertex<float>>>& mesh,
                const State& state = {}) {
    return tiles::draw(target, shader, mesh, state);
}

namespace detail {

/// One observed draw call: what its stages share.
template <Shader S, class Observer>
class ObservedDraw {
public:
    ObservedDraw(Target& target, const S& shader, const Mesh<typename S::template Vertex<float>>& mesh,
                 const State& state, Observer& observer)
        : target_(target),
          shader_(shader),
          mesh_(mesh),
          state_(state),
          viewport_(effective_viewport(state.viewport, target.width(), target.height())),
          observer_(observer) {}

    DrawCounts run() {
        if (!is_valid(viewport_)) return {};
        shade_vertices();
        const std::size_t indices = mesh_.indices.empty() ? mesh_.vertices.size() : mesh_.indices.size();
        const std::size_t triangles = triangle_count(state_.topology, indices);
        for (std::size_t i = 0; i < triangles; ++i) draw_triangle(std::int64_t(i));
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
            outcodes[c] = outcode(corners[c].clip);
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
        polygon = clip_triangle<S>(polygon, outside, [&](ClipPlane plane, const Polygon& before, const Polygon& after) {
            notify<ClipPlaneEvent>(observer_, [&] {
                return ClipPlaneEvent{triangle, plane, describe(before_corners_, plane, before),
                                      describe(after_corners_, plane, after)};
            });
        });
        keep_flat_varyings<S>(polygon, corners[2]);
        if (polygon.count < 3) ++counts_.outside;
        tell(outcodes, Verdict::clipped, std::max(polygon.count - 2, 0));
        return polygon;
    }

    static std::span<const ClipCorner> describe(std::array<ClipCorner, 3 + clip_plane_count>& room, ClipPlane plane,
                                                const Polygon& polygon) {
        for (std::size_t i = 0; i < std::size_t(polygon.count); ++i)
            room[i] = {polygon.corners[i].clip, clip_distance(plane, polygon.corners[i].clip),
                       polygon.corners[i].varyings};
        return {room.data(), std::size_t(polygon.count)};
    }

    void draw_piece(std::int64_t triangle, int piece, const std::array<Vertex, 3>& corners, PieceFate& fate) {
        const ViewportTransform viewport(viewport_);
        std::array<WindowVertex<float>, 3> window;
        std::array<SubpixelVertex<float>, 3> subpixel;
        for (std::size_t c = 0; c < 3; ++c) {
            window[c] = project(corners[c].clip, viewport);
            subpixel[c] = snap(window[c]);
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

        const TriangleSetup setup =
            make_setup(window, subpixel, area, state_.fill_rule, target_.width(), target_.height());
        const auto corner = [&](std::size_t i) { return std::size_t(setup.order[i]); };
        const auto planes = make_varying_planes<S, float>(
            setup.basis, {&corners[corner(0)].varyings, &corners[corner(1)].varyings, &corners[corner(2)].varyings},
            {window[corner(0)].oow, window[corner(1)].oow, window[corner(2)].oow});
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

        const float px = float(x), py = float(y);
        const float z = value_at(setup.depth, px, py);
        std::uint32_t& stored = target_.depth()[target_.index(x, y)];
        const std::int32_t incoming = encode_depth(target_.depth_format(), z);
        const bool passed = depth_passes(state_.depth_compare, incoming, std::int32_t(stored));
        notify<DepthEvent>(observer_, [&] {
            return DepthEvent{triangle, piece, x, y, z, std::uint32_t(incoming), stored, passed};
        });
        if (!passed) return;
        if (state_.depth_write) stored = std::uint32_t(incoming);

        if constexpr (HasFragment<S>) {
            if (!state_.color_write) return;
            const auto varyings = interpolate<S, float>(planes, px, py);
            const float oow = value_at(planes.oow, px, py);
            notify<InterpolateEvent>(observer_, [&] { return InterpolateEvent{triangle, piece, x, y, oow, varyings}; });

            const FragmentInput<float> at{
                {px + 0.5f, py + 0.5f}, z, oow, front_facing, std::int32_t(triangle)};
            const auto outputs = shade_fragment<S, float>(shader_, varyings, at);
            notify<FragmentEvent>(observer_, [&] { return FragmentEvent{triangle, piece, x, y, outputs}; });

            const glm::vec4 source(outputs[0], outputs[1], outputs[2], outputs[3]);
            const std::size_t place = target_.index(x, y);
            const glm::vec4 before = target_.color(x, y);
            if (target_.color_format() == ColorFormat::rgba8) {
                std::uint32_t& color = target_.color8()[place];
                color = blend_rgba8(state_.blend, std::uint32_t(pack_rgba8(source)), color);
            } else {
                glm::vec4& color = target_.color_float()[place];
                color = blend_float(state_.blend, source, color);
            }
            for (int e = 0; e < std::min(output_count<S> - 4, target_.extra_channels()); ++e)
                target_.extra(e)[place] = outputs[std::size_t(4 + e)];
            notify<BlendEvent>(observer_, [&] {
                return BlendEvent{triangle, piece, x, y, source, before, target_.color(x, y)};
            });
        }
    }

    Target& target_;
    const S& shader_;
    const Mesh<typename S::template Vertex<float>>& mesh_;
    const State& state_;
    Viewport viewport_;
    Observer& observer_;
    std::vector<Vertex> shaded_;
    std::array<ClipCorner, 3 + clip_plane_count> before_corners_, after_corners_;
    DrawCounts counts_;
};

}  // namespace detail

/// The same draw one pixel after the other, with an observer that is told of every stage (trace/events.h).
template <Shader S, class Observer>
DrawCounts draw(Target& target, const S& shader, const std::type_identity_t<Mesh<typename S::template Vertex<float>>>& mesh,
                const State& state, Observer&& observer) {
    return detail::ObservedDraw<S, std::remove_reference_t<Observer>>(target, shader, mesh, state, observer).run();
}

}  // namespace raster
