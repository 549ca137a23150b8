// lanes_storage.h: what holds the lanes of a pack: a register, a pair of registers, or plain C++.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include <raster/config.h>

namespace raster {

#if defined(__GNUC__) && !defined(RASTER_NO_VECTOR_EXTENSIONS)
#define RASTER_VECTOR_EXTENSIONS 1
#endif

namespace detail {

/// Packs of twice the lanes that a register holds are pairs of registers.
template <int N>
inline constexpr bool is_pair = N == 2 * native_lanes;

#if RASTER_VECTOR_EXTENSIONS
template <class T, int N>
struct VectorOf {
    typedef T type __attribute__((vector_size(sizeof(T) * N)));
};
#else
// The same operators in standard C++, for compilers without vector extensions.
template <class T, int N>
struct PlainVector {
    T lane[N];
    T& operator[](int i) { return lane[i]; }
    const T& operator[](int i) const { return lane[i]; }
#define RASTER_LANE_OPERATOR(op)                                      \
    friend PlainVector operator op(const PlainVector& a, const PlainVector& b) {     \
        PlainVector r;                                                     \
        for (int i = 0; i < N; ++i) r.lane[i] = T(a.lane[i] op b.lane[i]); \
        return r;                                                     \
    }
    RASTER_LANE_OPERATOR(+)
    RASTER_LANE_OPERATOR(-)
    RASTER_LANE_OPERATOR(*)
    RASTER_LANE_OPERATOR(/)
    RASTER_LANE_OPERATOR(&)
    RASTER_LANE_OPERATOR(|)
    RASTER_LANE_OPERATOR(^)
#undef RASTER_LANE_OPERATOR
#define RASTER_LANE_COMPARISON(op)                                                 \
    friend PlainVector<std::int32_t, N> operator op(const PlainVector& a, const PlainVector& b) { \
        PlainVector<std::int32_t, N> r;                                                 \
        for (int i = 0; i < N; ++i) r.lane[i] = a.lane[i] op b.lane[i] ? -1 : 0;   \
        return r;                                                                  \
    }
    RASTER_LANE_COMPARISON(<)
    RASTER_LANE_COMPARISON(<=)
    RASTER_LANE_COMPARISON(>)
    RASTER_LANE_COMPARISON(>=)
    RASTER_LANE_COMPARISON(==)
    RASTER_LANE_COMPARISON(!=)
#undef RASTER_LANE_COMPARISON
    friend PlainVector operator-(const PlainVector& a) {
        PlainVector r;
        for (int i = 0; i < N; ++i) r.lane[i] = -a.lane[i];
        return r;
    }
    friend PlainVector operator~(const PlainVector& a) {
        PlainVector r;
        for (int i = 0; i < N; ++i) r.lane[i] = ~a.lane[i];
        return r;
    }
    friend PlainVector operator<<(const PlainVector& a, int n) {
        PlainVector r;
        for (int i = 0; i < N; ++i) r.lane[i] = T(std::uint32_t(a.lane[i]) << n);
        return r;
    }
    friend PlainVector operator>>(const PlainVector& a, int n) {
        PlainVector r;
        for (int i = 0; i < N; ++i) r.lane[i] = a.lane[i] >> n;
        return r;
    }
};
template <class T, int N>
struct VectorOf {
    using type = PlainVector<T, N>;
};
#endif

template <class T, int N>
struct Halves;

/// What holds a pack's lanes.
template <class T, int N>
using Vector = typename std::conditional_t<is_pair<N>, std::type_identity<Halves<T, N>>, VectorOf<T, N>>::type;

/// Two registers as one vector: two independent streams of instructions, where one alone would wait for its own results.
template <class T, int N>
struct Halves {
    using Half = Vector<T, N / 2>;
    Half half[2];

    T& operator[](int i) { return reinterpret_cast<T*>(half)[i]; }
    T operator[](int i) const { return half[i / (N / 2)][i % (N / 2)]; }
#define RASTER_HALVES_OPERATOR(op) \
    friend Halves operator op(const Halves& a, const Halves& b) { return {a.half[0] op b.half[0], a.half[1] op b.half[1]}; }
    RASTER_HALVES_OPERATOR(+)
    RASTER_HALVES_OPERATOR(-)
    RASTER_HALVES_OPERATOR(*)
    RASTER_HALVES_OPERATOR(/)
    RASTER_HALVES_OPERATOR(&)
    RASTER_HALVES_OPERATOR(|)
    RASTER_HALVES_OPERATOR(^)
#undef RASTER_HALVES_OPERATOR
#define RASTER_HALVES_COMPARISON(op)                                               \
    friend Halves<std::int32_t, N> operator op(const Halves& a, const Halves& b) { \
        return {a.half[0] op b.half[0], a.half[1] op b.half[1]};                   \
    }
    RASTER_HALVES_COMPARISON(<)
    RASTER_HALVES_COMPARISON(<=)
    RASTER_HALVES_COMPARISON(>)
    RASTER_HALVES_COMPARISON(>=)
    RASTER_HALVES_COMPARISON(==)
    RASTER_HALVES_COMPARISON(!=)
#undef RASTER_HALVES_COMPARISON
    friend Halves operator-(const Halves& a) { return {-a.half[0], -a.half[1]}; }
    friend Halves operator~(const Halves& a) { return {~a.half[0], ~a.half[1]}; }
    friend Halves operator<<(const Halves& a, int n) { return {a.half[0] << n, a.half[1] << n}; }
    friend Halves operator>>(const Halves& a, int n) { return {a.half[0] >> n, a.half[1] >> n}; }
};

// One initialiser instead of a loop that fills lane by lane: g++ 12 makes the loop a store to memory and a load.
template <class V, class T, std::size_t... I>
inline V splat(T value, std::index_sequence<I...>) {
    return V{((void)I, value)...};
}
template <class V, class T>
inline V splat(T value) {
    if constexpr (requires { typename V::Half; }) {
        return {splat<typename V::Half>(value), splat<typename V::Half>(value)};
    } else {
        return splat<V>(value, std::make_index_sequence<sizeof(V) / sizeof(T)>());
    }
}

template <class To, class From>
inline To bits(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    if constexpr (requires { typename To::Half; typename From::Half; }) {
        return {bits<typename To::Half>(from.half[0]), bits<typename To::Half>(from.half[1])};
    } else {
        To to;
        std::memcpy(&to, &from, sizeof to);
        return to;
    }
}

}  // namespace detail

}  // namespace raster
