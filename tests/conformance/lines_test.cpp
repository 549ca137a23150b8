// Lines and points of the stage functions against OpenGL's: not a bit of colour or depth may differ.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <GL/gl.h>

#include <raster/pipeline.h>
#include <raster/stages/line.h>
#include <raster/stages/point.h>

#include "options.h"
#include "osmesa.h"
#include "scenes.h"

namespace {

using namespace raster;
using namespace raster::conformance;
using raster::testing::Group;
using raster::testing::Random;

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
using Corner = ShadedVertex<float, 4>;

/// Lines of one width, or points of one size.
struct LineScene {
    int width = 256, height = 256;
    bool points = false, flat = false;
    int line_width = 1;
    float point_size = 1;
    State state;
    std::vector<Smooth::Vertex<float>> vertices;
};

LineScene make_scene(std::uint64_t seed, bool points) {
    Random random(seed);
    LineScene s;
    if (random.integer(0, 3) == 0) s.width = random.integer(1, 500), s.height = random.integer(1, 300);
    s.points = points;
    s.flat = random.integer(0, 3) == 0;
    s.line_width = random.integer(1, 5);
    s.point_size = random.integer(0, 1) ? float(random.integer(1, 7)) : random.uniform(0.5f, 7.4f);
    s.state.blend = Blend(random.integer(0, 2));
    const auto group = Group(random.integer(0, int(Group::collinear)));
    for (int i = 0; i < 10; ++i)
        for (const glm::vec4& position : make_triangle(group, random, s.width, s.height)) {
            glm::vec4 color;
            for (int c = 0; c < 4; ++c) color[c] = random.uniform(-0.2f, 1.2f);
            s.vertices.push_back({position, color});
        }
    return s;
}

/// Draws the scene with the stages of lines and points, one pixel after the other.
class LineDrawer {
public:
    explicit LineDrawer(const LineScene& scene)
        : scene_(scene), viewport_(Viewport{0, 0, scene.width, scene.height}), target_(scene.width, scene.height) {
        target_.clear(glm::vec4(0.1f, 0.2f, 0.3f, 1));
        std::vector<Corner> corners;
        for (const auto& v : scene.vertices) corners.push_back(shade_vertex<Smooth, float>(Smooth{}, v));
        if (scene.points) {
            for (const Corner& corner : corners) draw_point(corner);
        } else {
            for (std::size_t i = 0; i + 1 < corners.size(); i += 2) draw_line(corners[i], corners[i + 1]);
        }
    }
    Picture picture() const { return {target_.color8(), target_.depth()}; }

private:
    void draw_line(Corner a, Corner b) {
        if (!is_finite(a.clip) || !is_finite(b.clip) || (outcode(a.clip) & outcode(b.clip))) return;
        const auto provoking = b.varyings;
        if (const std::int32_t outside = outcode(a.clip) | outcode(b.clip)) {
            const auto inside = clip_line<Smooth>(a, b, outside);
            if (!inside) return;
            a = (*inside)[0], b = (*inside)[1];
        }
        const auto wa = project(a.clip, viewport_), wb = project(b.clip, viewport_);
        const auto setup =
            make_line_setup(wa, wb, scene_.line_width, FillRule::bottom_left, scene_.width, scene_.height);
        if (!setup) return;
        const Plane<float> oow = make_line_plane(setup->basis, wa.oow, wb.oow);
        for (int y = setup->box.min_y; y <= setup->box.max_y; ++y)
            for (int x = setup->box.min_x; x <= setup->box.max_x; ++x) {
                bool covered = true;
                for (const auto& edge : setup->edges) covered = covered && is_inside(edge, edge_at(edge, x, y));
                if (!covered) continue;
                const auto px = float(x), py = float(y);
                const float w = 1.0f / value_at(oow, px, py);
                glm::vec4 color;
                for (std::size_t i = 0; i < 4; ++i) {
                    const auto plane = make_line_plane(setup->basis, a.varyings[i] * wa.oow, b.varyings[i] * wb.oow);
                    color[int(i)] = scene_.flat ? provoking[i] : value_at(plane, px, py) * w;
                }
                draw_pixel(x, y, value_at(setup->depth, px, py), color);
            }
    }

