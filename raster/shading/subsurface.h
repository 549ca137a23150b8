// subsurface.h: marble, milk and skin under even light: light that wanders below the surface, taken as a BRDF (Jensen,
// Marschner, Levoy and Hanrahan, A Practical Model for Subsurface Light Transport, 2001).
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// Diffuse f = F Rd / pi + single scattering; the light leaves where it came in, which is right where all of the surface
/// around is lit alike. Specular: the boundary's own reflection, rough like Torrance and Sparrow's. F is the part that
/// passes the boundary, in and out.
struct Subsurface {
    static constexpr std::string_view name = "subsurface";
    static constexpr bool has_own_color = true;

    glm::vec3 scattering{2.19f, 2.62f, 3.00f};        ///< reduced, sigma_s' in 1/mm, 0 and up; here that of marble
    glm::vec3 absorption{0.0021f, 0.0041f, 0.0071f};  ///< sigma_a in 1/mm, 0 and up
    float n = 1.5f;                                   ///< refractive index, 1 to 2
    float m = 0.3f;                                   ///< spread of the boundary's facets, 0.01 to 1

    Subsurface with_material(const Material& material) const {
        Subsurface r = *this;
        if (material.scattering != glm::vec3(0.0f)) {
            r.scattering = material.scattering;
            r.absorption = material.absorption;
        }
        if (material.index_of_refraction > 1.0f) r.n = min(material.index_of_refraction, 2.0f);
        r.m = facet_slope(material, m);
        return r;
    }

    /// sigma_s' / (sigma_s' + sigma_a): how much of the light goes on at each collision.
    glm::vec3 albedo() const {
        return scattering / glm::max(scattering + absorption, glm::vec3(1e-20f));
    }
    /// Rd, the part of even light that comes out again: the integral of the dipole over the surface.
    glm::vec3 diffuse_reflectance() const {
        const float fdr = fresnel_diffuse(n), a = (1.0f + fdr) / (1.0f - fdr);
        const glm::vec3 alpha = albedo();
        glm::vec3 r;
        for (int c = 0; c < 3; ++c) {
            const float root = sqrt(3.0f * (1.0f - alpha[c]));
            r[c] = 0.5f * alpha[c] * (1.0f + raster::exp(-4.0f / 3.0f * a * root)) * raster::exp(-root);
        }
        return r;
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        HalfVector<F> h = make_half_vector(frame, l);
        const F n_l = max(h.n_l, F(0)), n_v = max(h.n_v, F(0));
        const F passing = (F(1) - fresnel_dielectric(n_l, n)) * (F(1) - fresnel_dielectric(n_v, n));
        // The cosines below the surface, and the paper's single scattering for a phase function that knows no direction:
        // alpha F / (4 pi (cos_l + cos_v)).
        const float per_n2 = 1.0f / (n * n);
        const F cos_l = sqrt(F(1) - (F(1) - n_l * n_l) * per_n2), cos_v = sqrt(F(1) - (F(1) - n_v * n_v) * per_n2);
        const F single = F(0.25f) / max(cos_l + cos_v, F(1e-6f));
        vec<3, F> f = vec<3, F>(diffuse_reflectance()) + vec<3, F>(albedo()) * single;
        const F boundary = fresnel_dielectric(h.v_h, n) * facet_reflection(h, gaussian_distribution(h.n_h(), m));
        return {f * select(h.above, passing * n_l, F(0)), grey(boundary)};
    }
};

}  // namespace raster
