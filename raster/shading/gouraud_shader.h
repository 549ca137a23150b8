// gouraud_shader.h: Gouraud shading: vertices are lit and the result is interpolated (Gouraud, Continuous Shading of
// Curved Surfaces, 1971).
#pragma once

#include <raster/shading/models.h>
#include <raster/shading/uniforms.h>

namespace raster {

namespace detail {
template <class F>
struct GouraudVaryings {
    vec<3, F> color;
};
/// Light, not colour: what varies faster than the vertices multiplies it in the pixel. Both sides, as OpenGL's
/// two-sided lighting has it, since a vertex does not know from which side its triangle is seen.
template <class F>
struct MappedGouraudVaryings {
    Lit<F> front, back;
    vec<2, F> uv;
    vec<3, F> color;
    vec<3, F> normal_eye;
};
}  // namespace detail

/// Any reflectance model, lit once a vertex. Nothing is clamped before it is interpolated. With Detail::plain a surface
/// has one side: u.two_sided is not looked at.
template <Detail level>
struct GouraudShader {
    template <class F>
    using Vertex = SurfaceVertex<F>;
    template <class F>
    using Varyings =
        std::conditional_t<level == Detail::plain, detail::GouraudVaryings<F>, detail::MappedGouraudVaryings<F>>;

    ShadingUniforms u;
    RuntimeModel model;

    template <class F>
    VertexOut<F, Varyings> vertex(const SurfaceVertex<F>& v) const {
        vec<3, F> n = eye_normal(u, v.normal);
        vec<3, F> position_eye = eye_position(u, v.position);
        Lit<F> lit = illuminate(model, u.lights, frame_at(u, model, n, position_eye), position_eye);
        VertexOut<F, Varyings> out;
        out.clip = transform_point(u.clip_from_object, v.position);
        if constexpr (level == Detail::plain) {
            out.varyings.color = vec<3, F>(plain_sum(u.material, u.ambient, lit));
        } else {
            Frame<F> behind = frame_at(u, model, -n, position_eye);
            Lit<F> back = u.two_sided ? illuminate(model, u.lights, behind, position_eye) : lit;
            out.varyings = {lit, back, v.uv, v.color, n};
        }
        return out;
    }

    template <class F>
    auto fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        if constexpr (level == Detail::plain) {
            return detail::final_color(in.color, F(u.material.alpha));
        } else {
            Lit<F> lit{select(at.front_facing, in.front.diffuse, in.back.diffuse),
                             select(at.front_facing, in.front.specular, in.back.specular)};
            SurfaceColors<F> colors = mapped_colors(u.material, in.uv, in.color);
            Terms<F> terms = make_terms(colors, u.ambient, lit);
            if constexpr (level == Detail::mapped) {
                return sum_of(terms, colors.alpha);
            } else {
                vec<3, F> n = normalize_or_zero(in.normal_eye);
                return make_outputs(u, terms, colors.alpha, u.two_sided ? negate_where<F>(!at.front_facing, n) : n,
                                    at.triangle);
            }
        }
    }
};

}  // namespace raster
