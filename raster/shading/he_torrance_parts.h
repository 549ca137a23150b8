// he_torrance_parts.h: the factors of He and Torrance's model that need a series, an error function or an iteration.
#pragma once

#include <raster/math.h>

namespace raster::he_torrance {

/// 1 - erf(x) for x >= 0, absolute error 1.5e-7 (Abramowitz and Stegun, Handbook of Mathematical Functions, 7.1.26).
template <class F>
inline F erfc(F x) {
    const F t = F(1) / (F(1) + x * 0.3275911f);
    const F p = ((((F(1.061405429f) * t - 1.453152027f) * t + 1.421413741f) * t - 0.284496736f) * t + 0.254829592f) * t;
    return p * raster::exp(-(x * x));
}

/// The part of a surface of Gaussian heights that is seen at a cosine c > 0 from the normal (Smith, Geometrical Shadowing
/// of a Random Rough Surface, 1967). `shape` is tau / (2 sigma).
template <class F>
inline F smith(F c, float shape) {
    const F cot = c / sqrt(max(F(1) - c * c, F(1e-8f)));
    const F nu = max(cot * shape, F(1e-9f));
    const F tail = erfc(nu);
    const F hidden = F(0.5f) * (raster::exp(-(nu * nu)) / (nu * 1.77245385f) - tail);
    return (F(1) - F(0.5f) * tail) / (F(1) + max(hidden, F(0)));
}

/// (effective sigma / sigma)^2, 0 to 1, for light and viewer at these cosines. The paper's equation for z0 / sigma = x is
/// x exp(x^2 / 2) = (K_l + K_v) / (4 sqrt(pi / 2)), K = tan erfc(shape cot); so x^2 is Lambert's W of the right side's
/// square.
template <class F>
inline F effective_roughness(F n_l, F n_v, float shape) {
    const auto k = [&](F c) {
        const F s = sqrt(max(F(1) - c * c, F(1e-8f)));
        return s / c * erfc(c / s * shape);
    };
    const F y = (k(n_l) + k(n_v)) * 0.199471140f;
    const F z = max(y * y, F(1e-12f));
    // W from its elementary approximation, then one quadratic step (Iacono and Boyd 2017).
    constexpr float ln2 = 0.693147181f;
    const F log_1z = raster::log2(F(1) + z) * ln2;
    const F rough = log_1z * (F(1) - raster::log2(F(1) + log_1z) * ln2 / (F(2) + log_1z));
    const F w0 = max(rough, z / (F(1) + z));
    const F w = w0 / (F(1) + w0) * (F(1) + raster::log2(z / w0) * ln2);
    return F(1) / (F(1) + w);
}

/// Beyond this g the series is replaced by the first four terms of its expansion for large g, within 0.02 % of its peak:
/// the mean of exp(-spread / m) / m over m of Poisson's distribution, by the moments of that.
inline constexpr float large_g = 20.0f;

/// The sum over m = 1, 2, ... of g^m exp(-g) / (m! m) exp(-spread / m), for g and spread >= 0. `g_max`: no g is above it
/// in any lane.
template <class F>
inline F scattering(F g, F spread, float g_max) {
    const int terms = g_max < 1.0f ? 8 : g_max < 4.0f ? 16 : 42;
    const F few = min(g, F(large_g));
    F poisson = raster::exp(-few);
    F series(0);
    for (int m = 1; m <= terms; ++m) {
        const float per_m = 1.0f / float(m);
        poisson = poisson * few * per_m;
        series = series + poisson * per_m * raster::exp(spread * -per_m);
    }
    if (g_max <= large_g) return series;
    const F many = max(g, F(large_g)), t = spread / many;
    const F per_g = F(1) / many;
    const F second = (t - 4.0f) * t + 2.0f;
    const F third = (((t * 0.125f - 11.0f / 6) * t + 7.5f) * t - 9.0f) * t + 2.0f;
    const F fourth =
        (((((t * (1.0f / 48) - 2.0f / 3) * t + 22.0f / 3) * t - 34.0f) * t + 65.5f) * t - 44.0f) * t + 6.0f;
    const F bent = ((fourth * per_g + third) * per_g + second * 0.5f) * per_g + 1.0f;
    return select(g > F(large_g), raster::exp(-t) * per_g * bent, series);
}

}  // namespace raster::he_torrance
