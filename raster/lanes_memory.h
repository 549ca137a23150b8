// lanes_memory.h: packs from memory and back, and single lanes of packs. Included by lanes.h.
#pragma once

#include <raster/lanes.h>

namespace raster {

/// Asks for the memory at p, which will be read soon.
inline void prefetch([[maybe_unused]] const void* p) {
#if defined(__GNUC__)
    __builtin_prefetch(p);
    // Without it g++ takes a function that does nothing else for one without effect, and drops all calls of it.
    asm volatile("");
#endif
}

/// One lane of a pack, as a scalar.
inline float lane(float x, int) { return x; }
inline std::int32_t lane(std::int32_t x, int) { return x; }
inline bool lane(bool x, int) { return x; }
template <int N>
inline float lane(FloatPack<N> x, int i) { return x.v[i]; }
template <int N>
inline std::int32_t lane(IntPack<N> x, int i) { return x.v[i]; }
template <int N>
inline bool lane(MaskPack<N> x, int i) { return x.v[i] != 0; }

/// 0, 1, 2, ... in the lanes.
template <class F>
inline Int<F> lane_index() {
    if constexpr (lanes<F> == 1) {
        return 0;
    } else {
        Int<F> r;
        for (int i = 0; i < lanes<F>; ++i) r.v[i] = i;
        return r;
    }
}

/// lanes<F> consecutive values from memory, and back. No alignment is asked.
template <class F>
inline F load(const float* p) {
    if constexpr (lanes<F> == 1) {
        return *p;
    } else {
        F r;
        std::memcpy(&r.v, p, sizeof r.v);
        return r;
    }
}
template <class F>
inline Int<F> load_int(const void* p) {
    Int<F> r;
    std::memcpy(&r, p, sizeof r);
    return r;
}
inline void store(float* p, float x) { *p = x; }
template <int N>
inline void store(float* p, FloatPack<N> x) { std::memcpy(p, &x.v, sizeof x.v); }
inline void store_int(void* p, std::int32_t x) { std::memcpy(p, &x, sizeof x); }
template <int N>
inline void store_int(void* p, IntPack<N> x) { std::memcpy(p, &x.v, sizeof x.v); }

/// base[index] in each lane. Every index is in range, dead lanes included: the caller clamps.
inline float gather(const float* base, std::int32_t index) { return base[index]; }
inline std::int32_t gather(const std::int32_t* base, std::int32_t index) { return base[index]; }
template <int N>
inline FloatPack<N> gather(const float* base, IntPack<N> index) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<FloatPack<N>>([base](auto index) { return gather(base, index); }, index);
    FloatPack<N> r;
    for (int i = 0; i < N; ++i) r.v[i] = base[index.v[i]];
    return r;
}
template <int N>
inline IntPack<N> gather(const std::int32_t* base, IntPack<N> index) {
    if constexpr (detail::is_pair<N>)
        return detail::by_halves<IntPack<N>>([base](auto index) { return gather(base, index); }, index);
#if defined(__AVX2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) {
        return detail::bits<detail::Vector<std::int32_t, N>>(
            _mm256_i32gather_epi32(base, detail::bits<__m256i>(index.v), 4));
    }
#endif
    IntPack<N> r;
    for (int i = 0; i < N; ++i) r.v[i] = base[index.v[i]];
    return r;
}

/// lanes<FloatN> triples of integers that follow each other in memory: lane i's are p[3 i] to p[3 i + 2].
inline void load3(const std::int32_t* p, IntN& a, IntN& b, IntN& c) {
#if defined(__AVX2__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (native_lanes == 8) {
        // Each of the three loads holds every third of the numbers wanted in lanes of its own: blend, then put in order.
        const auto in = [&](int i) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p + i)); };
        const auto third = [](__m256i x, __m256i y, __m256i z) {
            return _mm256_blend_epi32(_mm256_blend_epi32(x, y, 0b10010010), z, 0b00100100);
        };
        const auto ordered = [](__m256i x, __m256i order) {
            return detail::bits<IntN::V>(_mm256_permutevar8x32_epi32(x, order));
        };
        const __m256i x = in(0), y = in(8), z = in(16);
        a.v = ordered(third(x, y, z), _mm256_setr_epi32(0, 3, 6, 1, 4, 7, 2, 5));
        b.v = ordered(third(z, x, y), _mm256_setr_epi32(1, 4, 7, 2, 5, 0, 3, 6));
        c.v = ordered(third(y, z, x), _mm256_setr_epi32(2, 5, 0, 3, 6, 1, 4, 7));
        return;
    }
#endif
    for (int i = 0; i < native_lanes; ++i) a.v[i] = p[3 * i], b.v[i] = p[3 * i + 1], c.v[i] = p[3 * i + 2];
}

