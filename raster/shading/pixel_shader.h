// pixel_shader.h: Phong shading: the normal is interpolated and renormalised, and every pixel is lit (Phong 1975).
#pragma once

#include <raster/shading/uniforms.h>

namespace raster {

namespace detail {
template <class F>
struct PixelVaryings {
    vec<3, F> normal_eye, position_eye;
};
template <class F>
struct MappedPixelVaryings {
    vec<3, F> normal_eye, position_eye;
    vec<2, F> uv;
    vec<3, F> color;
};
}  // namespace detail

/// Any reflectance model, lit once a pixel.
template <ReflectanceModel Model, Detail level>
struct PixelShader {
    template <class F>
    using Vertex = SurfaceVertex<F>;
    template <class F>
    using Varyings =
        std::conditional_t<level == Detail::plain, detail::PixelVaryings<F>, detail::MappedPixelVaryings<F>>;

    ShadingUniforms u;
    Model model;

    template <class F>
    VertexOut<F, Varyings> vertex(const SurfaceVertex<F>& v) const {
        VertexOut<F, Varyings> out;
        out.clip = transform_point(u.clip_from_object, v.position);
        out.varyings.normal_eye = eye_normal(u, v.normal);
        out.varyings.position_eye = eye_position(u, v.position);
        if constexpr (level != Detail::plain) {
            out.varyings.uv = v.uv;
            out.varyings.color = v.color;
        }
        return out;
    }

    template <class F>
    auto fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        return shade<F>(in, at, normalize_or_zero(in.normal_eye));
    }

    /// The same with the normal given, eye space, on the front's side.
    template <class F>
    auto shade(const Varyings<F>& in, const FragmentInput<F>& at, const vec<3, F>& outward) const {
        vec<3, F> n = u.two_sided ? negate_where<F>(!at.front_facing, outward) : outward;
        Frame<F> frame = frame_at(u, model, n, in.position_eye);
        Lit<F> lit = illuminate(model, u.lights, frame, in.position_eye);
        if constexpr (level == Detail::plain) {
            return plain_sum<Model>(u.material, u.ambient, lit);
        } else {
            SurfaceColors<F> colors = mapped_colors(u.material, in.uv, in.color);
            Terms<F> terms = make_terms(colors, u.ambient, lit);
            if constexpr (level == Detail::mapped) {
                return sum_of(terms, colors.alpha);
            } else {
                return make_outputs(u, terms, colors.alpha, n, at.triangle);
            }
        }
    }
};

}  // namespace raster
