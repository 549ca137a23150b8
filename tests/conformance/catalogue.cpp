// catalogue.cpp: how the scenes of each kind are made.
#include "catalogue.h"

#include <raster/math.h>
#include <raster/pipeline.h>

#include "scenes.h"

namespace raster::conformance {

namespace {

using raster::testing::Group;
using raster::testing::Random;

glm::vec4 random_color(Random& random, float low, float high) {
    glm::vec4 color;
    for (int i = 0; i < 4; ++i) color[i] = random.uniform(low, high);
    return color;
}

/// Most scenes are small; some have the sizes that people use.
Scene empty_scene(Random& random) {
    constexpr int sizes[][2] = {{256, 256}, {256, 256}, {256, 256}, {256, 256},  {256, 256},
                                {256, 256}, {512, 512}, {640, 480}, {1280, 720}, {1920, 1080}};
    const auto& size = sizes[random.integer(0, 9)];
    Scene scene;
    scene.width = size[0], scene.height = size[1];
    scene.clear_color = {0.1f, 0.2f, 0.3f, 1};
    return scene;
}

/// Triangles of one group for a viewport of this size. Colours go beyond 0 to 1 where OpenGL keeps such.
Draw make_draw(Group group, Random& random, int count, int width, int height, Style style = Style::smooth) {
    Draw draw;
    draw.style = style;
    const float beyond = style == Style::fixed_function ? 0.0f : 0.2f;
    for (int i = 0; i < count; ++i)
        for (const glm::vec4& position : make_triangle(group, random, width, height)) {
            const glm::vec4 color = random_color(random, -beyond, 1 + beyond);
            const float u = random.uniform(-3, 3);
            draw.vertices.push_back({position, color, {u, random.uniform(-3, 3)}});
        }
    return draw;
}

Blend random_blend(Random& random) { return Blend(random.integer(0, 2)); }

/// Twelve of the groups in turn; noperspective draws leave out those in which Mesa divides 0 by 0
/// (docs/conformance.md).
Group random_group(Random& random, bool unclipped = false) {
    return Group(random.integer(0, unclipped ? int(Group::axis_aligned) : int(Group::collinear)));
}

template <Group group>
Scene group_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(make_draw(group, random, 16, scene.width, scene.height));
        scene.draws.back().state.blend = random_blend(random);
    }
    return scene;
}

template <Style style>
Scene style_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        const Group group = random_group(random, style == Style::noperspective);
        scene.draws.push_back(make_draw(group, random, 8, scene.width, scene.height, style));
    }
    return scene;
}

Texture random_texture(Random& random, Filter filter) {
    Texture texture;
    const bool power_of_two = random.integer(0, 1);
    const auto size = [&] { return power_of_two ? 1 << random.integer(0, 6) : random.integer(1, 70); };
    texture.image.width = size();
    texture.image.height = size();
    for (int i = 0; i < texture.image.width * texture.image.height; ++i)
        texture.image.texels.push_back(std::int32_t(std::uint32_t(random.bits())));
    texture.wrap = Wrap(random.integer(0, 2));
    texture.filter = filter;
    return texture;
}

template <Filter filter>
Scene textured_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(make_draw(random_group(random), random, 6, scene.width, scene.height, Style::textured));
        scene.draws.back().texture = random_texture(random, filter);
        scene.draws.back().state.blend = filter == Filter::nearest ? random_blend(random) : Blend::off;
    }
    return scene;
}

template <Blend blend>
Scene blend_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.draws = {make_draw(random_group(random), random, 60, scene.width, scene.height)};
    scene.draws[0].state.blend = blend;
    scene.draws[0].state.depth_compare = Compare::always;
    return scene;
}

