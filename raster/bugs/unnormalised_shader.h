// unnormalised_shader.h: Phong shading that forgets to renormalise the interpolated normal.
#pragma once

#include <raster/shading/models.h>
#include <raster/shading/pixel_shader.h>

namespace raster {

/// As PixelShader, but for the first line of `fragment`.
template <Detail level>
struct UnnormalisedPixelShader : PixelShader<RuntimeModel, level> {
    using Right = PixelShader<RuntimeModel, level>;
    template <class F>
    using Varyings = typename Right::template Varyings<F>;

    template <class F>
    auto fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        const ShadingUniforms& u = this->u;
        vec<3, F> outward = in.normal_eye;
        vec<3, F> n = u.two_sided ? negate_where<F>(!at.front_facing, outward) : outward;
        Frame<F> frame = frame_at(u, this->model, n, in.position_eye);
        Lit<F> lit = illuminate(this->model, u.lights, frame, in.position_eye);
        if constexpr (level == Detail::plain) {
            return plain_sum(plain_colors(u.material), u.ambient, lit);
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
