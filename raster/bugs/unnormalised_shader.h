// unnormalised_shader.h: Phong shading that forgets to renormalise the interpolated normal.
#pragma once

#include <raster/shading/models.h>
#include <raster/shading/pixel_shader.h>

namespace raster {

/// As PixelShader, with the normal as it comes.
template <Detail level>
struct UnnormalisedPixelShader : PixelShader<RuntimeModel, level> {
    template <class F>
    auto fragment(const typename PixelShader<RuntimeModel, level>::template Varyings<F>& in,
                  const FragmentInput<F>& at) const {
        return this->template shade<F>(in, at, in.normal_eye);
    }
};

}  // namespace raster