/// Closed fans of one flat colour, added up: where a pixel got more than one layer of a fan, the colour tells.
Scene fan_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        Draw draw;
        draw.state.topology = Topology::triangle_fan;
        draw.state.blend = Blend::additive;
        draw.state.depth_compare = Compare::always;
        const float x = random.uniform(0, float(scene.width)), y = random.uniform(0, float(scene.height));
        const float radius = random.uniform(1, float(scene.height));
        const int sides = random.integer(3, 40);
        const auto add = [&](float dx, float dy) {
            const float w = random.uniform(0.5f, 4);
            const glm::vec4 position = raster::testing::clip_at(x + dx, y + dy, 0, w, scene.width, scene.height);
            draw.vertices.push_back({position, glm::vec4(float(1 << i) * 16 / 255.0f), {0, 0}});
        };
        add(0, 0);
        for (int side = 0; side < sides; ++side) {
            const float angle = float(side) * 6.2831853f / float(sides);
            add(radius * raster::cos(angle), radius * raster::sin(angle));
        }
        draw.vertices.push_back(draw.vertices[1]);
        scene.draws.push_back(draw);
    }
    return scene;
}

Scene topology_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        const Style style = random.integer(0, 1) ? Style::smooth : Style::flat;
        Draw draw = make_draw(random_group(random), random, 5, scene.width, scene.height, style);
        draw.state.topology = Topology(random.integer(0, 2));
        if (random.integer(0, 1))
            for (int index = 0; index < 12; ++index)
                draw.indices.push_back(std::uint32_t(random.integer(0, int(draw.vertices.size()) - 1)));
        scene.draws.push_back(draw);
    }
    return scene;
}

template <Compare compare>
Scene compare_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.clear_depth = random.uniform(0.3f, 1);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(make_draw(random_group(random), random, 16, scene.width, scene.height));
        State& state = scene.draws.back().state;
        state.depth_compare = i == 0 ? Compare::less : compare;
        state.depth_write = random.integer(0, 2) != 0;
        state.color_write = random.integer(0, 4) != 0;
    }
    // The same triangles again, so that depths are equal everywhere.
    scene.draws.push_back(scene.draws[0]);
    scene.draws.back().state.depth_compare = compare;
    return scene;
}

/// Sees whether a triangle's side could be told otherwise: by the sign of its area before it is snapped.
struct FacingDoubt {
    bool doubt = false;
    void on(const ProjectEvent& e) {
        const auto& w = e.window;
        const float area = (w[0].x - w[2].x) * (w[1].y - w[2].y) - (w[0].y - w[2].y) * (w[1].x - w[2].x);
        const std::int64_t snapped = signed_area(e.subpixel);
        doubt |= snapped != 0 && (snapped > 0 ? !(area < 0) : !(area > 0));
    }
};
struct PositionOnly {
    template <class F>
    struct Vertex {
        vec<4, F> position;
    };
    template <class F>
    struct Varyings {};
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {}};
    }
};

/// Mesa culls by the unsnapped area where anything of a draw is clipped, and by the snapped one otherwise. The library
/// always takes the snapped one; so triangles for which that makes a difference are left out.
void drop_doubtful_facing(Draw& draw, int width, int height) {
    std::vector<Vertex> kept;
    Target target(1, 1);
    State state;
    state.viewport = effective_viewport(draw.state.viewport, width, height);
    state.cull = Cull::both;
    for (std::size_t i = 0; i + 2 < draw.vertices.size(); i += 3) {
        std::array<PositionOnly::Vertex<float>, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) corners[c].position = draw.vertices[i + c].position;
        FacingDoubt observer;
        raster::draw(target, PositionOnly{}, Mesh(corners), state, observer);
        if (!observer.doubt) kept.insert(kept.end(), &draw.vertices[i], &draw.vertices[i] + 3);
    }
    draw.vertices = kept;
}

template <Cull cull, FrontFace front>
Scene cull_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 3; ++i) {
        Draw draw = make_draw(random_group(random), random, 16, scene.width, scene.height);
        draw.state.cull = cull;
        draw.state.front_face = front;
        drop_doubtful_facing(draw, scene.width, scene.height);
        scene.draws.push_back(draw);
    }
    return scene;
}

