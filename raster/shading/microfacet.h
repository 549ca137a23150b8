// microfacet.h: what models of tiny mirrors share: the half vector, how the facets are spread, how they hide each other.
//
// A rough surface is taken as V-shaped grooves of mirrors. Those whose normal is the half vector h reflect l to v
// (Torrance and Sparrow, Theory for Off-Specular Reflection From Roughened Surfaces, 1967; Cook and Torrance, A
// Reflectance Model for Computer Graphics, 1982).
#pragma once

#include <raster/math.h>
#include <raster/shading/fresnel.h>

namespace raster {

/// The cosines that a pair of directions has with the normal and with h = (l + v) / |l + v|. With d = (l + v) / 2,
/// which is h by length v h, whatever a model needs of n h comes without a root and often without a division.
template <class F>
struct HalfVector {
    F n_l, n_v;     ///< as they are, also negative
    F n_d;          ///< (n l + n v) / 2, which is (n h)(v h)
    F v_h, v_h_2;   ///< v h = l h, 0 to 1, and its square
    Mask<F> above;  ///< both directions are above the surface

    F n_h() const { return clamp(n_d / v_h, F(0), F(1)); }
    F n_h_2() const { return min(n_d * n_d / v_h_2, F(1)); }
    /// 1 / (n h)^2, which is 1 + tan^2 of the angle between n and h; 1 to 1e8.
    F per_n_h_2() const { return max(v_h_2 / max(n_d * n_d, F(1e-8f) * v_h_2), F(1)); }
};

template <class F>
inline HalfVector<F> make_half_vector(const Frame<F>& frame, const vec<3, F>& l) {
    const F n_l = glm::dot(frame.n, l), n_v = glm::dot(frame.n, frame.v);
    const F v_h_2 = clamp(F(0.5f) + F(0.5f) * glm::dot(l, frame.v), F(1e-12f), F(1));
    return {n_l, n_v, F(0.5f) * (n_l + n_v), sqrt(v_h_2), v_h_2, Mask<F>((n_l > F(0)) & (n_v > F(0)))};
}

/// Smaller facet slopes than this are taken as this.
inline constexpr float min_facet_slope = 0.01f;

/// How many facets have their normal at the angle alpha from n, given 1 / cos^2 alpha here and cos alpha below; `m` is
/// the root mean square slope, 0.01 to 1. Both are pi times the distribution per steradian, so that their integral of
/// cos alpha over the hemisphere is pi. exp(-tan^2 alpha / m^2) / (m^2 cos^4 alpha):
template <class F>
inline F beckmann_distribution(F per_cos_2, float m) {
    const float per_m2 = 1.0f / (m * m);
    return raster::exp((F(1) - per_cos_2) * per_m2) * (per_cos_2 * per_cos_2 * per_m2);
}
/// c exp(-(alpha / m)^2). Its c is that of the integral: 1 / (m D(m)) with Dawson's integral D, by its series, over
/// angles beyond 90 degrees too. Those that there are give more than pi: 0.1 % at m = 0.7, up to 2 % from there to 1.
template <class F>
inline F gaussian_distribution(F n_h, float m) {
    const float m2 = m * m;
    const float dawson = m * (1 - m2 * (2.0f / 3) * (1 - m2 * (2.0f / 5) * (1 - m2 * (2.0f / 7) *
                              (1 - m2 * (2.0f / 9) * (1 - m2 * (2.0f / 11) * (1 - m2 * (2.0f / 13)))))));
    const F alpha = raster::acos(n_h);
    return raster::exp(alpha * alpha * (-1.0f / m2)) * F(1.0f / (m * dawson));
}

/// What the grooves leave of a facet's light: min(1, 2 (n h)(n v) / (v h), 2 (n h)(n l) / (v h)).
template <class F>
inline F groove_masking(const HalfVector<F>& h) {
    return min(F(1), F(2) * h.n_d * min(h.n_l, h.n_v) / h.v_h_2);
}

/// D G / (4 n v) where both directions are above the surface, else 0: what mirrors that lose nothing reflect, in
/// Reflectance's terms. `distribution` is one of those above. G and n v share a division; it stays finite where n v is
/// small.
template <class F>
inline F facet_reflection(const HalfVector<F>& h, F distribution) {
    const F n_v = max(h.n_v, F(1e-6f));
    const F masked = min(h.v_h_2, F(2) * h.n_d * min(h.n_l, n_v)) / (h.v_h_2 * n_v);
    return select(h.above, F(0.25f) * distribution * masked, F(0));
}

/// A material's roughness as a facet slope; 0 means that it has none of its own.
inline float facet_slope(const Material& material, float otherwise) {
    return material.roughness > 0.0f ? clamp(material.roughness, min_facet_slope, 1.0f) : otherwise;
}

}  // namespace raster
