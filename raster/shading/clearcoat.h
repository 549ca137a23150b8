// clearcoat.h: a layer of clear varnish on any surface.
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// Mirrors in grooves of a colourless dielectric, n = 1.5: Cook and Torrance's F G D / (4 (n l)(n v)) with Beckmann's D. Of
/// the light that meets the surface below, the varnish takes what Fresnel's equations say on the way in, and again on
/// the way out; its own reflections inside are left out.
struct Clearcoat {
    static constexpr float n = 1.5f;

    float strength = 0;  ///< MTL's Pc, 0 to 1: how much of the surface is covered
    float m = 0.02f;     ///< slope of its facets, 0.01 to 1; the square of MTL's Pcr

    /// pi f n l, for directions as make_half_vector has them.
    template <class F>
    F reflection(const HalfVector<F>& h) const {
        const F lobe = facet_reflection(h, beckmann_distribution(h.per_n_h_2(), m));
        return F(strength) * fresnel_dielectric(h.v_h, n) * lobe;
    }
    /// What passes on the way in and on the way out; symmetric, so that a reciprocal surface stays so.
    template <class F>
    F passing(const HalfVector<F>& h) const {
        const F in = fresnel_dielectric(clamp(h.n_l, F(0), F(1)), n), out = fresnel_dielectric(clamp(h.n_v, F(0), F(1)), n);
        return (F(1) - F(strength) * in) * (F(1) - F(strength) * out);
    }
};

}  // namespace raster
