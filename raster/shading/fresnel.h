// fresnel.h: how much of the light a smooth boundary reflects, for dielectrics (n) and conductors (n + ik).
//
// All for unpolarised light that comes through air (n = 1) and meets the boundary at an angle with the cosine c, 0 to 1;
// results are 0 to 1. Source: Born and Wolf, Principles of Optics, 1.5.2 and 14.2.
#pragma once

#include <raster/shading/reflectance.h>

namespace raster {

/// A dielectric of the relative refractive index n > 0: the light's side is 1. Below n = 1, which is light that leaves a
/// dense medium for a thin one, the result is 1 beyond the critical angle (total internal reflection).
template <class F>
inline F fresnel_dielectric(F c, float n) {
    const F g2 = c * c + F(n * n - 1.0f);  // (n cos of the refracted ray)^2
    const F g = sqrt(max(g2, F(0)));
    // The perpendicular amplitude is (g - c) / (g + c), the parallel one over it a / b: one division for all three.
    const F a = c * (g + c) - 1.0f, b = c * (g - c) + 1.0f;
    const F s = (g - c) / max((g + c) * b, F(1e-20f));
    return select(g2 > F(0), min(F(0.5f) * s * s * (a * a + b * b), F(1)), F(1));
}

/// A conductor of the complex index n + ik, exactly; with k = 0 a dielectric.
template <class F>
inline F fresnel_conductor(F c, float n, float k) {
    const F c2 = c * c, s2 = F(1) - c2;
    const F t0 = F(n * n - k * k) - s2;
    const F a2_b2 = sqrt(t0 * t0 + F(4 * n * n * k * k));
    const F a = sqrt(max(F(0.5f) * (a2_b2 + t0), F(0)));
    const F t1 = a2_b2 + c2, t2 = F(2) * a * c, t3 = c2 * a2_b2 + s2 * s2, t4 = t2 * s2;
    // The perpendicular part is (t1 - t2) / (t1 + t2), the parallel one that times (t3 - t4) / (t3 + t4). Half the sum:
    return clamp((t1 - t2) * t3 / max((t1 + t2) * (t3 + t4), F(1e-20f)), F(0), F(1));
}

/// The same where n^2 + k^2 is much larger than 1, as courses print it. It is off by 0.01 for gold at most, and wrong
/// for dielectrics; models use the exact one.
template <class F>
inline F fresnel_conductor_approximate(F c, float n, float k) {
    const F nc = F(n) * c, kc = F(k) * c, k2(k * k);
    const F parallel = ((nc - 1.0f) * (nc - 1.0f) + kc * kc) / ((nc + 1.0f) * (nc + 1.0f) + kc * kc);
    const F perpendicular = ((F(n) - c) * (F(n) - c) + k2) / ((F(n) + c) * (F(n) + c) + k2);
    return F(0.5f) * (parallel + perpendicular);
}

/// The two for a material with an index of its own for each colour channel.
struct Fresnel {
    glm::vec3 n{1.5f};  ///< refractive index, above 0
    glm::vec3 k{0.0f};  ///< extinction coefficient, 0 and up; 0 is a dielectric

    /// The indices that the material has; else these.
    Fresnel with_material(const Material& m) const {
        if (m.refractive_index != glm::vec3(0.0f)) return {m.refractive_index, m.extinction};
        if (m.index_of_refraction > 1.0f) return {glm::vec3(m.index_of_refraction), glm::vec3(0.0f)};
        return *this;
    }
    bool is_grey_dielectric() const { return k == glm::vec3(0.0f) && n.x == n.y && n.x == n.z; }

    /// The reflected part of each channel. The condition is the same for all lanes.
    template <class F>
    vec<3, F> operator()(F c) const {
        if (is_grey_dielectric()) return grey(fresnel_dielectric(c, n.x));
        return {fresnel_conductor(c, n.x, k.x), fresnel_conductor(c, n.y, k.y), fresnel_conductor(c, n.z, k.z)};
    }
};

/// Of light that comes to a dielectric's boundary from all sides of its inside, the part that is reflected back in: a fit
/// (Egan and Hilgeman, Optical Properties of Inhomogeneous Materials, 1979), for n from 1 to 2, within 0.02.
inline float fresnel_diffuse(float n) { return -1.440f / (n * n) + 0.710f / n + 0.668f + 0.0636f * n; }

}  // namespace raster
