// uniforms.h: what the flat, Gouraud and Phong shaders share: their uniforms, the frame at a point, the extra planes.
#pragma once

#include <limits>
#include <span>

#include <raster/shader.h>
#include <raster/shading/surface.h>
#include <raster/stages/vertex.h>

namespace raster {

/// How much a shader carries along. More than is needed costs time, so each is compiled on its own.
enum class Detail {
    plain,   ///< one colour all over
    mapped,  ///< textures, vertex colours
    terms,   ///< mapped, and the planes of ShadedOutputs beside the colour
};

/// What all shaders of this room know of the scene. Shading is done in eye space. Spans are not owned.
struct ShadingUniforms {
    glm::mat4 clip_from_object{1.0f};
    glm::mat4 eye_from_object{1.0f};
    glm::mat3 eye_from_object_normal{1.0f};  ///< the inverse transpose
    glm::mat3 world_from_eye{1.0f};          ///< for the normal plane
    glm::vec3 ambient{0.0f};                 ///< sum of the lights' ambient intensities
    std::span<const EyeLight> lights;
    SurfaceMaterial material;
    glm::vec3 grain_eye{1.0f, 0.0f, 0.0f};           ///< direction of brush marks, for anisotropic models
    glm::vec2 grain_turn{1.0f, 0.0f};                ///< cosine and sine of the angle that it is turned by on the surface
    bool two_sided = false;  ///< turn the normal of back faces round, else light them as they are
    glm::vec4 viewer_eye{0.0f, 0, 0, 1};             ///< homogeneous: the origin, or (0, 0, 1, 0) without perspective
    std::span<const std::int32_t> triangle_numbers;  ///< in the model, of this draw's triangles; when empty they are
    std::int32_t first_triangle = 0;                 ///< counted from here
};

/// To the viewer from a point, unit length. A viewer with w = 0 is infinitely far away.
template <class F>
inline vec<3, F> to_viewer(const ShadingUniforms& u, const vec<3, F>& position_eye) {
    return normalize_or_zero(vec<3, F>(glm::vec3(u.viewer_eye)) - position_eye * F(u.viewer_eye.w));
}

/// The frame for a normal and a direction to the viewer, both of unit length.
template <class Model, class F>
inline Frame<F> frame_with(const ShadingUniforms& u, const Model& model, const vec<3, F>& n, const vec<3, F>& v) {
    if (reads_tangents(model))
        return turned(make_frame(n, v, vec<3, F>(u.grain_eye)), u.grain_turn.x, u.grain_turn.y);
    return {n, v, vec<3, F>(F(0)), vec<3, F>(F(0))};
}
/// The frame at a point, for a normal of unit length.
template <class Model, class F>
inline Frame<F> frame_at(const ShadingUniforms& u, const Model& model, const vec<3, F>& normal_eye,
                         const vec<3, F>& position_eye) {
    return frame_with(u, model, normal_eye, to_viewer(u, position_eye));
}

/// -x where the mask is true.
template <class F>
inline vec<3, F> negate_where(Mask<F> mask, const vec<3, F>& x) {
    const Int<F> sign = select(mask, Int<F>(std::numeric_limits<std::int32_t>::min()), Int<F>(0));
    return {as_float(as_int(x.x) ^ sign), as_float(as_int(x.y) ^ sign), as_float(as_int(x.z) ^ sign)};
}

/// Position and unit normal of a vertex in eye space.
template <class F>
inline vec<3, F> eye_position(const ShadingUniforms& u, const vec<3, F>& position) {
    return vec<3, F>(transform_point(u.eye_from_object, position));
}
template <class F>
inline vec<3, F> eye_normal(const ShadingUniforms& u, const vec<3, F>& normal) {
    return normalize_or_zero(transform_direction(u.eye_from_object_normal, normal));
}

/// What a shader with Detail::terms returns: the colour, and planes for those who want to look inside it.
template <class F>
struct ShadedOutputs {
    vec<4, F> color;
    vec<3, F> normal;  ///< as lit, world space, unit length
    F triangle;        ///< its number in the model + 1, exact below 2^24; 0 is the background
    vec<3, F> ambient, diffuse, specular, emission;  ///< the summands of the colour
};

/// Where those planes begin among a target's extra channels, and how many there are.
namespace shaded_plane {
inline constexpr int normal = 0, triangle = 3, ambient = 4, diffuse = 7, specular = 10, emission = 13, count = 16;
}

/// `triangle` is its number in the draw; that of a dead lane may be anything.
template <class F>
inline ShadedOutputs<F> make_outputs(const ShadingUniforms& u, const Terms<F>& terms, F alpha,
                                     const vec<3, F>& normal_eye, Int<F> triangle) {
    Int<F> number = triangle + Int<F>(u.first_triangle);
    if (!u.triangle_numbers.empty()) {
        const Int<F> last(std::int32_t(u.triangle_numbers.size()) - 1);
        const Int<F> not_above = select(triangle > last, last, triangle);
        number = gather(u.triangle_numbers.data(), select(not_above < Int<F>(0), Int<F>(0), not_above));
    }
    return {sum_of(terms, alpha), transform_direction(u.world_from_eye, normal_eye), to_float(number + Int<F>(1)),
            terms.ambient,        terms.diffuse,                                     terms.specular,
            terms.emission};
}

}  // namespace raster
