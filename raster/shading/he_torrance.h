// he_torrance.h: wave optics of a rough surface, from a mirror to matt without coefficients to choose (He, Torrance,
// Sillion and Greenberg, A Comprehensive Physical Model for Light Reflection, 1991).
#pragma once

#include <raster/shading/he_torrance_parts.h>
#include <raster/shading/microfacet.h>

namespace raster {

/// The sum of a mirror reflection (sharp, so that a light must have a size to be seen in it), a directional diffuse one
/// (diffraction and interference at the roughness) and a uniform diffuse one, which is Reflectance's diffuse part.
struct HeTorrance {
    static constexpr std::string_view name = "he-torrance";

    Fresnel fresnel;
    float sigma = 0.2f;  ///< root mean square height of the surface in micrometres, 0 and up; 0 is a mirror
    float tau = 2.0f;    ///< distance at which heights stop being alike, in micrometres, above 0
    glm::vec3 wavelength{0.65f, 0.55f, 0.45f};  ///< of red, green and blue, in micrometres
    float source_degrees = 1.0f;  ///< half the angle that a light spans, for the mirror reflection; the sun's is 0.27

    /// The roughness is the facets' slope 2 sigma / tau, at this tau.
    HeTorrance with_material(const Material& m) const {
        HeTorrance r = *this;
        r.fresnel = fresnel.with_material(m);
        if (m.roughness > 0.0f) r.sigma = 0.5f * tau * m.roughness;
        return r;
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        HalfVector<F> h = make_half_vector(frame, l);
        const F n_l = clamp(h.n_l, F(1e-7f), F(1)), n_v = clamp(h.n_v, F(1e-7f), F(1));
        const F sum = n_l + n_v, length2 = F(4) * h.v_h_2;  // of l + v; n (l + v) is the sum
        const float shape = tau / (2.0f * max(sigma, 1e-6f));
        const F shadowing = he_torrance::smith(n_l, shape) * he_torrance::smith(n_v, shape);
        const F tilt = max(length2 - sum * sum, F(0));

        // Grazing light sees the tops of the surface only, which are smoother than the whole.
        const F effective2 = he_torrance::effective_roughness(n_l, n_v, shape) * (sigma * sigma);
        const float cos_source = float(sin_cos_degrees(source_degrees).cos);
        const float solid_angle = 6.2831853f * max(1.0f - cos_source, 1e-7f);
        const F mirrored = F(2) * h.n_l * h.n_v - glm::dot(l, frame.v);  // r v
        const Mask<F> in_mirror = mirrored >= F(cos_source);

        vec<3, F> reflected = fresnel(h.v_h);
        vec<3, F> specular;
        for (int c = 0; c < 3; ++c) {
            const float per_wavelength = 3.14159265f / wavelength[c];
            const F g = effective2 * (sum * sum) * (4.0f * per_wavelength * per_wavelength);
            const F spread = tilt * (tau * per_wavelength * tau * per_wavelength);
            const float g_max = 16.0f * sigma * sigma * per_wavelength * per_wavelength;
            const F d =
                he_torrance::scattering(g, spread, g_max) * (0.25f * tau * per_wavelength * tau * per_wavelength);
            const F geometry = length2 / sum * (length2 / sum);
            const F directional = geometry * d / n_v;
            const F mirror = select(in_mirror, raster::exp(-g) * F(3.14159265f / solid_angle), F(0));
            specular[c] = select(h.above, reflected[c] * shadowing * (directional + mirror), F(0));
        }
        return {grey(max(h.n_l, F(0))), specular};
    }
};

}  // namespace raster
