// cook_torrance.h: metals and plastics as mirrors in grooves (Cook and Torrance 1982).
#pragma once

#include <raster/shading/microfacet.h>

namespace raster {

/// f = kd / pi + ks F G D / (4 pi (n l)(n v)), with D = exp(-tan^2 alpha / m^2) / (m^2 cos^4 alpha) (Beckmann) or c
/// exp(-(alpha / m)^2). A conductor has kd = 0 and ks = 1, a dielectric may have kd + ks = 1.
struct CookTorrance {
    enum class Distribution { beckmann, gaussian };
    /// What stands under F G D. The paper prints pi (n l)(n v), four times as bright: a white surface would then reflect
    /// up to four times what it gets.
    enum class Denominator { four_pi, pi };
    static constexpr std::string_view name = "cook-torrance";
    static constexpr bool specialised = true;
    static auto forms() {
        CookTorrance gaussian, over_pi;
        gaussian.distribution = Distribution::gaussian;
        over_pi.denominator = Denominator::pi;
        using Form = NamedForm<CookTorrance>;
        return std::array{Form{"cook-torrance-gaussian", gaussian}, Form{"cook-torrance-pi", over_pi}};
    }

    Fresnel fresnel;
    float m = 0.2f;  ///< root mean square slope of the facets, 0.01 to 1: 0.1 is glossy, 0.6 dull
    Distribution distribution = Distribution::beckmann;
    Denominator denominator = Denominator::four_pi;

    CookTorrance with_material(const Material& material) const {
        return {fresnel.with_material(material), facet_slope(material, m), distribution, denominator};
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        HalfVector<F> h = make_half_vector(frame, l);
        F d = distribution == Distribution::beckmann ? beckmann_distribution(h.per_n_h_2(), m)
                                                     : gaussian_distribution(h.n_h(), m);
        if (denominator == Denominator::pi) d = d * 4.0f;
        vec<3, F> reflected = fresnel(h.v_h);
        return {grey(max(h.n_l, F(0))), reflected * facet_reflection(h, d)};
    }
};

}  // namespace raster
