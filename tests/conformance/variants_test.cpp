// The suite can fail: pipelines with one rule changed give other pictures, and the comparison sees it.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include <raster/pipeline.h>

#include "catalogue.h"
#include "options.h"
#ifdef RASTER_HAVE_OSMESA
#include "osmesa.h"
#endif

namespace {

using namespace raster;
using namespace raster::conformance;

/// The rule that is changed.
enum class Change {
    nothing,
    snap_by_floor,
    snap_half_up,
    no_clipping,
    top_left_rule,
    affine_colors,
    colors_cut_off,
    depth_cut_off,
    blend_without_rounding,
    fans_from_the_first_corner,
};
constexpr const char* change_names[] = {"nothing",
                                        "snap by floor",
                                        "snap half up",
                                        "no clipping",
                                        "top-left rule",
                                        "affine colours",
                                        "colours cut off",
                                        "depth cut off",
                                        "blend without rounding",
                                        "fans from the first corner"};

struct Smooth {
    template <class F>
    struct Vertex {
        vec<4, F> position, color;
    };
    template <class F>
    struct Varyings {
        vec<4, F> color;
    };
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.color}};
    }
};
struct Affine : Smooth {
    static constexpr Interpolation interpolation(int) { return Interpolation::noperspective; }
};

/// Draws scenes of smooth triangles from the stage functions, one of them changed.
class ChangedPipeline {
public:
    ChangedPipeline(const Scene& scene, Change change)
        : change_(change), viewport_(Viewport{0, 0, scene.width, scene.height}), target_(scene.width, scene.height) {
        target_.clear(scene.clear_color, scene.clear_depth);
        for (const Draw& draw : scene.draws)
            for (std::size_t i = 0; i + 2 < draw.vertices.size(); i += 3) draw_triangle(draw, i);
    }
    Picture picture() const { return {target_.color8(), target_.depth()}; }

private:
    using Corner = ShadedVertex<float, 4>;

    void draw_triangle(const Draw& draw, std::size_t first) {
        ClipPolygon<4> polygon;
        std::int32_t any = 0, all = -1;
        for (std::size_t c = first; c < first + 3; ++c) {
            const Vertex& v = draw.vertices[c];
            polygon.add(shade_vertex<Smooth, float>(Smooth{}, {v.position, v.color}));
            any |= outcode(v.position), all &= outcode(v.position);
        }
        if (all) return;
        if (any && change_ != Change::no_clipping) polygon = clip_triangle<Smooth>(polygon, any, [](auto&&...) {});
        for (int piece = 0; piece + 2 < polygon.count; ++piece) {
            auto fan = polygon.clipped ? clip_fan(piece) : std::array{0, 1, 2};
            if (change_ == Change::fans_from_the_first_corner) fan = {0, piece + 1, piece + 2};
            const auto corner = [&](int i) { return polygon.corners[std::size_t(fan[std::size_t(i)])]; };
            if (change_ == Change::affine_colors)
                draw_piece<Affine>(draw.state, {corner(0), corner(1), corner(2)});
            else
                draw_piece<Smooth>(draw.state, {corner(0), corner(1), corner(2)});
        }
    }

    std::int32_t snap_changed(float window) const {
        const float scaled = (window - 0.5f) * 256.0f;
        if (change_ == Change::snap_by_floor) return std::int32_t(std::floor(scaled));
        if (change_ == Change::snap_half_up) return std::int32_t(std::floor(scaled + 0.5f));
        return snap(window);
    }

    template <class S>
    void draw_piece(const State& state, const std::array<Corner, 3>& corners) {
        std::array<WindowVertex<float>, 3> window;
        std::array<SubpixelVertex<float>, 3> subpixel;
        for (std::size_t c = 0; c < 3; ++c) {
            window[c] = project(corners[c].clip, viewport_);
            // Without clipping a corner may lie anywhere.
            if (!(std::abs(window[c].x) < 30000) || !(std::abs(window[c].y) < 30000)) return;
            subpixel[c] = {snap_changed(window[c].x), snap_changed(window[c].y)};
        }
        const std::int64_t area = signed_area(subpixel);
        if (area == 0) return;
        const FillRule rule = change_ == Change::top_left_rule ? FillRule::top_left : FillRule::bottom_left;
        const TriangleSetup setup = make_setup(window, subpixel, area, rule, target_.width(), target_.height());
        const auto& [a, b, c] = setup.order;
        const auto at = [](int i) { return std::size_t(i); };
        const auto planes = make_varying_planes<S, float>(
            setup.basis, {&corners[at(a)].varyings, &corners[at(b)].varyings, &corners[at(c)].varyings},
            {window[at(a)].oow, window[at(b)].oow, window[at(c)].oow});
        for (int y = setup.box.min_y; y <= setup.box.max_y; ++y)
            for (int x = setup.box.min_x; x <= setup.box.max_x; ++x) draw_pixel<S>(state, setup, planes, x, y);
    }

