// sunlit_shader.h: Phong shading of a plain material by one directional light, the most usual picture, and the fastest.
#pragma once

#include <raster/shading/pixel_shader.h>

namespace raster {

/// The bits of PixelShader<Model, Detail::plain> where `u.lights` is `light` alone. What depends on the light stays in
/// registers, and what the model does not read, the position for Lambert's, is not interpolated.
template <ReflectanceModel Model>
struct SunlitShader : PixelShader<Model, Detail::plain> {
    template <class F>
    using Varyings = typename PixelShader<Model, Detail::plain>::template Varyings<F>;

    EyeLight light;  ///< directional

    template <class F>
    vec<4, F> fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        vec<3, F> n = normalize_or_zero(in.normal_eye);
        if (this->u.two_sided) n = negate_where<F>(!at.front_facing, n);
        Lit<F> lit = illuminate_from_afar(this->model, light, frame_at(this->u, this->model, n, in.position_eye));
        return plain_sum<Model>(plain_colors(this->u.material), this->u.ambient, lit);
    }
};

}  // namespace raster