/// Viewports smaller than the target, across its border and larger than it, with depth ranges of all kinds.
Scene viewport_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        Viewport v;
        v.x = random.integer(-scene.width / 4, scene.width), v.y = random.integer(-scene.height / 4, scene.height);
        v.width = random.integer(1, scene.width), v.height = random.integer(1, scene.height);
        if (random.integer(0, 1)) v.near_depth = random.uniform(0, 1), v.far_depth = random.uniform(0, 1);
        Draw draw = make_draw(random_group(random), random, 12, v.width, v.height);
        draw.state.viewport = v;
        draw.state.blend = random_blend(random);
        scene.draws.push_back(draw);
    }
    return scene;
}

Scene odd_size_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.width = random.integer(1, 700), scene.height = random.integer(1, 300);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(make_draw(random_group(random), random, 12, scene.width, scene.height));
        scene.draws.back().state.blend = random_blend(random);
    }
    return scene;
}

Scene clear_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.width = random.integer(1, 9), scene.height = random.integer(1, 9);
    scene.clear_color = random_color(random, -0.1f, 1.1f);
    scene.clear_depth = random.uniform(0, 1);
    return scene;
}

/// Lines or points of one kind, with their widths and sizes, in small targets now and then.
template <Topology first, Topology last>
Scene stroke_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    if (random.integer(0, 3) == 0) scene.width = random.integer(1, 500), scene.height = random.integer(1, 300);
    for (int i = 0; i < 3; ++i) {
        const Style style = random.integer(0, 3) ? Style::smooth : Style::flat;
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, style);
        draw.state.topology = Topology(random.integer(int(first), int(last)));
        draw.state.line_width = random.integer(1, 5);
        draw.state.point_size = random.integer(0, 1) ? float(random.integer(1, 7)) : random.uniform(0.5f, 7.4f);
        draw.state.blend = random_blend(random);
        Viewport& v = draw.state.viewport;
        if (random.integer(0, 3) == 0) {
            v.x = random.integer(0, scene.width / 2), v.y = random.integer(0, scene.height / 2);
            v.width = random.integer(1, scene.width), v.height = random.integer(1, scene.height);
        }
        scene.draws.push_back(draw);
    }
    return scene;
}

/// Rectangles inside, across and beyond the target, with everything that can be drawn.
Scene scissor_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 5; ++i) {
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height);
        Scissor s;
        s.x = random.integer(-20, scene.width), s.y = random.integer(-20, scene.height);
        s.width = random.integer(0, scene.width), s.height = random.integer(0, scene.height);
        draw.state.scissor = s;
        draw.state.blend = random_blend(random);
        if (i == 4) draw.state.topology = Topology(random.integer(int(Topology::points), int(Topology::line_loop)));
        draw.state.line_width = random.integer(1, 5);
        scene.draws.push_back(draw);
    }
    return scene;
}

/// Triangles on one another with their depths moved by slope and by steps.
Scene depth_offset_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        Draw draw = make_draw(random_group(random), random, 12, scene.width, scene.height);
        if (random.integer(0, 3)) draw.state.depth_offset.factor = random.uniform(-4, 4);
        if (random.integer(0, 3)) draw.state.depth_offset.units = random.uniform(-2000, 2000);
        draw.state.blend = random_blend(random);
        scene.draws.push_back(draw);
        draw.state.depth_offset.units = float(random.integer(-2, 2));
        draw.state.depth_compare = Compare(random.integer(1, 6));
        scene.draws.push_back(draw);
    }
    return scene;
}

/// One to eight planes of the user's through triangles, lines and points.
Scene clip_plane_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        const Style style = random.integer(0, 3) ? Style::smooth : Style::flat;
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, style);
        draw.clip_planes.resize(std::size_t(random.integer(1, random.integer(0, 1) ? 2 : 8)));
        for (glm::vec4& plane : draw.clip_planes)
            for (int c = 0; c < 4; ++c) plane[c] = random.uniform(c == 3 ? -0.1f : -1.0f, 1.0f);
        if (i == 3) draw.state.topology = Topology(random.integer(int(Topology::points), int(Topology::line_loop)));
        draw.state.line_width = random.integer(1, 5);
        draw.state.blend = random_blend(random);
        scene.draws.push_back(draw);
    }
    return scene;
}

