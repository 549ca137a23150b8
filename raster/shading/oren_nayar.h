// oren_nayar.h: rough matt surfaces: clay, plaster, the moon (Oren and Nayar, Generalization of Lambert's Reflectance
// Model, 1994).
#pragma once

#include <raster/shading/reflectance.h>

namespace raster {

/// Grooves of Lambertian facets, by the paper's qualitative model: (n l) (A + B max(0, cos(phi_l - phi_v)) sin a tan b),
/// a and b the larger and the smaller of the two polar angles. At sigma = 0 it is Lambert's; rougher surfaces are flatter
/// in brightness, like the full moon's disc.
struct OrenNayar {
    static constexpr std::string_view name = "oren-nayar";
    static constexpr bool specialised = true;
    static constexpr bool has_specular = false;

    float sigma = 0.5f;  ///< standard deviation of the facets' slope angle in radians, 0 to pi/2

    OrenNayar with_material(const Material& m) const { return {m.roughness > 0.0f ? m.roughness : sigma}; }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        const float s2 = sigma * sigma;
        const float a = 1.0f - 0.5f * s2 / (s2 + 0.33f), b = 0.45f * s2 / (s2 + 0.09f);
        const F n_l = glm::dot(frame.n, l), n_v = dot0(frame.n, frame.v);
        // cos(phi) sin a tan b = (l v - (n l)(n v)) / max(n l, n v), since sin a sin b is the length of both tangents.
        const F along = max(glm::dot(l, frame.v) - n_l * n_v, F(0)) / max(max(n_l, n_v), F(1e-6f));
        return {grey(max(n_l, F(0)) * (F(a) + F(b) * along)), grey(F(0))};
    }
};

}  // namespace raster
