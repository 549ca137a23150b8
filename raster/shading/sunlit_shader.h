// sunlit_shader.h: Phong shading of a plain material by one directional light, the most usual picture, and the fastest.
#pragma once

#include <raster/shading/pixel_shader.h>

namespace raster {

/// Whether there is one light, and that is directional.
inline bool is_sunlit(const ShadingUniforms& u) { return only_directional(u.lights) != nullptr; }

/// The bits of PixelShader<Model, Detail::plain>, for uniforms that are is_sunlit. What pixels share is computed once;
/// and what the model does not read, the position for Lambert's, the compiler sees is of no use, and leaves it out.
template <ReflectanceModel Model>
struct SunlitShader : PixelShader<Model, Detail::plain> {
    using Base = PixelShader<Model, Detail::plain>;
    template <class F>
    using Varyings = typename Base::template Varyings<F>;

    EyeLight light;
    SurfaceColors<float> colors;
    glm::vec3 unlit;        ///< emission and ambient light
    bool sees_from_origin;  ///< the viewer is at eye space's origin

    SunlitShader(const ShadingUniforms& uniforms, const Model& model)
        : Base{uniforms, model},
          light(uniforms.lights[0]),
          colors(plain_colors(uniforms.material)),
          unlit(unlit_color(colors, uniforms.ambient)),
          sees_from_origin(uniforms.viewer_eye == glm::vec4(0.0f, 0, 0, 1)) {}

    template <class F>
    vec<4, F> fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        vec<3, F> n = normalize_or_zero(in.normal_eye);
        if (this->u.two_sided) n = negate_where<F>(!at.front_facing, n);
        vec<3, F> v = sees_from_origin ? in.position_eye * -per_length(in.position_eye)
                                       : to_viewer(this->u, in.position_eye);
        Lit<F> lit = illuminate_from_afar(this->model, light, frame_with(this->u, this->model, n, v));
        return plain_sum<Model>(unlit, colors, lit);
    }
};

}  // namespace raster
