// light.h: light sources, and what arrives of each at a point: ambient, directional, point, spot.
#pragma once

#include <span>
#include <vector>

#include <raster/math.h>
#include <raster/shading/reflectance.h>

namespace raster {

enum class LightKind {
    ambient,      ///< from everywhere, the same at every point; only its ambient colour counts
    directional,  ///< from infinitely far away, parallel and equally strong everywhere
    point,        ///< from one position to all sides
    spot,         ///< from one position into a cone around an axis
};

/// The space that a light's position and direction are given in. One in eye space moves with the viewer.
enum class LightSpace { world, eye };

/// How a light weakens with the distance d: min(1 / (c1 + c2 d + c3 d^2), 1). All three are 0 or more.
struct Attenuation {
    float c1 = 1.0f;
    float c2 = 0.0f;
    float c3 = 0.0f;
};

/// What a light's intensities are.
enum class LightUnits {
    relative,     ///< of the brightest there is: a white surface that faces a light of 1 is 1
    radiometric,  ///< of point and spot lights radiant intensity I in W/sr, which gives the irradiance I cos(theta) / r^2;
                  ///< of directional ones the irradiance of a surface that faces them, in W/m^2. Lengths are in metres;
                  ///< what a surface reflects is then radiance, in W/(m^2 sr). Ambient light is radiance that comes from
                  ///< everywhere, so that a white surface has the same
};

/// A light as its user describes it. The intensities Ia, Id, Is are separate for the three terms and for each channel,
/// linear, 0 and up. Ambient light is a light's share in what comes from everywhere: it does not weaken with distance
/// and knows no cone.
struct Light {
    LightKind kind = LightKind::directional;
    LightSpace space = LightSpace::world;
    LightUnits units = LightUnits::relative;
    glm::vec3 ambient{0.0f};
    glm::vec3 diffuse{1.0f};
    glm::vec3 specular{1.0f};
    glm::vec3 position{0.0f};           ///< of point and spot lights
    glm::vec3 direction{0.0f, 0, -1};   ///< the way the light travels; a spot's axis. Of any length but 0
    Attenuation attenuation;            ///< of point and spot lights of relative units
    float cutoff_degrees = 30.0f;       ///< half the opening of a spot's cone, 0 to 180; outside there is no light
    float falloff_exponent = 0.0f;      ///< a spot weakens by cos^exponent of the angle from its axis, 0 and up
};

/// A light ready for shading, in eye space.
struct EyeLight {
    LightKind kind;
    glm::vec3 diffuse, specular;
    glm::vec3 position_eye;
    glm::vec3 direction_eye;  ///< unit length
    Attenuation attenuation;
    float cos_cutoff;
    float falloff_exponent;
    bool inverse_square;  ///< weakens by 1 / d^2 without a bound, whatever the attenuation
};

inline EyeLight to_eye(const Light& light, const glm::mat4& eye_from_world) {
    const bool moves = light.space == LightSpace::world;
    const glm::vec3 position = moves ? glm::vec3(eye_from_world * glm::vec4(light.position, 1.0f)) : light.position;
    const glm::vec3 direction = moves ? glm::mat3(eye_from_world) * light.direction : light.direction;
    const float cos_cutoff = float(sin_cos_degrees(clamp(light.cutoff_degrees, 0.0f, 180.0f)).cos);
    // Reflectance is pi times the BRDF and cos(theta), radiance the BRDF times the irradiance.
    const bool radiometric = light.units == LightUnits::radiometric;
    const float scale = radiometric ? 0.318309886f : 1.0f;
    return {light.kind, light.diffuse * scale, light.specular * scale, position, normalize_or_zero(direction),
            light.attenuation, cos_cutoff, light.falloff_exponent, radiometric};
}

/// All lights of a scene, ready for shading: one sum for what is ambient, and the others one by one.
struct Lighting {
    glm::vec3 ambient{0.0f};
    std::vector<EyeLight> lights;
};

inline Lighting make_lighting(std::span<const Light> lights, const glm::mat4& eye_from_world) {
    Lighting lighting;
    for (const Light& light : lights) {
        lighting.ambient += light.ambient;
        if (light.kind != LightKind::ambient) lighting.lights.push_back(to_eye(light, eye_from_world));
    }
    return lighting;
}

/// min(1 / (c1 + c2 d + c3 d^2), 1).
template <class F>
inline F attenuate(const Attenuation& a, F distance, F squared_distance) {
    return min(F(1) / (F(a.c1) + F(a.c2) * distance + F(a.c3) * squared_distance), F(1));
}

/// What arrives at a point: from where, and which part of the light's colours.
template <class F>
struct LightSample {
    vec<3, F> l;  ///< to the light, unit length, eye space; zero at the light itself
    F strength;   ///< 0 to 1; 1 / d^2 of radiometric lights
};

/// How much of a spot's light goes the way of -l: its falloff inside the cone, 0 outside.
template <class F>
inline F spot_strength(const EyeLight& light, const vec<3, F>& l) {
    const F cos_axis = -glm::dot(l, vec<3, F>(light.direction_eye));
    F falloff(1);
    if (light.falloff_exponent != 0.0f) falloff = pow_shared(max(cos_axis, F(0)), light.falloff_exponent);
    return select(cos_axis >= F(light.cos_cutoff), falloff, F(0));
}

/// The kind of a light is the same for all lanes, so each branch below is taken once for all of them.
template <class F>
inline LightSample<F> sample_light(const EyeLight& light, const vec<3, F>& position_eye) {
    vec<3, F> l(-light.direction_eye);
    F strength(1);
    if (light.kind != LightKind::directional) {
        vec<3, F> to_light = vec<3, F>(light.position_eye) - position_eye;
        const F squared_distance = max(glm::dot(to_light, to_light), F(1e-30f));
        const F distance = sqrt(squared_distance);
        l = to_light * (F(1) / distance);
        strength = light.inverse_square ? F(1) / max(squared_distance, F(1e-12f))
                                        : attenuate(light.attenuation, distance, squared_distance);
        if (light.kind == LightKind::spot) strength = strength * spot_strength(light, l);
    }
    return {l, strength};
}

/// The sums over all lights of what a surface reflects, before its kd and ks.
template <class F>
struct Lit {
    vec<3, F> diffuse, specular;
};

/// The light, where a scene has only one and that is directional: the most usual case, which needs no positions.
inline const EyeLight* only_directional(std::span<const EyeLight> lights) {
    return lights.size() == 1 && lights[0].kind == LightKind::directional ? lights.data() : nullptr;
}

/// The reflectance model evaluated for a directional light.
template <class Model, class F>
inline Lit<F> illuminate_from_afar(const Model& model, const EyeLight& light, const Frame<F>& frame) {
    Reflectance<F> value = model.evaluate(frame, vec<3, F>(-light.direction_eye));
    return {value.diffuse * light.diffuse, value.specular * light.specular};
}

namespace detail {
/// The sums for lights of any number and kind.
template <class Model, class F>
RASTER_ONE_CALL Lit<F> illuminate_by_all(const Model& model, std::span<const EyeLight> lights, const Frame<F>& frame,
                                         const vec<3, F>& position_eye) {
    Lit<F> sum{vec<3, F>(F(0)), vec<3, F>(F(0))};
    for (const EyeLight& light : lights) {
        LightSample<F> from = sample_light(light, position_eye);
        Reflectance<F> value = model.evaluate(frame, from.l);
        sum.diffuse += value.diffuse * from.strength * light.diffuse;
        sum.specular += value.specular * from.strength * light.specular;
    }
    return sum;
}
}  // namespace detail

/// The reflectance model evaluated for every light, in their order.
template <class Model, class F>
inline Lit<F> illuminate(const Model& model, std::span<const EyeLight> lights, const Frame<F>& frame,
                         const vec<3, F>& position_eye) {
    if (const EyeLight* light = only_directional(lights)) [[likely]] return illuminate_from_afar(model, *light, frame);
    // Copies, so that the others stay in registers.
    Frame<F> its_frame = frame;
    vec<3, F> its_position = position_eye;
    if constexpr (std::is_trivially_copyable_v<Model>) {
        Model its_model = model;
        return detail::illuminate_by_all(its_model, lights, its_frame, its_position);
    } else {
        return detail::illuminate_by_all(model, lights, its_frame, its_position);
    }
}

}  // namespace raster
