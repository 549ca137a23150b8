// stage_scenes.cpp: every stage of the pipeline and every value of its state.
#include <raster/math.h>
#include <raster/shading/texture.h>

#include "pipeline_testing.h"
#include "scenes.h"

namespace raster::everywhere {

namespace {

using testing::Group;
using testing::Random;
using testing::Vertices;

constexpr int width = 150, height = 130;  // not whole tiles

Vertices triangles(Random& random, Group group, int count) {
    Vertices vertices;
    for (int i = 0; i < count; ++i)
        testing::add_triangle(vertices, testing::make_triangle(group, random, width, height), random);
    return vertices;
}

/// A scene of several draws of a shader, each with vertices and a state of its own.
template <class S, class Make>
Scene scene(const std::string& name, const Make& make, ColorFormat color = ColorFormat::rgba8,
            DepthFormat depth = DepthFormat::unorm24, int extra_channels = 0) {
    return {name, [=](Hash& hash) {
                Random random(7);
                Target target(width, height, color, depth, extra_channels);
                target.clear({0.1f, 0.2f, 0.3f, 1});
                for (int i = 0; i < 4; ++i) {
                    State state;
                    const Vertices vertices = make(random, state, i);
                    hash.add(draw(target, S{}, Mesh{vertices}, state));
                }
                hash.add(target);
            }};
}

/// Triangles of all kinds in the state that `set` makes.
template <class Set>
Scene state_scene(const std::string& name, const Set& set) {
    return scene<testing::Smooth>(name, [=](Random& random, State& state, int i) {
        set(state, i, random);
        if (i == 3) random = Random(7);  // those of the first draw again: depths are equal
        return triangles(random, i == 1 ? Group::clip_all : Group::perspective, 12);
    });
}

Scene group_scene(Group group) {
    return scene<testing::Full>(
        "group_" + testing::name(group),
        [=](Random& random, State& state, int) {
            state.blend = Blend(random.integer(0, 2));
            return triangles(random, group, 16);
        },
        ColorFormat::rgba8, DepthFormat::unorm24, 7);
}

/// One pixel after the other, with an observer.
Scene observed_scene() {
    return {"observed", [](Hash& hash) {
                Random random(3);
                Target target(width, height, ColorFormat::rgba_float, DepthFormat::float32, 7);
                struct Count {
                    std::uint32_t covered = 0;
                    void on(const CoverageEvent& e) { covered += e.covered; }
                } count;
                for (int i = 0; i < 6; ++i) {
                    const Vertices vertices = testing::mixed_scene(random, 12, width, height, true);
                    hash.add(draw(target, testing::Full{}, Mesh{vertices}, testing::random_state(random), count));
                }
                hash.add(count.covered);
                hash.add(target);
            }};
}

/// A texture, magnified and minified, on triangles in perspective.
struct Textured {
    template <class F>
    using Vertex = testing::Full::Vertex<F>;
    template <class F>
    struct Varyings {
        vec<2, F> uv;
    };
    TextureView texture;
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.id}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return sample<F>(texture, in.uv);
    }
};

Scene texture_scene(const std::string& name, Wrap wrap, Filter filter, bool srgb) {
    return {name, [=](Hash& hash) {
                Random random(11);
                PackedTexture image{13, 8, {}};
                for (int i = 0; i < image.width * image.height; ++i)
                    image.texels.push_back(std::int32_t(std::uint32_t(random.bits())));
                const Textured shader{TextureView(image, wrap, filter, srgb ? srgb_decode_table() : nullptr)};
                Target target(width, height);
                const Vertices vertices = triangles(random, Group::perspective, 30);
                hash.add(draw(target, shader, Mesh{vertices}, State{}));
                hash.add(target);
            }};
}

/// The functions that stand in for libm, over all sizes of numbers.
Scene math_scene() {
    return {"math", [](Hash& hash) {
                Random random(5);
                for (int i = 0; i < 20000; ++i) {
                    const float y = random.uniform(-20, 20), x = raster::exp2(random.uniform(-60, 60));
                    hash.add(x);
                    hash.add(raster::log2(x));
                    hash.add(raster::pow(x, y));
                    hash.add(raster::pow_shared(x, 37.0f));
                    hash.add(raster::sin(y));
                    hash.add(raster::cos(y));
                    hash.add(raster::acos(y / 20));
                    hash.add(std::sqrt(x));
                    const SinCos turn = sin_cos_degrees(double(y) * 50);
                    hash.add(float(turn.sin));
                    hash.add(float(turn.cos));
                }
            }};
}

}  // namespace

