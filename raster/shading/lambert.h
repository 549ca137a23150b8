// lambert.h: the ideal matt surface, equally bright from every side (Lambert, Photometria, 1760).
#pragma once

#include <raster/shading/reflectance.h>

namespace raster {

/// Diffuse n l, nothing specular. It has no parameter.
struct Lambert {
    static constexpr std::string_view name = "lambert";
    static constexpr bool specialised = true;
    static constexpr bool has_specular = false;

    Lambert with_material(const Material&) const { return *this; }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        return {grey(dot0(frame.n, l)), grey(F(0))};
    }
};

}  // namespace raster
