// microfacet.h: what models of tiny mirrors share: the half vector, how the facets are spread, how they hide each other.
//
// A rough surface is taken as V-shaped grooves of mirrors. Those whose normal is the half vector h reflect l to v
// (Torrance and Sparrow, Theory for Off-Specular Reflection From Roughened Surfaces, 1967; Cook and Torrance, A
// Reflectance Model for Computer Graphics, 1982).
#pragma once

#include <raster/math.h>
#include <raster/shading/fresnel.h>

namespace raster {

/// The cosines that a pair of directions has with the normal and with h = (l + v) / |l + v|.
template <class F>
struct HalfVector {
    F n_l, n_v;  ///< as they are, also negative
    F n_h, v_h;  ///< 0 to 1; v h = l h
    Mask<F> above;  ///< both directions are above the surface
};

/// Without h itself: n h = (n l + n v) / |l + v| and v h = |l + v| / 2.
template <class F>
inline HalfVector<F> make_half_vector(const Frame<F>& frame, const vec<3, F>& l) {
    const F n_l = glm::dot(frame.n, l), n_v = glm::dot(frame.n, frame.v);
    const F length = sqrt(max(F(2) + F(2) * glm::dot(l, frame.v), F(1e-12f)));
    const F n_h = clamp((n_l + n_v) / length, F(0), F(1));
    return {n_l, n_v, n_h, min(F(0.5f) * length, F(1)), Mask<F>((n_l > F(0)) & (n_v > F(0)))};
}

/// Smaller facet slopes than this are taken as this.
inline constexpr float min_facet_slope = 0.01f;

/// How many facets have their normal at the angle alpha from n, given cos alpha; `m` is the root mean square slope, 0.01
/// to 1. Both are pi times the distribution per steradian, so that their integral of cos alpha over the hemisphere is
/// pi.
template <class F>
inline F beckmann_distribution(F n_h, float m) {
    const F c2 = max(n_h * n_h, F(1e-8f));
    const float per_m2 = 1.0f / (m * m);
    return raster::exp((F(1) - F(1) / c2) * per_m2) * (F(per_m2) / (c2 * c2));
}
/// c exp(-(alpha / m)^2). Its c is that of the integral: 1 / (m D(m)) with Dawson's integral D, by its series; what
/// lies beyond 90 degrees is left out of it, at most 1 % at m = 0.7.
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
    const F both = F(2) * h.n_h / max(h.v_h, F(1e-6f));
    return min(F(1), both * min(h.n_l, h.n_v));
}

/// D G / (4 n v) where both directions are above the surface, else 0: what mirrors that lose nothing reflect, in
/// Reflectance's terms. `distribution` is one of those above. G / (n v) stays finite where n v is small.
template <class F>
inline F facet_reflection(const HalfVector<F>& h, F distribution) {
    const F n_v = max(h.n_v, F(1e-6f));
    const F masked = min(F(1), F(2) * h.n_h * h.n_l / max(h.v_h, F(1e-6f))) / n_v;
    const F hidden = F(2) * h.n_h / max(h.v_h, F(1e-6f));
    return select(h.above, F(0.25f) * distribution * min(masked, hidden), F(0));
}

/// A material's roughness as a facet slope; 0 means that it has none of its own.
inline float facet_slope(const Material& material, float otherwise) {
    return material.roughness > 0.0f ? clamp(material.roughness, min_facet_slope, 1.0f) : otherwise;
}

}  // namespace raster
