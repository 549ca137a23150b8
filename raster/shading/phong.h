// phong.h: Lambert and a highlight around the mirror direction (Phong, Illumination for Computer Generated Pictures,
// 1975).
#pragma once

#include <raster/math.h>
#include <raster/shading/reflectance.h>

namespace raster {

/// Diffuse n l, specular (r v)^exponent, where r = 2 (n l) n - l mirrors the light. Empirical: it reflects more energy
/// than it gets at grazing angles, and is not reciprocal.
struct Phong {
    static constexpr std::string_view name = "phong";
    static constexpr bool specialised = true;

    float exponent = 32.0f;  ///< shininess, 0 and up: 5 is dull, 50 glossy, 200 nearly a mirror

    Phong with_material(const Material& material) const { return {material.shininess}; }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        const F n_l = glm::dot(frame.n, l);
        const F r_v = F(2) * n_l * glm::dot(frame.n, frame.v) - glm::dot(l, frame.v);
        const F highlight = pow_shared(max(r_v, F(0)), exponent);
        return {grey(max(n_l, F(0))), grey(select(n_l > F(0), highlight, F(0)))};
    }
};

}  // namespace raster
