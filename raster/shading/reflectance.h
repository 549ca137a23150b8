// reflectance.h: what a reflectance model is: two directions and a frame in, a diffuse and a specular value out.
//
// Local vectors and structs of lanes are not const in this room: g++ 12 keeps const ones in memory instead of
// registers, which costs a fifth of the time of a shaded pixel.
#pragma once

#include <array>
#include <concepts>
#include <string_view>

#include <raster/lanes.h>
#include <raster/scene/model.h>

namespace raster {

/// A point of a surface as a model sees it. All vectors have unit length and are in one space, eye space in this
/// library's shaders; models use nothing but their dot products.
template <class F>
struct Frame {
    vec<3, F> n;  ///< normal; zero where the model file left none, and then nothing is lit
    vec<3, F> v;  ///< to the viewer
    vec<3, F> t;  ///< tangent, along the grain; only for models that say `anisotropic`
    vec<3, F> b;  ///< bitangent, cross(n, t)
};

/// What a model gives: how bright the surface looks from v under one light from l, before the material's kd and ks and
/// the light's colour multiply it. It is pi f(l, v) cos(theta), with the BRDF f and the angle theta between n and l. So
/// 1 is a perfect white Lambertian reflector that faces the light, and the textbooks' `kd (n l)` and `ks (r v)^n` stand
/// as they are. Models without colours of their own give three equal channels.
template <class F>
struct Reflectance {
    vec<3, F> diffuse;   ///< multiplied by kd and the light's diffuse colour
    vec<3, F> specular;  ///< multiplied by ks and the light's specular colour
};

/// A reflectance model is a type like this one, in a file of its own that models.h includes and lists:
///
///     struct Lambert {
///         static constexpr std::string_view name = "lambert";      // on the command line
///         static constexpr bool anisotropic = false;               // optional: whether it reads Frame's t and b
///         static constexpr bool specialised = true;                // optional: pixel shaders of its own, inlined; for
///                                                                  // models that cost less than a call
///         static constexpr bool has_specular = false;              // optional: that part is 0 always
///         static constexpr bool needs_data = true;                 // optional: black without what a material brings
///         static constexpr bool has_own_color = true;              // optional: the diffuse part's colour is its own,
///                                                                  // kd being white as a rule
///         static auto forms();                                     // optional: a std::array of NamedForm<Lambert>
///         float exponent = 32;                                     // parameters are members
///         Lambert with_material(const Material& material) const;   // a copy with what an MTL file says of them
///         template <class F>
///         Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const;    // l: to the light, unit
///     };
///
/// evaluate gives finite values that are not negative for all directions, and 0 for a light below the surface.
template <class M>
concept ReflectanceModel = requires(const M m, const Frame<float> frame, const vec<3, float> l,
                                    const Material material) {
    { M::name } -> std::convertible_to<std::string_view>;
    { m.with_material(material) } -> std::same_as<M>;
    { m.evaluate(frame, l) } -> std::same_as<Reflectance<float>>;
};

/// Another form of a model, with a name of its own on the command line.
template <class M>
struct NamedForm {
    std::string_view name;
    M model;
};

/// What a model says of itself, or what is true of those that do not say.
template <class M>
inline constexpr bool is_anisotropic = requires { requires M::anisotropic; };
template <class M>
inline constexpr bool is_specialised = requires { requires M::specialised; };
template <class M>
inline constexpr bool has_specular = !requires { requires !M::has_specular; };
template <class M>
inline constexpr bool needs_data = requires { requires M::needs_data; };
template <class M>
inline constexpr bool has_own_color = requires { requires M::has_own_color; };

/// Whether a model reads the tangents; some know while running only.
template <class M>
inline bool reads_tangents(const M& model) {
    if constexpr (requires { model.reads_tangents(); }) {
        return model.reads_tangents();
    } else {
        return is_anisotropic<M>;
    }
}

/// 1 / |v|; finite for the zero vector, so that no NaN comes of it.
template <class F>
inline F per_length(const vec<3, F>& v) {
    return F(1) / sqrt(max(glm::dot(v, v), F(1e-30f)));
}

/// v / |v|. The zero vector stays zero.
template <class F>
inline vec<3, F> normalize_or_zero(const vec<3, F>& v) {
    return v * per_length(v);
}

/// A frame whose tangent is `grain`, the direction of brush marks or threads, laid onto the surface. Where the grain
/// stands upright on the surface the tangents are zero.
template <class F>
inline Frame<F> make_frame(const vec<3, F>& n, const vec<3, F>& v, const vec<3, F>& grain) {
    vec<3, F> t = normalize_or_zero(grain - n * glm::dot(n, grain));
    return {n, v, t, glm::cross(n, t)};
}

/// The frame with its tangents turned about the normal, counter-clockwise seen from the normal's tip, by the angle with
/// this cosine and sine.
template <class F>
inline Frame<F> turned(const Frame<F>& frame, float cosine, float sine) {
    return {frame.n, frame.v, frame.t * F(cosine) + frame.b * F(sine), frame.b * F(cosine) - frame.t * F(sine)};
}

/// The same value in three channels.
template <class F>
inline vec<3, F> grey(F value) {
    return vec<3, F>(value);
}

}  // namespace raster