/// All of the state at once.
Scene mixed_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.clear_color = random_color(random, 0, 1);
    for (int i = 0; i < 6; ++i) {
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, Style(random.integer(0, 1)));
        draw.state.depth_compare = Compare(random.integer(0, 7));
        draw.state.depth_write = random.integer(0, 1);
        draw.state.blend = random_blend(random);
        draw.state.front_face = FrontFace(random.integer(0, 1));
        draw.state.cull = Cull(random.integer(0, 2));
        if (draw.state.cull != Cull::none) drop_doubtful_facing(draw, scene.width, scene.height);
        scene.draws.push_back(draw);
    }
    return scene;
}

}  // namespace

const std::vector<Kind>& exact_kinds() {
    static const std::vector<Kind> kinds = {
        {"big", group_scene<Group::big>},
        {"perspective", group_scene<Group::perspective>},
        {"small", group_scene<Group::small>},
        {"slivers", group_scene<Group::slivers>},
        {"half_pixel_grid", group_scene<Group::half_pixel_grid>},
        {"ties", group_scene<Group::ties>},
        {"axis_aligned", group_scene<Group::axis_aligned>},
        {"clip_near", group_scene<Group::clip_near>},
        {"clip_far", group_scene<Group::clip_far>},
        {"clip_sides", group_scene<Group::clip_sides>},
        {"clip_all", group_scene<Group::clip_all>},
        {"clip_slivers", group_scene<Group::clip_slivers>},
        {"collinear", group_scene<Group::collinear>},
        {"huge", group_scene<Group::huge>},
        {"flat", style_scene<Style::flat>},
        {"noperspective", style_scene<Style::noperspective>},
        {"fixed_function", style_scene<Style::fixed_function>},
        {"textured_nearest", textured_scene<Filter::nearest>},
        {"source_over", blend_scene<Blend::source_over>},
        {"additive", blend_scene<Blend::additive>},
        {"fans", fan_scene},
        {"strips_and_fans", topology_scene},
        {"never", compare_scene<Compare::never>},
        {"less", compare_scene<Compare::less>},
        {"equal", compare_scene<Compare::equal>},
        {"less_equal", compare_scene<Compare::less_equal>},
        {"greater", compare_scene<Compare::greater>},
        {"not_equal", compare_scene<Compare::not_equal>},
        {"greater_equal", compare_scene<Compare::greater_equal>},
        {"always", compare_scene<Compare::always>},
        {"cull_back", cull_scene<Cull::back, FrontFace::counter_clockwise>},
        {"cull_back_clockwise", cull_scene<Cull::back, FrontFace::clockwise>},
        {"cull_front", cull_scene<Cull::front, FrontFace::counter_clockwise>},
        {"cull_front_clockwise", cull_scene<Cull::front, FrontFace::clockwise>},
        {"cull_both", cull_scene<Cull::both, FrontFace::counter_clockwise>},
        {"viewports", viewport_scene},
        {"odd_sizes", odd_size_scene},
        {"clear", clear_scene},
        {"mixed", mixed_scene},
        {"lines", stroke_scene<Topology::lines, Topology::lines>},
        {"line_strips_and_loops", stroke_scene<Topology::line_strip, Topology::line_loop>},
        {"points", stroke_scene<Topology::points, Topology::points>},
        {"scissor", scissor_scene},
        {"depth_offset", depth_offset_scene},
        {"clip_planes", clip_plane_scene},
    };
    return kinds;
}

const std::vector<Kind>& close_kinds() {
    static const std::vector<Kind> kinds = {{"textured_bilinear", textured_scene<Filter::bilinear>}};
    return kinds;
}

}  // namespace raster::conformance
