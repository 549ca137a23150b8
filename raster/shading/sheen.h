// sheen.h: a layer of fine fibres on any surface, the glow at the outline of cloth and dusty things.
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// f = D / (4 (n l + n v - (n l)(n v))), white, with D = 6 sin^4 alpha / (2 pi): fibres that stand up (Estevez and Kulla,
/// Production Friendly Microfacet Sheen BRDF, 2017, with the roughness 1/4, where the power of the sine needs no pow; the
/// denominator is that of velvet.h). What the fibres reflect does not reach what is below them.
struct Sheen {
    float strength = 0;  ///< MTL's Ps, 0 to 1

    /// pi f n l, for directions as make_half_vector has them.
    template <class F>
    F reflection(const HalfVector<F>& h) const {
        const F sin2 = F(1) - h.n_h_2();
        const F sum = max(h.n_l + h.n_v - h.n_l * h.n_v, F(1e-6f));
        return select(h.above, F(0.75f * strength) * sin2 * sin2 * h.n_l / sum, F(0));
    }
    /// What passes on the way in and on the way out; symmetric, so that a reciprocal surface stays so.
    template <class F>
    F passing(const HalfVector<F>& h) const {
        return (F(1) - F(strength) * albedo(h.n_l)) * (F(1) - F(strength) * albedo(h.n_v));
    }
    /// The part of the light from a direction with the cosine c that fibres of strength 1 reflect: a fit that is nowhere
    /// too low and at most 0.03 too high.
    template <class F>
    static F albedo(F c) {
        const F s = sqrt(clamp(c, F(0), F(1)));
        return ((s * 0.524f - 0.502f) * s - 0.961f) * s + 0.985f;
    }
};

}  // namespace raster
