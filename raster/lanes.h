// lanes.h: functions of one pixel's numbers and of packs of them, so that one piece of code runs for one or for several.
//
// All pixel code is a template over F, which is `float` or `FloatPack<N>`. Each function below exists for both and gives
// each lane exactly what it gives the scalar: lanes change speed, never a bit. Conditions are masks and `select`; there
// is no `if` on lanes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <raster/lanes_packs.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace raster {

// ------------------------------------------------------------------------------------------------ choosing

inline float select(bool m, float a, float b) { return m ? a : b; }
inline std::int32_t select(bool m, std::int32_t a, std::int32_t b) { return m ? a : b; }
inline std::int64_t select(bool m, std::int64_t a, std::int64_t b) { return m ? a : b; }
/// Lane by lane: a where m is true, else b.
template <int N>
inline IntPack<N> select(MaskPack<N> m, std::type_identity_t<IntPack<N>> a, std::type_identity_t<IntPack<N>> b) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<IntPack<N>>([](auto m, auto a, auto b) { return select(m, a, b); }, m, a, b);
    else
#if RASTER_VECTOR_EXTENSIONS
    return m.v ? a.v : b.v;
#else
    return (m.v & a.v) | (~m.v & b.v);
#endif
}
template <int N>
inline FloatPack<N> select(MaskPack<N> m, std::type_identity_t<FloatPack<N>> a, std::type_identity_t<FloatPack<N>> b) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<FloatPack<N>>([](auto m, auto a, auto b) { return select(m, a, b); }, m, a, b);
    else {
#if RASTER_VECTOR_EXTENSIONS
    return m.v ? a.v : b.v;
#else
    using I = detail::Vector<std::int32_t, N>;
    return detail::bits<typename FloatPack<N>::V>(
        select(m, IntPack<N>(detail::bits<I>(a.v)), IntPack<N>(detail::bits<I>(b.v))).v);
#endif
    }
}
template <int L, class F>
inline vec<L, F> select(Mask<F> m, const vec<L, F>& a, const vec<L, F>& b) {
    vec<L, F> r;
    for (int i = 0; i < L; ++i) r[i] = select(m, a[i], b[i]);
    return r;
}

inline bool any(bool m) { return m; }
inline bool all(bool m) { return m; }
inline std::uint32_t bitmask(bool m) { return m ? 1 : 0; }
/// One bit a lane, lane 0 in bit 0.
template <int N>
inline std::uint32_t bitmask(MaskPack<N> m) {
    if constexpr (detail::is_pair<N>) return bitmask(detail::half(m, 0)) | bitmask(detail::half(m, 1)) << (N / 2);
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) return std::uint32_t(_mm256_movemask_ps(detail::bits<__m256>(m.v)));
#endif
#if defined(__SSE2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 4) return std::uint32_t(_mm_movemask_ps(detail::bits<__m128>(m.v)));
#endif
    std::uint32_t r = 0;
    for (int i = 0; i < N; ++i) r |= std::uint32_t(m.v[i] & 1) << i;
    return r;
}
template <int N>
inline bool any(MaskPack<N> m) { return bitmask(m) != 0; }
template <int N>
inline bool all(MaskPack<N> m) { return bitmask(m) == (N == 32 ? ~0u : (1u << (N & 31)) - 1u); }

/// The mask whose bitmask is `bits`.
template <class F>
inline Mask<F> mask_of_bits(std::uint32_t bits) {
    if constexpr (lanes<F> == 1) {
        return bits & 1;
    } else {
        Int<F> lane_bits;
        for (int i = 0; i < lanes<F>; ++i) lane_bits.v[i] = 1 << i;
        return (Int<F>(bits) & lane_bits) != Int<F>(0);
    }
}

/// min and max as one comparison, so that NaN and -0 give the same everywhere: min(a, b) is `a < b ? a : b`. The
/// instructions of x86 are defined so, too.
template <class F>
    requires requires { typename detail::Companions<F>::Int; }
inline F min(F a, std::type_identity_t<F> b) {
    if constexpr (detail::is_pair<lanes<F>>)
        return detail::by_halves<F>([](auto a, auto b) { return min(a, b); }, a, b);
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (lanes<F> == 8)
        return detail::bits<typename F::V>(_mm256_min_ps(detail::bits<__m256>(a.v), detail::bits<__m256>(b.v)));
#endif
#if defined(__SSE2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (lanes<F> == 4)
        return detail::bits<typename F::V>(_mm_min_ps(detail::bits<__m128>(a.v), detail::bits<__m128>(b.v)));
#endif
    return select(a < b, a, b);
}
template <class F>
    requires requires { typename detail::Companions<F>::Int; }
