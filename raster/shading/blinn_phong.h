// blinn_phong.h: the highlight from the half vector (Blinn, Models of Light Reflection for Computer Synthesized
// Pictures, 1977).
#pragma once

#include <raster/math.h>
#include <raster/shading/reflectance.h>

namespace raster {

/// Diffuse n l, specular (n h)^exponent, where h = (l + v) / |l + v|. Unlike Phong's, the highlight does not end where
/// r and v are more than 90 degrees apart. Empirical: it does not conserve energy.
struct BlinnPhong {
    /// What is made of the shininess alpha. The half vector turns half as fast as the mirror direction, so the same
    /// exponent gives a highlight about twice as wide as Phong's.
    enum class Exponent {
        alpha,          ///< (n h)^alpha, as Blinn and OpenGL have it
        quarter_alpha,  ///< (n h)^(alpha / 4), as some courses do
    };
    static constexpr std::string_view name = "blinn-phong";
    static constexpr bool specialised = true;
    static auto forms() {
        return std::array{NamedForm<BlinnPhong>{"blinn-phong-quarter", {32.0f, Exponent::quarter_alpha}}};
    }

    float exponent = 32.0f;  ///< shininess alpha, 0 and up
    Exponent convention = Exponent::alpha;

    BlinnPhong with_material(const Material& material) const { return {material.shininess, convention}; }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        const F n_l = glm::dot(frame.n, l);
        // (n h)^2 = (n l + n v)^2 / |l + v|^2 and |l + v|^2 = 2 + 2 l v: no square root is needed. Where l = -v there
        // is no half vector; the floor below makes that 0.
        const F sum = max(n_l + glm::dot(frame.n, frame.v), F(0));
        const F squared = (sum * sum) / max(F(2) + F(2) * glm::dot(l, frame.v), F(1e-12f));
        const float power = convention == Exponent::alpha ? exponent : exponent * 0.25f;
        const F highlight = pow_shared(min(squared, F(1)), power * 0.5f);
        return {grey(max(n_l, F(0))), grey(select(n_l > F(0), highlight, F(0)))};
    }
};

}  // namespace raster
