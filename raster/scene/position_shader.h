// position_shader.h: a shader that needs nothing of a vertex but its place, for pictures that are not lit.
#pragma once

#include <raster/shader.h>
#include <raster/stages/vertex.h>

namespace raster {

/// `color` is a function object, templated over F, from FragmentInput<F> to vec<4, F>.
template <class Color>
struct PositionShader {
    template <class F>
    using Vertex = SurfaceVertex<F>;
    template <class F>
    struct Varyings {};

    glm::mat4 clip_from_object;
    Color color;

    template <class F>
    VertexOut<F, Varyings> vertex(const SurfaceVertex<F>& v) const {
        return {transform_point(clip_from_object, v.position), {}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>&, const FragmentInput<F>& at) const {
        return color(at);
    }
};

}  // namespace raster