/// Two neighbours of two rows in each lane: base[index], base[index + 1], base[index + step], base[index + step + 1]. All
/// are in range, and no index is negative. Neighbours in memory cost one load.
inline void gather_square(const std::int32_t* base, std::int32_t index, std::ptrdiff_t step, std::int32_t& a,
                          std::int32_t& b, std::int32_t& c, std::int32_t& d) {
    const std::int32_t* const p = base + index;
    a = p[0], b = p[1], c = p[step], d = p[step + 1];
}
template <int N>
inline void gather_square(const std::int32_t* base, IntPack<N> index, std::ptrdiff_t step, IntPack<N>& a,
                          IntPack<N>& b, IntPack<N>& c, IntPack<N>& d) {
    if constexpr (detail::is_pair<N>) {
        IntPack<N / 2> x[2][4];
        for (int h = 0; h < 2; ++h)
            gather_square(base, detail::half(index, h), step, x[h][0], x[h][1], x[h][2], x[h][3]);
        a.v = {x[0][0].v, x[1][0].v}, b.v = {x[0][1].v, x[1][1].v};
        c.v = {x[0][2].v, x[1][2].v}, d.v = {x[0][3].v, x[1][3].v};
        return;
    }
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) {
        alignas(32) std::uint32_t at[8];
        store_int(at, index);
        // Without it g++ takes the lanes out of the register, which is three instructions a lane, not one.
        asm("" : "+m"(at));
        __m128 low[4], high[4];  // the neighbours in lanes 2 i and 2 i + 1, in the first row and in the second
        const std::int32_t* const next = base + step;
        for (int i = 0; i < 4; ++i) {
            const auto two = [&](const std::int32_t* row) {
                const __m128i even = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(row + at[2 * i]));
                return _mm_loadh_pi(_mm_castsi128_ps(even), reinterpret_cast<const __m64*>(row + at[2 * i + 1]));
            };
            low[i] = two(base), high[i] = two(next);
        }
        const auto split = [](const __m128* row, IntPack<N>& first, IntPack<N>& second) {
            const __m256 even = _mm256_insertf128_ps(_mm256_castps128_ps256(row[0]), row[2], 1);
            const __m256 odd = _mm256_insertf128_ps(_mm256_castps128_ps256(row[1]), row[3], 1);
            using V = typename IntPack<N>::V;
            first.v = detail::bits<V>(_mm256_shuffle_ps(even, odd, 0x88));
            second.v = detail::bits<V>(_mm256_shuffle_ps(even, odd, 0xdd));
        };
        split(low, a, b);
        split(high, c, d);
        return;
    }
#endif
    for (int i = 0; i < N; ++i) {
        const std::int32_t* const p = base + index.v[i];
        a.v[i] = p[0], b.v[i] = p[1], c.v[i] = p[step], d.v[i] = p[step + 1];
    }
}

#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
namespace detail {
/// In each half of the registers: row i becomes column i. Packs a to d hold the result.
inline void transpose4(__m256 r0, __m256 r1, __m256 r2, __m256 r3, FloatPack<8>& a, FloatPack<8>& b, FloatPack<8>& c,
                       FloatPack<8>& d) {
    const __m256 t0 = _mm256_unpacklo_ps(r0, r1), t1 = _mm256_unpackhi_ps(r0, r1);
    const __m256 t2 = _mm256_unpacklo_ps(r2, r3), t3 = _mm256_unpackhi_ps(r2, r3);
    using V = FloatPack<8>::V;
    a.v = bits<V>(_mm256_shuffle_ps(t0, t2, 0x44));
    b.v = bits<V>(_mm256_shuffle_ps(t0, t2, 0xee));
    c.v = bits<V>(_mm256_shuffle_ps(t1, t3, 0x44));
    d.v = bits<V>(_mm256_shuffle_ps(t1, t3, 0xee));
}
}  // namespace detail
#endif

/// Four consecutive floats at base + stride * index in each lane, transposed: record i's four end in lane i of a, b, c, d.
inline void gather4(const float* base, std::int32_t index, float& a, float& b, float& c, float& d,
                    std::ptrdiff_t stride = 4) {
    const float* p = base + stride * index;
    a = p[0], b = p[1], c = p[2], d = p[3];
}
template <int N>
inline void gather4(const float* base, IntPack<N> index, FloatPack<N>& a, FloatPack<N>& b, FloatPack<N>& c,
                    FloatPack<N>& d, std::ptrdiff_t stride = 4) {
    if constexpr (detail::is_pair<N>) {
        FloatPack<N / 2> x[2][4];
        for (int h = 0; h < 2; ++h) gather4(base, detail::half(index, h), x[h][0], x[h][1], x[h][2], x[h][3], stride);
        a.v = {x[0][0].v, x[1][0].v}, b.v = {x[0][1].v, x[1][1].v};
        c.v = {x[0][2].v, x[1][2].v}, d.v = {x[0][3].v, x[1][3].v};
        return;
    } else {
        const auto record = [&](int i) { return base + stride * std::ptrdiff_t(std::uint32_t(index.v[i])); };
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
        if constexpr (N == 8) {
            const auto two = [&](int i) {
                return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(record(i))),
                                            _mm_loadu_ps(record(i + 4)), 1);
            };
            detail::transpose4(two(0), two(1), two(2), two(3), a, b, c, d);
            return;
        }
#endif
        for (int i = 0; i < N; ++i) {
            const float* p = record(i);
            a.v[i] = p[0], b.v[i] = p[1], c.v[i] = p[2], d.v[i] = p[3];
        }
    }
}

/// The reverse, for the first `count` lanes: lane i's four numbers to base + stride * i.
template <int N>
inline void scatter4(float* base, int count, std::ptrdiff_t stride, FloatPack<N> a, FloatPack<N> b, FloatPack<N> c,
                     FloatPack<N> d) {
#if defined(__AVX__) && RASTER_VECTOR_EXTENSIONS
    if constexpr (N == 8) {
        const auto in = [](FloatPack<N> x) { return detail::bits<__m256>(x.v); };
        FloatPack<N> r[4];
        detail::transpose4(in(a), in(b), in(c), in(d), r[0], r[1], r[2], r[3]);
        for (int i = 0; i < count; ++i)
            std::memcpy(base + stride * i, reinterpret_cast<const float*>(&r[i & 3].v) + (i & 4), 16);
        return;
    }
#endif
    for (int i = 0; i < count; ++i) {
        float* p = base + stride * i;
        p[0] = a.v[i], p[1] = b.v[i], p[2] = c.v[i], p[3] = d.v[i];
    }
}

}  // namespace raster
