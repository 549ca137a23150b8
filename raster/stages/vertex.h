// vertex.h: stage 1, from object space to clip space: run the shader's vertex function.
#pragma once

#include <raster/shader.h>

namespace raster {

/// m * v in the order of operations that OpenGL drivers use: ((m0 x + m1 y) + m2 z) + m3 w for each row. GLM's own
/// product pairs the sums differently, and the last bit of depth would differ from OpenGL's.
template <class F>
inline vec<4, F> transform(const glm::mat4& m, const vec<4, F>& v) {
    vec<4, F> r;
    for (int row = 0; row < 4; ++row)
        r[row] = ((F(m[0][row]) * v.x + F(m[1][row]) * v.y) + F(m[2][row]) * v.z) + F(m[3][row]) * v.w;
    return r;
}

/// The same for a point (w = 1) and, without translation, for a direction (w = 0).
template <class F>
inline vec<4, F> transform_point(const glm::mat4& m, const vec<3, F>& p) {
    return transform(m, vec<4, F>(p, F(1)));
}
template <class F>
inline vec<3, F> transform_direction(const glm::mat3& m, const vec<3, F>& d) {
    vec<3, F> r;
    for (int row = 0; row < 3; ++row) r[row] = (F(m[0][row]) * d.x + F(m[1][row]) * d.y) + F(m[2][row]) * d.z;
    return r;
}

/// A vertex after its shader: a clip position, and the varyings as numbers.
template <class F, std::size_t N>
struct ShadedVertex {
    vec<4, F> clip;
    std::array<F, N> varyings;
};

template <Shader S, class F>
inline ShadedVertex<F, varying_count<S>> shade_vertex(const S& shader,
                                                      const typename S::template Vertex<F>& vertex) {
    const auto out = shader.vertex(vertex);
    return {out.clip, to_array<S, F>(out.varyings)};
}

}  // namespace raster
