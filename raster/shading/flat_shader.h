// flat_shader.h: flat shading: each triangle is lit once, at its centroid with its own normal, and has that one colour.
#pragma once

#include <raster/shading/models.h>
#include <raster/shading/uniforms.h>

namespace raster {

/// The light on one triangle: floats and nothing else, since fragments gather from an array of these.
struct FaceLight {
    Lit<float> lit;
    glm::vec3 normal_eye;  ///< as lit: turned to the viewer if two-sided
    glm::vec3 color;       ///< mean of the corners' vertex colours
};

/// The corners of a triangle in object space, and the mean of their colours.
template <class F>
struct Face {
    std::array<vec<3, F>, 3> position;
    vec<3, F> color;
};

template <class F>
struct LitFace {
    Lit<F> lit;
    vec<3, F> normal_eye;
};

/// Lights a face: the plane's normal from its corners, which run counter-clockwise seen from the front. One without
/// area has no normal and no light.
template <class F>
inline LitFace<F> light_face(const ShadingUniforms& u, const RuntimeModel& model, const Face<F>& face) {
    vec<3, F> a = eye_position(u, face.position[0]);
    vec<3, F> b = eye_position(u, face.position[1]);
    vec<3, F> c = eye_position(u, face.position[2]);
    vec<3, F> centroid = (a + b + c) * F(1.0f / 3.0f);
    // Edges of unit length first: the product of two tiny or huge ones would leave the range of floats.
    vec<3, F> outward = normalize_or_zero(glm::cross(normalize_or_zero(b - a), normalize_or_zero(c - a)));
    const Mask<F> away = glm::dot(outward, to_viewer(u, centroid)) < F(0);
    vec<3, F> n = u.two_sided ? negate_where<F>(away, outward) : outward;
    return {illuminate(model, u.lights, frame_at(u, model, n, centroid), centroid), n};
}

/// Lights all triangles of a mesh, in their order. An index beyond the vertices gives a face without light.
std::vector<FaceLight> light_faces(const ShadingUniforms& u, const RuntimeModel& model,
                                   const Mesh<SurfaceVertex<float>>& mesh);

namespace detail {
template <class F>
struct FlatVaryings {};
template <class F>
struct MappedFlatVaryings {
    vec<2, F> uv;
};
}  // namespace detail

/// Draws triangles whose light is known: the fragment looks it up by the triangle's number. Textures still vary.
template <Detail level>
struct FlatShader {
    template <class F>
    using Vertex = SurfaceVertex<F>;
    template <class F>
    using Varyings = std::conditional_t<level == Detail::plain, detail::FlatVaryings<F>, detail::MappedFlatVaryings<F>>;

    ShadingUniforms u;
    std::span<const FaceLight> faces;  ///< of the triangles of the draw, in their order; not owned, not empty

    template <class F>
    VertexOut<F, Varyings> vertex(const SurfaceVertex<F>& v) const {
        VertexOut<F, Varyings> out;
        out.clip = transform_point(u.clip_from_object, v.position);
        if constexpr (level != Detail::plain) out.varyings.uv = v.uv;
        return out;
    }

    template <class F>
    auto fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        const Int<F> face = clamped<F>(at.triangle);
        Lit<F> lit{look_up<F>(face, 0), look_up<F>(face, 3)};
        if constexpr (level == Detail::plain) {
            return plain_sum(u.material, u.ambient, lit);
        } else {
            SurfaceColors<F> colors = mapped_colors(u.material, in.uv, look_up<F>(face, 9));
            Terms<F> terms = make_terms(colors, u.ambient, lit);
            if constexpr (level == Detail::mapped) {
                return sum_of(terms, colors.alpha);
            } else {
                return make_outputs(u, terms, colors.alpha, look_up<F>(face, 6), at.triangle);
            }
        }
    }

private:
    static constexpr int floats_per_face = int(sizeof(FaceLight) / sizeof(float));

    /// A dead lane's number may be anything.
    template <class F>
    Int<F> clamped(Int<F> triangle) const {
        const Int<F> last(std::int32_t(faces.size()) - 1);
        const Int<F> not_above = select(triangle > last, last, triangle);
        return select(not_above < Int<F>(0), Int<F>(0), not_above);
    }
    template <class F>
    vec<3, F> look_up(Int<F> face, int offset) const {
        const float* numbers = reinterpret_cast<const float*>(faces.data()) + offset;
        const Int<F> at = face * Int<F>(floats_per_face);
        return {gather(numbers, at), gather(numbers + 1, at), gather(numbers + 2, at)};
    }
};

}  // namespace raster
