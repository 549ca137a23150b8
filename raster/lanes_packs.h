// lanes_packs.h: the packs of floats, integers and masks, with their operators. What else they can do is in lanes.h.
#pragma once

#include <concepts>
#include <cstdint>

#include <glm/glm.hpp>

#include <raster/lanes_storage.h>

namespace raster {

// ------------------------------------------------------------------------------------------ the three packs

/// N truth values; a true lane is all ones.
template <int N>
struct MaskPack {
    detail::Vector<std::int32_t, N> v;

    MaskPack() = default;
    MaskPack(detail::Vector<std::int32_t, N> v) : v(v) {}
    explicit MaskPack(bool all) : v(detail::splat<detail::Vector<std::int32_t, N>, std::int32_t>(all ? -1 : 0)) {}

    friend MaskPack operator&(MaskPack a, MaskPack b) { return a.v & b.v; }
    friend MaskPack operator|(MaskPack a, MaskPack b) { return a.v | b.v; }
    friend MaskPack operator!(MaskPack a) { return ~a.v; }
};

/// N 32-bit integers, which wrap on overflow: dead lanes hold garbage, and garbage must not be undefined behaviour.
template <int N>
struct IntPack {
    using V = detail::Vector<std::int32_t, N>;
    using Wrapping = detail::Vector<std::uint32_t, N>;
    V v;

    IntPack() = default;
    IntPack(V v) : v(v) {}
    template <std::integral I>
    IntPack(I all) : v(detail::splat<V>(std::int32_t(all))) {}

    Wrapping wrapping() const { return detail::bits<Wrapping>(v); }
    friend IntPack operator+(IntPack a, IntPack b) { return detail::bits<V>(a.wrapping() + b.wrapping()); }
    friend IntPack operator-(IntPack a, IntPack b) { return detail::bits<V>(a.wrapping() - b.wrapping()); }
    friend IntPack operator*(IntPack a, IntPack b) { return detail::bits<V>(a.wrapping() * b.wrapping()); }
    friend IntPack operator&(IntPack a, IntPack b) { return a.v & b.v; }
    friend IntPack operator|(IntPack a, IntPack b) { return a.v | b.v; }
    friend IntPack operator^(IntPack a, IntPack b) { return a.v ^ b.v; }
    friend IntPack operator<<(IntPack a, int n) { return a.v << n; }
    friend IntPack operator>>(IntPack a, int n) { return a.v >> n; }
    friend MaskPack<N> operator<(IntPack a, IntPack b) { return MaskPack<N>(a.v < b.v); }
    friend MaskPack<N> operator<=(IntPack a, IntPack b) { return MaskPack<N>(a.v <= b.v); }
    friend MaskPack<N> operator>(IntPack a, IntPack b) { return MaskPack<N>(a.v > b.v); }
    friend MaskPack<N> operator>=(IntPack a, IntPack b) { return MaskPack<N>(a.v >= b.v); }
    friend MaskPack<N> operator==(IntPack a, IntPack b) { return MaskPack<N>(a.v == b.v); }
    friend MaskPack<N> operator!=(IntPack a, IntPack b) { return MaskPack<N>(a.v != b.v); }
};

/// N floats. It works as the component type of GLM's vectors: glm::vec<3, FloatPack<8>>.
template <int N>
struct FloatPack {
    using V = detail::Vector<float, N>;
    V v;

    FloatPack() = default;
    FloatPack(V v) : v(v) {}
    FloatPack(float all) : v(detail::splat<V>(all)) {}
    FloatPack(int all) : FloatPack(float(all)) {}
    FloatPack(double all) : FloatPack(float(all)) {}

    friend FloatPack operator+(FloatPack a, FloatPack b) { return a.v + b.v; }
    friend FloatPack operator-(FloatPack a, FloatPack b) { return a.v - b.v; }
    friend FloatPack operator*(FloatPack a, FloatPack b) { return a.v * b.v; }
    friend FloatPack operator/(FloatPack a, FloatPack b) { return a.v / b.v; }
    friend FloatPack operator-(FloatPack a) { return -a.v; }
    friend MaskPack<N> operator<(FloatPack a, FloatPack b) { return MaskPack<N>(a.v < b.v); }
    friend MaskPack<N> operator<=(FloatPack a, FloatPack b) { return MaskPack<N>(a.v <= b.v); }
    friend MaskPack<N> operator>(FloatPack a, FloatPack b) { return MaskPack<N>(a.v > b.v); }
    friend MaskPack<N> operator>=(FloatPack a, FloatPack b) { return MaskPack<N>(a.v >= b.v); }
    friend MaskPack<N> operator==(FloatPack a, FloatPack b) { return MaskPack<N>(a.v == b.v); }
    friend MaskPack<N> operator!=(FloatPack a, FloatPack b) { return MaskPack<N>(a.v != b.v); }
    FloatPack& operator+=(FloatPack b) { return *this = *this + b; }
    FloatPack& operator-=(FloatPack b) { return *this = *this - b; }
    FloatPack& operator*=(FloatPack b) { return *this = *this * b; }
    FloatPack& operator/=(FloatPack b) { return *this = *this / b; }
};

// ------------------------------------------------------------------------------- from F to its companions

namespace detail {
template <class F>
struct Companions;
template <>
struct Companions<float> {
    using Int = std::int32_t;
    using Mask = bool;
    static constexpr int lanes = 1;
};
template <int N>
struct Companions<FloatPack<N>> {
    using Int = IntPack<N>;
    using Mask = MaskPack<N>;
    static constexpr int lanes = N;
};
}  // namespace detail

/// The integers that go with F: std::int32_t or IntPack.
template <class F>
using Int = typename detail::Companions<F>::Int;
/// The truth values that go with F: bool or MaskPack.
template <class F>
using Mask = typename detail::Companions<F>::Mask;
/// How many pixels F stands for.
template <class F>
inline constexpr int lanes = detail::Companions<F>::lanes;

/// The pack that fits this build's registers.
using FloatN = FloatPack<native_lanes>;
using IntN = IntPack<native_lanes>;
using MaskN = MaskPack<native_lanes>;
/// Twice that, for work that is bound by the wait for its own results.
using FloatPair = FloatPack<2 * native_lanes>;

/// GLM's vector and matrix over F.
template <int L, class F>
using vec = glm::vec<L, F, glm::defaultp>;
template <int C, int R, class F>
using mat = glm::mat<C, R, F, glm::defaultp>;

namespace detail {
template <int N>
FloatPack<N / 2> half(FloatPack<N> x, int i) { return x.v.half[i]; }
template <int N>
IntPack<N / 2> half(IntPack<N> x, int i) { return x.v.half[i]; }
template <int N>
MaskPack<N / 2> half(MaskPack<N> x, int i) { return x.v.half[i]; }

/// A function of packs, for pairs: on one half, then on the other. R is the result's pack.
template <class R, class Function, class... Pack>
inline R by_halves(const Function& function, Pack... packs) {
    return R(decltype(R::v){function(half(packs, 0)...).v, function(half(packs, 1)...).v});
}
}  // namespace detail

}  // namespace raster
