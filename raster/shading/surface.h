// surface.h: the colours of a material at a point, from its constants, its textures and the vertex colours; and how
// they meet the light.
#pragma once

#include <raster/shading/light.h>
#include <raster/shading/texture.h>

namespace raster {

/// A material ready for shading: its constants, each with an optional texture that multiplies it.
struct SurfaceMaterial {
    glm::vec3 ambient{0.0f}, diffuse{0.8f}, specular{0.0f}, emission{0.0f};
    float alpha = 1.0f;
    TextureView ambient_texture, diffuse_texture, specular_texture, emission_texture, alpha_texture;
    bool alpha_texture_has_alpha = false;  ///< its alpha channel counts, else its red one
    bool ambient_is_diffuse = false;  ///< the ambient colour is the diffuse one, textures included, times `ambient`
    bool vertex_colors = false;            ///< they multiply ambient and diffuse

    /// Nothing varies over the surface.
    bool is_plain() const {
        return !vertex_colors && !ambient_texture && !diffuse_texture && !specular_texture && !emission_texture &&
               !alpha_texture;
    }
};

/// ka, kd, ks, the emission and the opacity at a point.
template <class F>
struct SurfaceColors {
    vec<3, F> ambient, diffuse, specular, emission;
    F alpha;
};

/// The colours of a material that is_plain().
inline SurfaceColors<float> plain_colors(const SurfaceMaterial& m) {
    return {m.ambient_is_diffuse ? m.diffuse * m.ambient : m.ambient, m.diffuse, m.specular, m.emission, m.alpha};
}

namespace detail {
template <class F>
inline vec<3, F> times_texture(const glm::vec3& color, const TextureView& texture, const vec<2, F>& uv) {
    return texture ? vec<3, F>(sample<F>(texture, uv)) * color : vec<3, F>(color);
}
}  // namespace detail

/// The colours at a point of any material. The conditions are the same for the whole draw.
template <class F>
inline SurfaceColors<F> mapped_colors(const SurfaceMaterial& m, const vec<2, F>& uv, const vec<3, F>& vertex_color) {
    SurfaceColors<F> c;
    c.diffuse = detail::times_texture(m.diffuse, m.diffuse_texture, uv);
    c.ambient = m.ambient_is_diffuse ? c.diffuse * m.ambient : detail::times_texture(m.ambient, m.ambient_texture, uv);
    c.specular = detail::times_texture(m.specular, m.specular_texture, uv);
    c.emission = detail::times_texture(m.emission, m.emission_texture, uv);
    if (m.vertex_colors) {
        c.diffuse = c.diffuse * vertex_color;
        c.ambient = c.ambient * vertex_color;
    }
    c.alpha = F(m.alpha);
    if (m.alpha_texture) {
        vec<4, F> texel = sample<F>(m.alpha_texture, uv);
        c.alpha = c.alpha * (m.alpha_texture_has_alpha ? texel.w : texel.x);
    }
    return c;
}

/// The four summands of a colour, each material times light.
template <class F>
struct Terms {
    vec<3, F> emission, ambient, diffuse, specular;
};

/// Ie, Ia ka, Id kd and Is ks. `ambient` is the sum of the lights' ambient intensities.
template <class F>
inline Terms<F> make_terms(const SurfaceColors<F>& colors, const glm::vec3& ambient, const Lit<F>& lit) {
    return {colors.emission, colors.ambient * ambient, lit.diffuse * colors.diffuse, lit.specular * colors.specular};
}

namespace detail {
/// Below 0 and NaN, which only broken input can give, become 0. The clamp at 1 is the picture's.
template <class F>
inline vec<4, F> final_color(const vec<3, F>& c, F alpha) {
    return {max(c.x, F(0)), max(c.y, F(0)), max(c.z, F(0)), alpha};
}
}  // namespace detail

/// Their sum as a fragment's colour, 0 and up.
template <class F>
inline vec<4, F> sum_of(const Terms<F>& t, F alpha) {
    return detail::final_color(((t.emission + t.ambient) + t.diffuse) + t.specular, alpha);
}

/// What needs no light but the ambient one, of which this is the sum of intensities.
inline glm::vec3 unlit_color(const SurfaceColors<float>& colors, const glm::vec3& ambient) {
    return colors.emission + colors.ambient * ambient;
}

/// The same sum for a material that is the same all over, where half of it needs computing only once. The model, where it
/// is told, may have no specular part.
template <class Model = void, class F>
inline vec<4, F> plain_sum(const glm::vec3& unlit, const SurfaceColors<float>& colors, const Lit<F>& lit) {
    vec<3, F> sum = vec<3, F>(unlit) + lit.diffuse * colors.diffuse;
    if constexpr (has_specular<Model>) sum += lit.specular * colors.specular;
    return detail::final_color(sum, F(colors.alpha));
}
template <class Model = void, class F>
inline vec<4, F> plain_sum(const SurfaceMaterial& m, const glm::vec3& ambient, const Lit<F>& lit) {
    const SurfaceColors<float> colors = plain_colors(m);
    return plain_sum<Model>(unlit_color(colors, ambient), colors, lit);
}

}  // namespace raster