    void draw_point(const Corner& v) {
        if (!is_point_visible(v.clip)) return;
        const auto window = project(v.clip, viewport_);
        const PixelBox box =
            point_pixels(window, scene_.point_size, FillRule::bottom_left, scene_.width, scene_.height);
        glm::vec4 color;
        for (std::size_t i = 0; i < 4; ++i)
            color[int(i)] = scene_.flat ? v.varyings[i] : (v.varyings[i] * window.oow) * (1.0f / window.oow);
        for (int y = box.min_y; y <= box.max_y; ++y)
            for (int x = box.min_x; x <= box.max_x; ++x) draw_pixel(x, y, window.z, color);
    }

    void draw_pixel(int x, int y, float z, const glm::vec4& color) {
        std::uint32_t& depth = target_.depth()[target_.index(x, y)];
        const std::int32_t incoming = encode_depth(DepthFormat::unorm24, z);
        if (!depth_passes(scene_.state.depth_compare, incoming, std::int32_t(depth))) return;
        depth = std::uint32_t(incoming);
        std::uint32_t& stored = target_.color8()[target_.index(x, y)];
        stored = blend_rgba8(scene_.state.blend, std::uint32_t(pack_rgba8(color)), stored);
    }

    const LineScene& scene_;
    ViewportTransform viewport_;
    Target target_;
};

Picture draw_with_opengl(const LineScene& scene) {
    Oracle& oracle = Oracle::instance();
    return oracle.render(scene.width, scene.height, {0.1f, 0.2f, 0.3f, 1}, 1, [&] {
        Oracle::apply(scene.state, scene.width, scene.height);
        const std::string how = scene.flat ? "flat" : "smooth";
        glUseProgram(oracle.program(
            "#version 130\nin vec4 position, color; " + how +
                " out vec4 tint;\nvoid main() { gl_Position = position; tint = color; }\n",
            "#version 130\n" + how + " in vec4 tint; out vec4 result;\nvoid main() { result = tint; }\n"));
        constexpr GLsizei stride = sizeof(scene.vertices[0]);
        glEnableVertexAttribArray(0);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(0, 4, GL_FLOAT, false, stride, &scene.vertices[0].position);
        glVertexAttribPointer(1, 4, GL_FLOAT, false, stride, &scene.vertices[0].color);
        glLineWidth(float(scene.line_width));
        glPointSize(scene.point_size);
        glDrawArrays(scene.points ? GL_POINTS : GL_LINES, 0, GLsizei(scene.vertices.size()));
        glDisableVertexAttribArray(0);
        glDisableVertexAttribArray(1);
    });
}

void compare_scenes(bool points) {
    std::size_t drawn = 0;
    for (int i = 0; i < 40 * options.scenes; ++i) {
        const std::uint64_t seed = options.seed * 100000 + std::uint64_t(i);
        const LineScene scene = make_scene(seed, points);
        const Picture theirs = draw_with_opengl(scene);
        const Difference difference = compare(LineDrawer(scene).picture(), theirs);
        ASSERT_TRUE(difference.none()) << "seed " << seed << ", width " << scene.line_width << ", size "
                                       << scene.point_size << ": " << describe(difference, scene.width);
        for (const std::uint32_t depth : theirs.depth) drawn += depth != 0xffffff;
    }
    EXPECT_GT(drawn, 10000u);
}

TEST(Lines, OfWidthsOneToFiveAreEqual) { compare_scenes(false); }
TEST(Points, OfSizesOneToSevenAreEqual) { compare_scenes(true); }

}  // namespace
