// pipeline_testing.h: shaders, meshes and states that tests of the whole pipeline draw.
#pragma once

#include <vector>

#include <raster/pipeline.h>

#include "scenes.h"

namespace raster::testing {

/// Uses all that a shader may: every interpolation, extra outputs, and where its fragment lies.
struct Full {
    template <class F>
    struct Vertex {
        vec<4, F> position;
        vec<4, F> color;
        vec<2, F> id;
    };
    template <class F>
    struct Varyings {
        vec<4, F> color;
        vec<2, F> id;
        vec<2, F> affine;
    };
    template <class F>
    struct Outputs {
        vec<4, F> color;
        vec<2, F> id;
        vec<2, F> window;
        F z, oow, side;
    };
    static constexpr Interpolation interpolation(int i) {
        return i < 4 ? Interpolation::smooth : i < 6 ? Interpolation::flat : Interpolation::noperspective;
    }
    float gain = 1;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.color, v.id, vec<2, F>(v.color.x, v.color.y * F(gain))}};
    }
    template <class F>
    Outputs<F> fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        const F side = select(at.front_facing, to_float(at.triangle), F(-1) - to_float(at.triangle));
        return {in.color, in.id + in.affine, at.window, at.z, at.oow, side};
    }
};

/// The usual case: smooth colours alone.
struct Smooth {
    template <class F>
    using Vertex = Full::Vertex<F>;
    template <class F>
    struct Varyings {
        vec<4, F> color;
    };
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.color}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return in.color;
    }
};

/// No varyings at all.
struct Uniform {
    template <class F>
    using Vertex = Full::Vertex<F>;
    template <class F>
    struct Varyings {};
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>&) const {
        return {F(0.25f), F(0.5f), F(1), F(0.5f)};
    }
};

/// A colour a triangle: no varying changes across it.
struct Facets : Smooth {
    template <class F>
    struct Outputs {
        vec<4, F> color;
        F red;
    };
    static constexpr Interpolation interpolation(int) { return Interpolation::flat; }
    template <class F>
    Outputs<F> fragment(const Varyings<F>& in) const {
        return {in.color, in.color.x};
    }
};
static_assert(is_constant_fragment<Facets> && is_constant_fragment<Uniform>);
static_assert(!is_constant_fragment<Smooth> && !is_constant_fragment<Full>);

/// Depth alone.
struct DepthOnly {
    template <class F>
    using Vertex = Full::Vertex<F>;
    template <class F>
    struct Varyings {};
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {}};
    }
};

using Vertices = std::vector<Full::Vertex<float>>;

inline void add_triangle(Vertices& vertices, const Corners& corners, Random& random) {
    for (const glm::vec4& corner : corners) {
        glm::vec4 color;
        for (int i = 0; i < 4; ++i) color[i] = random.uniform(-0.1f, 1.1f);
        vertices.push_back({corner, color, glm::vec2(float(vertices.size() / 3), random.uniform(-9, 9))});
    }
}

/// Triangles of all groups; every fifth repeats the depth plane of an earlier one, so that equal depths overlap.
inline Vertices mixed_scene(Random& random, int count, int width, int height, bool wild) {
    Vertices vertices;
    for (int i = 0; i < count; ++i) {
        const int last = int(wild ? Group::wild : Group::collinear);
        const auto group = Group(random.integer(0, last));
        add_triangle(vertices, make_triangle(group, random, width, height), random);
        if (i % 5 == 4)
            for (std::size_t c = vertices.size() - 3; c < vertices.size(); ++c) vertices[c].position.z = 0;
    }
    return vertices;
}

inline constexpr std::array compares = {Compare::less,          Compare::less_equal, Compare::always,
                                        Compare::greater,       Compare::not_equal,  Compare::equal,
                                        Compare::greater_equal, Compare::never};

/// Any state but a viewport; most do not cull.
inline State random_state(Random& random) {
    State state;
    state.topology = Topology(random.integer(0, 2));
    state.front_face = FrontFace(random.integer(0, 1));
    state.cull = Cull(random.integer(0, 8) < 6 ? 0 : random.integer(1, 3));
    state.fill_rule = FillRule(random.integer(0, 1));
    state.depth_compare = compares[std::size_t(random.integer(0, 7))];
    state.depth_write = random.integer(0, 3) != 0;
    state.color_write = random.integer(0, 7) != 0;
    state.blend = Blend(random.integer(0, 2));
    return state;
}

/// What more a state may say: lines and points, a scissor rectangle, moved depths, clip planes. The planes live as long
/// as the caller's `planes`.
inline void add_rare_state(State& state, Random& random, int width, int height, std::vector<glm::vec4>& planes) {
    if (random.integer(0, 1)) {
        state.topology = Topology(random.integer(3, 6));
        state.line_width = random.integer(1, 5);
        state.point_size = random.uniform(0.5f, 7.4f);
    }
    if (random.integer(0, 1)) {
        Scissor s;
        s.x = random.integer(-20, width), s.y = random.integer(-20, height);
        s.width = random.integer(0, width), s.height = random.integer(0, height);
        state.scissor = s;
    }
    if (random.integer(0, 1))
        state.depth_offset.factor = random.uniform(-3, 3), state.depth_offset.units = random.uniform(-9999, 9999);
    planes.resize(random.integer(0, 1) ? std::size_t(random.integer(1, 9)) : 0);
    for (glm::vec4& plane : planes)
        for (int i = 0; i < 4; ++i) plane[i] = random.uniform(i == 3 ? -0.1f : -1.0f, 1.0f);
    state.clip_planes = planes;
}

}  // namespace raster::testing