inline F max(F a, std::type_identity_t<F> b) {
    if constexpr (detail::is_pair<lanes<F>>)
        return detail::by_halves<F>([](auto a, auto b) { return max(a, b); }, a, b);
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (lanes<F> == 8)
        return detail::bits<typename F::V>(_mm256_max_ps(detail::bits<__m256>(a.v), detail::bits<__m256>(b.v)));
#endif
#if defined(__SSE2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (lanes<F> == 4)
        return detail::bits<typename F::V>(_mm_max_ps(detail::bits<__m128>(a.v), detail::bits<__m128>(b.v)));
#endif
    return select(a > b, a, b);
}
template <int N>
inline IntPack<N> min(IntPack<N> a, IntPack<N> b) { return select(a < b, a, b); }
template <int N>
inline IntPack<N> max(IntPack<N> a, IntPack<N> b) { return select(a > b, a, b); }
template <class F>
    requires requires { typename detail::Companions<F>::Int; }
inline F clamp(F x, std::type_identity_t<F> low, std::type_identity_t<F> high) { return min(max(x, low), high); }

// ---------------------------------------------------------------------------------------- exact functions

inline float sqrt(float x) { return std::sqrt(x); }
template <int N>
inline FloatPack<N> sqrt(FloatPack<N> x) {
    if constexpr (detail::is_pair<N>) return detail::by_halves<FloatPack<N>>([](auto x) { return sqrt(x); }, x);
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) return detail::bits<typename FloatPack<N>::V>(_mm256_sqrt_ps(detail::bits<__m256>(x.v)));
#endif
#if defined(__SSE2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 4) return detail::bits<typename FloatPack<N>::V>(_mm_sqrt_ps(detail::bits<__m128>(x.v)));
#endif
    FloatPack<N> r;
    for (int i = 0; i < N; ++i) r.v[i] = std::sqrt(x.v[i]);
    return r;
}

inline float abs(float x) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7fffffffu); }
template <int N>
inline FloatPack<N> abs(FloatPack<N> x) {
    const IntPack<N> i = detail::bits<detail::Vector<std::int32_t, N>>(x.v);
    return detail::bits<typename FloatPack<N>::V>((i & IntPack<N>(0x7fffffff)).v);
}

/// The bits of a float as an integer, and back.
inline std::int32_t as_int(float x) { return std::bit_cast<std::int32_t>(x); }
inline float as_float(std::int32_t x) { return std::bit_cast<float>(x); }
template <int N>
inline IntPack<N> as_int(FloatPack<N> x) { return detail::bits<detail::Vector<std::int32_t, N>>(x.v); }
template <int N>
inline FloatPack<N> as_float(IntPack<N> x) { return detail::bits<typename FloatPack<N>::V>(x.v); }

/// Byte i of an integer, 0 the lowest: 0 to 255.
template <int i>
inline std::int32_t byte_of(std::int32_t x) { return x >> (8 * i) & 255; }
template <int i, int N>
inline IntPack<N> byte_of(IntPack<N> x) {
    if constexpr (detail::is_pair<N>) return detail::by_halves<IntPack<N>>([](auto x) { return byte_of<i>(x); }, x);
#if defined(__AVX2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8 && i > 0) {
        // One instruction for two: a shuffle of bytes, all but the lowest of each lane set to zero.
        constexpr int zeros = int(0x80808000u);
        const __m256i order = _mm256_set_epi32(zeros | (12 + i), zeros | (8 + i), zeros | (4 + i), zeros | i,
                                               zeros | (12 + i), zeros | (8 + i), zeros | (4 + i), zeros | i);
        return detail::bits<typename IntPack<N>::V>(_mm256_shuffle_epi8(detail::bits<__m256i>(x.v), order));
    }
#endif
    return (x >> (8 * i)) & IntPack<N>(255);
}

inline float to_float(std::int32_t x) { return float(x); }
template <int N>
inline FloatPack<N> to_float(IntPack<N> x) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<FloatPack<N>>([](auto x) { return to_float(x); }, x);
    else {
#if RASTER_VECTOR_EXTENSIONS
        return __builtin_convertvector(x.v, typename FloatPack<N>::V);
#else
        FloatPack<N> r;
        for (int i = 0; i < N; ++i) r.v[i] = float(x.v[i]);
        return r;
#endif
    }
}

