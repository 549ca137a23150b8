// velvet.h: cloth of upright fibres, bright at its outline (Ashikhmin, Premoze and Shirley, A Microfacet-Based BRDF
// Generator, 2000; in the form of Ashikhmin and Premoze, Distribution-Based BRDFs, 2007).
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// Lambert and f = D / (4 (n l + n v - (n l)(n v))), with facets that avoid the normal: D = (1 + 4 exp(-cot^2 alpha /
/// m^2) / sin^4 alpha) / (pi (1 + 4 m^2)).
struct Velvet {
    static constexpr std::string_view name = "velvet";

    float m = 0.4f;  ///< how far the fibres lean, 0.01 to 1

    Velvet with_material(const Material& material) const {
        return {facet_slope(material, m)};
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        HalfVector<F> h = make_half_vector(frame, l);
        const F cos2 = h.n_h_2(), sin2 = max(F(1) - cos2, F(1e-4f));
        const F fibres = F(4) * raster::exp(cos2 / sin2 * (-1.0f / (m * m))) / (sin2 * sin2);
        const F d = (F(1) + fibres) * (1.0f / (1.0f + 4.0f * m * m));
        const F sum = max(h.n_l + h.n_v - h.n_l * h.n_v, F(1e-6f));
        const F value = select(h.above, F(0.25f) * d * h.n_l / sum, F(0));
        return {grey(max(h.n_l, F(0))), grey(value)};
    }
};

}  // namespace raster