std::vector<Scene> stage_scenes() {
    std::vector<Scene> all = {math_scene(), observed_scene()};
    for (int group = 0; group < testing::group_count; ++group) all.push_back(group_scene(Group(group)));

    const char* const compares[] = {"never",   "less",      "equal",         "less_equal",
                                    "greater", "not_equal", "greater_equal", "always"};
    for (int c = 0; c < 8; ++c)
        all.push_back(state_scene(std::string("depth_") + compares[c], [=](State& state, int i, Random&) {
            state.depth_compare = i == 0 ? Compare::always : Compare(c);
            state.depth_write = i != 2;
            if (i == 3) state.blend = Blend::additive;
        }));
    const char* const blends[] = {"off", "source_over", "additive"};
    for (int b = 0; b < 3; ++b)
        all.push_back(state_scene(std::string("blend_") + blends[b], [=](State& state, int, Random&) {
            state.blend = Blend(b);
        }));
    const char* const culls[] = {"none", "back", "front", "both"};
    for (int c = 1; c < 4; ++c)
        all.push_back(state_scene(std::string("cull_") + culls[c], [=](State& state, int i, Random&) {
            state.cull = Cull(c);
            state.front_face = FrontFace(i / 3);
        }));
    for (const FillRule rule : {FillRule::bottom_left, FillRule::top_left})
        all.push_back(scene<testing::Smooth>(
            rule == FillRule::top_left ? "fill_top_left" : "fill_bottom_left", [=](Random& random, State& state, int) {
                state.fill_rule = rule;
                state.blend = Blend::additive;
                state.depth_compare = Compare::always;
                return triangles(random, Group::axis_aligned, 12);
            }));
    all.push_back(state_scene("strips", [](State& state, int, Random&) { state.topology = Topology::triangle_strip; }));
    all.push_back(state_scene("fans", [](State& state, int, Random&) { state.topology = Topology::triangle_fan; }));
    all.push_back(state_scene("viewports", [](State& state, int, Random& random) {
        state.viewport = {random.integer(-40, 90), random.integer(-40, 90), random.integer(1, 200),
                          random.integer(1, 200),  random.uniform(0, 1),    random.uniform(0, 1)};
    }));
    all.push_back(state_scene("color_write_off", [](State& state, int i, Random&) { state.color_write = i % 2; }));
    const char* const topologies[] = {"points", "lines", "line_strip", "line_loop"};
    for (int t = 0; t < 4; ++t)
        all.push_back(state_scene(topologies[t], [=](State& state, int i, Random& random) {
            state.topology = Topology(int(Topology::points) + t);
            state.line_width = i + 1;
            state.point_size = random.uniform(1, 7);
            state.blend = Blend::source_over;
        }));
    all.push_back(state_scene("scissor", [](State& state, int i, Random&) {
        state.scissor = Scissor{20 * i, 50 - 20 * i, 70, 66};
        state.blend = Blend(i % 3);
    }));
    all.push_back(state_scene("depth_offset", [](State& state, int i, Random&) {
        state.depth_offset = {0.5f * float(i - 1), 100.0f * float(i)};
    }));
    all.push_back(state_scene("clip_planes", [](State& state, int, Random&) {
        static constexpr glm::vec4 planes[] = {{1, 0.5f, 0, 0.2f}, {-0.3f, 1, 0.1f, 0.7f}};
        state.clip_planes = planes;
    }));
    const auto mixed = [](Random& random, State& state, int) {
        state = testing::random_state(random);
        return testing::mixed_scene(random, 20, width, height, true);
    };
    all.push_back(scene<testing::Full>("mixed", mixed));
    all.push_back(scene<testing::Full>("float_planes", mixed, ColorFormat::rgba_float, DepthFormat::float32, 7));
    all.push_back(scene<testing::DepthOnly>("depth_only", mixed));

    const char* const wraps[] = {"repeat", "clamp", "mirror"};
    for (int w = 0; w < 3; ++w) {
        all.push_back(texture_scene(std::string("nearest_") + wraps[w], Wrap(w), Filter::nearest, false));
        all.push_back(texture_scene(std::string("bilinear_") + wraps[w], Wrap(w), Filter::bilinear, false));
    }
    all.push_back(texture_scene("srgb_bilinear", Wrap::repeat, Filter::bilinear, true));
    return all;
}

}  // namespace raster::everywhere