/// Toward zero. |x| < 2^31 in every lane, dead lanes included: the caller clamps.
inline std::int32_t truncate_to_int(float x) { return std::int32_t(x); }
template <int N>
inline IntPack<N> truncate_to_int(FloatPack<N> x) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<IntPack<N>>([](auto x) { return truncate_to_int(x); }, x);
    else {
#if RASTER_VECTOR_EXTENSIONS
        return __builtin_convertvector(x.v, detail::Vector<std::int32_t, N>);
#else
        IntPack<N> r;
        for (int i = 0; i < N; ++i) r.v[i] = std::int32_t(x.v[i]);
        return r;
#endif
    }
}

/// To the nearest integer, halves to even (IEEE 754, 4.3.1). |x| < 2^31 in every lane: the caller clamps.
inline std::int32_t round_to_int(float x) {
#if defined(__SSE2__)
    return _mm_cvtss_si32(_mm_set_ss(x));
#else
    return std::int32_t(std::lrint(x));
#endif
}
template <int N>
inline IntPack<N> round_to_int(FloatPack<N> x) {
    if constexpr (detail::is_pair<N>) return detail::by_halves<IntPack<N>>([](auto x) { return round_to_int(x); }, x);
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) return detail::bits<typename IntPack<N>::V>(_mm256_cvtps_epi32(detail::bits<__m256>(x.v)));
#endif
#if defined(__SSE2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 4) return detail::bits<typename IntPack<N>::V>(_mm_cvtps_epi32(detail::bits<__m128>(x.v)));
#endif
    IntPack<N> r;
    for (int i = 0; i < N; ++i) r.v[i] = round_to_int(x.v[i]);
    return r;
}

/// The largest integer not above x, as an integer. |x| < 2^31.
template <class F>
inline Int<F> floor_to_int(F x) {
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (lanes<F> == 8)
        return truncate_to_int(F(detail::bits<typename F::V>(_mm256_floor_ps(detail::bits<__m256>(x.v)))));
    if constexpr (detail::is_pair<lanes<F>>)
        return detail::by_halves<Int<F>>([](auto x) { return floor_to_int(x); }, x);
#endif
    const Int<F> t = truncate_to_int(x);
    return select(to_float(t) > x, t - Int<F>(1), t);
}
/// The same as a float. |x| < 2^31.
template <class F>
    requires requires { typename detail::Companions<F>::Int; }
inline F floor(F x) { return to_float(floor_to_int(x)); }

// -------------------------------------------------------------------------- GLM where it needs a little help

// Uniforms are plain floats and plain vectors; GLM's operators want equal component types, so these widen them.
#define RASTER_MIXED_OPERATOR(op)                                                                            \
    template <int L, int N>                                                                                  \
    inline vec<L, FloatPack<N>> operator op(const vec<L, FloatPack<N>>& a, std::type_identity_t<float> b) {  \
        return a op FloatPack<N>(b);                                                                         \
    }                                                                                                        \
    template <int L, int N>                                                                                  \
    inline vec<L, FloatPack<N>> operator op(std::type_identity_t<float> a, const vec<L, FloatPack<N>>& b) {  \
        return FloatPack<N>(a) op b;                                                                         \
    }                                                                                                        \
    template <int L, int N>                                                                                  \
    inline vec<L, FloatPack<N>> operator op(const vec<L, FloatPack<N>>& a, const vec<L, float>& b) {         \
        return a op vec<L, FloatPack<N>>(b);                                                                 \
    }                                                                                                        \
    template <int L, int N>                                                                                  \
    inline vec<L, FloatPack<N>> operator op(const vec<L, float>& a, const vec<L, FloatPack<N>>& b) {         \
        return vec<L, FloatPack<N>>(a) op b;                                                                 \
    }
RASTER_MIXED_OPERATOR(+)
RASTER_MIXED_OPERATOR(-)
RASTER_MIXED_OPERATOR(*)
RASTER_MIXED_OPERATOR(/)
#undef RASTER_MIXED_OPERATOR

/// dot(a, b) clamped below at 0, the cosine that lighting wants.
template <int L, class F>
inline F dot0(const vec<L, F>& a, const vec<L, F>& b) { return max(glm::dot(a, b), F(0)); }

}  // namespace raster

/// GLM asserts that a vector's component is an IEC 559 type; each lane of a FloatPack is.
template <int N>
struct std::numeric_limits<raster::FloatPack<N>> : std::numeric_limits<float> {};

#include <raster/lanes_memory.h>
