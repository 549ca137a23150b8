// torrance_sparrow.h: Lambert and mirrors in grooves, spread by a Gaussian of their angle (Torrance and Sparrow 1967).
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// Specular f = F G D / (4 (n l)(n v)); its highlight grows and moves away from the mirror direction at grazing angles.
struct TorranceSparrow {
    static constexpr std::string_view name = "torrance-sparrow";

    Fresnel fresnel;
    float m = 0.3f;  ///< spread of the facets' angles in radians, 0.01 to 1 (see gaussian_distribution): 0.1 is glossy

    TorranceSparrow with_material(const Material& material) const {
        return {fresnel.with_material(material), facet_slope(material, m)};
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        HalfVector<F> h = make_half_vector(frame, l);
        vec<3, F> reflected = fresnel(h.v_h);
        return {grey(max(h.n_l, F(0))), reflected * facet_reflection(h, gaussian_distribution(h.n_h(), m))};
    }
};

}  // namespace raster
