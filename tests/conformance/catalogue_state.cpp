// catalogue_state.cpp: scenes about the state of draws.
#include <raster/pipeline.h>

#include "catalogue_parts.h"

namespace raster::conformance {

namespace {

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
        const Coloring coloring = random.integer(0, 3) ? Coloring::smooth : Coloring::flat;
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, coloring);
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
        const auto coloring = Coloring(random.integer(0, 1));
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, coloring);
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

std::vector<Kind> state_kinds() {
    return {
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
        {"scissor", scissor_scene},
        {"depth_offset", depth_offset_scene},
        {"clip_planes", clip_plane_scene},
    };
}

}  // namespace raster::conformance
