// lanes_glm.h: vector functions that shaders want and GLM does not have for packs, or has with other rules.
//
// GLM's own dot, cross, normalize, length, reflect, mix and its operators work on vectors of packs as they
// are, if all operands are packs. Here are min, max and clamp with the rule of lanes.h for NaN and -0, and
// the mixtures of a pack with a uniform, which is a plain float, vector or matrix. Write them with `raster::`
// in a shader, so that F = float takes the same ones.
#pragma once

#include <raster/math.h>

namespace raster {

/// Component by component, as min, max and clamp of lanes.h.
template <int L, FloatOrPack F>
inline vec<L, F> min(const vec<L, F>& a, const vec<L, F>& b) {
    vec<L, F> r;
    for (int i = 0; i < L; ++i) r[i] = min(a[i], b[i]);
    return r;
}
template <int L, FloatOrPack F>
inline vec<L, F> max(const vec<L, F>& a, const vec<L, F>& b) {
    vec<L, F> r;
    for (int i = 0; i < L; ++i) r[i] = max(a[i], b[i]);
    return r;
}
template <int L, FloatOrPack F>
inline vec<L, F> min(const vec<L, F>& a, F b) { return min(a, vec<L, F>(b)); }
template <int L, FloatOrPack F>
inline vec<L, F> max(const vec<L, F>& a, F b) { return max(a, vec<L, F>(b)); }
template <int L, FloatOrPack F>
inline vec<L, F> clamp(const vec<L, F>& x, F low, F high) { return min(max(x, low), high); }

/// Each component to the power of y, as pow of math.h.
template <int L, FloatOrPack F>
inline vec<L, F> pow(const vec<L, F>& x, F y) {
    vec<L, F> r;
    for (int i = 0; i < L; ++i) r[i] = pow(x[i], y);
    return r;
}

/// a where t is 0, b where t is 1.
template <int L, FloatOrPack F>
inline vec<L, F> mix(const vec<L, F>& a, const vec<L, F>& b, F t) { return a * (F(1.0f) - t) + b * t; }

template <int L, FloatOrPack F>
inline F dot(const vec<L, F>& a, const vec<L, F>& b) { return glm::dot(a, b); }

// The same with uniforms, which are widened to packs: each lane computes what F = float computes.

template <int L, int N>
inline vec<L, FloatPack<N>> min(const vec<L, FloatPack<N>>& a, const vec<L, float>& b) {
    return min(a, vec<L, FloatPack<N>>(b));
}
template <int L, int N>
inline vec<L, FloatPack<N>> max(const vec<L, FloatPack<N>>& a, const vec<L, float>& b) {
    return max(a, vec<L, FloatPack<N>>(b));
}
template <int L, int N>
inline vec<L, FloatPack<N>> min(const vec<L, FloatPack<N>>& a, float b) { return min(a, FloatPack<N>(b)); }
template <int L, int N>
inline vec<L, FloatPack<N>> max(const vec<L, FloatPack<N>>& a, float b) { return max(a, FloatPack<N>(b)); }
template <int L, int N>
inline vec<L, FloatPack<N>> clamp(const vec<L, FloatPack<N>>& x, float low, float high) {
    return clamp(x, FloatPack<N>(low), FloatPack<N>(high));
}
template <int L, int N>
inline vec<L, FloatPack<N>> pow(const vec<L, FloatPack<N>>& x, float y) { return pow(x, FloatPack<N>(y)); }
template <int L, int N>
inline vec<L, FloatPack<N>> mix(const vec<L, FloatPack<N>>& a, const vec<L, FloatPack<N>>& b, float t) {
    return mix(a, b, FloatPack<N>(t));
}
template <int L, int N>
inline FloatPack<N> dot(const vec<L, FloatPack<N>>& a, const vec<L, float>& b) {
    return glm::dot(a, vec<L, FloatPack<N>>(b));
}
template <int L, int N>
inline FloatPack<N> dot(const vec<L, float>& a, const vec<L, FloatPack<N>>& b) {
    return glm::dot(vec<L, FloatPack<N>>(a), b);
}

/// A uniform matrix by a vector of packs, with the order of additions that GLM has for floats.
template <int C, int R, int N>
inline vec<R, FloatPack<N>> operator*(const mat<C, R, float>& m, const vec<C, FloatPack<N>>& v) {
    mat<C, R, FloatPack<N>> wide;
    for (int c = 0; c < C; ++c) wide[c] = vec<R, FloatPack<N>>(m[c]);
    return wide * v;
}

/// A choice between a vector of packs and a uniform.
template <int L, int N>
inline vec<L, FloatPack<N>> select(MaskPack<N> m, const vec<L, FloatPack<N>>& a, const vec<L, float>& b) {
    return select(m, a, vec<L, FloatPack<N>>(b));
}

}  // namespace raster