    template <class S>
    void draw_pixel(const State& state, const TriangleSetup& setup, const VaryingPlanes<S, float>& planes, int x,
                    int y) {
        for (const auto& edge : setup.edges)
            if (!is_inside(edge, edge_at(edge, x, y))) return;
        const float z = value_at(setup.depth, float(x), float(y));
        std::int32_t depth = encode_depth(DepthFormat::unorm24, z);
        if (change_ == Change::depth_cut_off) depth = truncate_to_int(raster::clamp(z, 0.0f, 1.0f) * 16777215.0f);
        std::uint32_t& stored_depth = target_.depth()[target_.index(x, y)];
        if (!depth_passes(state.depth_compare, depth, std::int32_t(stored_depth))) return;
        stored_depth = std::uint32_t(depth);

        const auto v = interpolate<S, float>(planes, float(x), float(y));
        const glm::vec4 color(v[0], v[1], v[2], v[3]);
        std::uint32_t& stored = target_.color8()[target_.index(x, y)];
        std::int32_t source = pack_rgba8(color);
        if (change_ == Change::colors_cut_off) source = cut_off(color);
        stored = change_ == Change::blend_without_rounding
                     ? blend_cut_off(state.blend, std::uint32_t(source), stored)
                     : std::uint32_t(blend_rgba8(state.blend, source, std::int32_t(stored)));
    }

    static std::int32_t cut_off(const glm::vec4& color) {
        std::uint32_t packed = 0;
        for (int i = 0; i < 4; ++i)
            packed |= std::uint32_t(truncate_to_int(raster::clamp(color[i], 0.0f, 1.0f) * 255.0f)) << (8 * i);
        return std::int32_t(packed);
    }

    static std::uint32_t blend_cut_off(Blend blend, std::uint32_t s, std::uint32_t d) {
        if (blend != Blend::source_over) return std::uint32_t(blend_rgba8(blend, std::int32_t(s), std::int32_t(d)));
        std::uint32_t result = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            const std::uint32_t a = s >> 24;
            result |= ((s >> shift & 255) * a / 255 + (d >> shift & 255) * (255 - a) / 255) << shift;
        }
        return result;
    }

    Change change_;
    ViewportTransform viewport_;
    Target target_;
};

/// What the pictures must be: OSMesa's where there is one, else the library's, which references_test.cpp compares with
/// it.
Picture expected(const Scene& scene) {
#ifdef RASTER_HAVE_OSMESA
    return Oracle::instance().render(scene);
#else
    return render(scene, Path::fast);
#endif
}

TEST(Changed, EachRuleIsSeenToMatter) {
    const auto& kinds = exact_kinds();
    constexpr int kind_count = 12, scenes = 3;  // the groups of smooth triangles come first
    int failures[std::size(change_names)] = {};
    for (int k = 0; k < kind_count; ++k)
        for (int i = 0; i < scenes; ++i) {
            Scene scene = kinds[std::size_t(k)].make(options.seed * 1000 + std::uint64_t(i));
            if (scene.width > 512) continue;
            const Picture right = expected(scene);
            for (std::size_t change = 0; change < std::size(change_names); ++change)
                failures[change] += !compare(ChangedPipeline(scene, Change(change)).picture(), right).none();
        }
    EXPECT_EQ(failures[0], 0) << "the pipeline of this test is not the library's";
    for (std::size_t change = 1; change < std::size(change_names); ++change) {
        std::printf("%-28s %2d pictures differ\n", change_names[change], failures[change]);
        EXPECT_GT(failures[change], 0) << change_names[change];
    }
}

}  // namespace
