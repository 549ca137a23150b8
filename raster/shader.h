// shader.h: what a type must offer to be drawn with: vertex attributes, varyings, and two functions over F.
#pragma once

#include <array>
#include <concepts>
#include <cstring>
#include <span>
#include <type_traits>

#include <raster/lanes.h>

namespace raster {

/// What a vertex shader returns: the clip position and the varyings.
template <class F, template <class> class Varyings>
struct VertexOut {
    vec<4, F> clip;
    Varyings<F> varyings;
};

/// How a varying gets its value at a pixel (GLSL 4.60, 4.5).
enum class Interpolation {
    smooth,         ///< perspective-correct
    noperspective,  ///< linear in window space
    flat,           ///< that of the provoking vertex, which is the triangle's last
};

/// Where a fragment lies, for shaders whose fragment function takes it as second argument.
template <class F>
struct FragmentInput {
    vec<2, F> window;      ///< the pixel's centre, in pixels from the top left corner
    F z;                   ///< window depth, 0 near to 1 far
    F oow;                 ///< 1 / clip w
    Mask<F> front_facing;
    Int<F> triangle;       ///< its number in the draw, from 0
};

namespace detail {
/// A struct of F's and nothing else is an array of F; this is its length.
template <class S>
inline constexpr int float_count = std::is_empty_v<S> ? 0 : int(sizeof(S) / sizeof(float));

template <class S>
concept HasVertex = requires(const S s, const typename S::template Vertex<float> v) { s.vertex(v).clip; };
}  // namespace detail

/// A shader is a type like this one, of which every member but Vertex, Varyings and vertex may be missing:
///
///     struct Tint {
///         template <class F> struct Vertex   { vec<3, F> position; vec<2, F> uv; };   // F's and nothing else
///         template <class F> struct Varyings { vec<2, F> uv; };                       // F's and nothing else
///         template <class F> struct Outputs  { vec<4, F> color; F more[2]; };         // for extra planes
///         static constexpr Interpolation interpolation(int i);                        // of varying float i
///         mat4 clip_from_object; vec3 tint;                                           // uniforms are members
///         template <class F> VertexOut<F, Varyings> vertex(const Vertex<F>&) const;
///         template <class F> vec<4, F> fragment(const Varyings<F>&) const;            // or returns Outputs<F>
///         template <class F> vec<4, F> fragment(const Varyings<F>&, const FragmentInput<F>&) const;
///     };
///
/// Without a fragment function a draw writes depth alone.
template <class S>
concept Shader = detail::HasVertex<S> && std::is_trivially_copyable_v<typename S::template Varyings<float>> &&
                 std::is_trivially_copyable_v<typename S::template Vertex<float>> &&
                 alignof(typename S::template Vertex<float>) == alignof(float);

/// How many floats a shader's vertex and its varyings are.
template <Shader S>
inline constexpr int attribute_count = detail::float_count<typename S::template Vertex<float>>;
template <Shader S>
inline constexpr int varying_count = detail::float_count<typename S::template Varyings<float>>;

/// Varyings as numbers, in the order of their declaration.
template <Shader S, class F = float>
using VaryingArray = std::array<F, std::size_t(varying_count<S>)>;

template <Shader S, class F>
inline VaryingArray<S, F> to_array(const typename S::template Varyings<F>& varyings) {
    VaryingArray<S, F> array;
    if constexpr (varying_count<S> > 0) std::memcpy(static_cast<void*>(array.data()), &varyings, sizeof array);
    return array;
}

template <Shader S, class F>
inline typename S::template Varyings<F> from_array(const VaryingArray<S, F>& array) {
    typename S::template Varyings<F> varyings;
    if constexpr (varying_count<S> > 0) std::memcpy(static_cast<void*>(&varyings), array.data(), sizeof array);
    return varyings;
}

/// The interpolation of varying float i: what the shader says, else smooth.
template <Shader S>
constexpr Interpolation interpolation_of(int i) {
    if constexpr (requires { S::interpolation(i); }) {
        return S::interpolation(i);
    } else {
        return Interpolation::smooth;
    }
}

/// Whether a shader computes a colour, and whether it wants to know where.
template <class S>
concept HasPlainFragment =
    requires(const S s, const typename S::template Varyings<float> in) { s.fragment(in); };
template <class S>
concept HasPlacedFragment = requires(const S s, const typename S::template Varyings<float> in,
                                     const FragmentInput<float> at) { s.fragment(in, at); };
template <class S>
concept HasFragment = HasPlainFragment<S> || HasPlacedFragment<S>;

/// What is drawn: vertices, and three indices a triangle (or as the topology says). Without indices the vertices are
/// taken in order. Nothing is copied: both arrays outlive the draw.
template <class V>
struct Mesh {
    std::span<const V> vertices;
    std::span<const std::uint32_t> indices = {};

    constexpr Mesh() = default;
    constexpr Mesh(std::span<const V> vertices, std::span<const std::uint32_t> indices = {})
        : vertices(vertices), indices(indices) {}
};
template <class C>
Mesh(const C&) -> Mesh<std::remove_cvref_t<decltype(*std::data(std::declval<const C&>()))>>;
template <class C, class I>
Mesh(const C&, const I&) -> Mesh<std::remove_cvref_t<decltype(*std::data(std::declval<const C&>()))>>;

}  // namespace raster
