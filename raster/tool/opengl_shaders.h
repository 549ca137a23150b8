// opengl_shaders.h: flat, Gouraud and Phong shading in GLSL, written from the formulas alone: what ours is held against.
#pragma once

namespace raster::tool::glsl {

// One sum of light for all three frequencies. reflect_light is the reflectance model's (opengl_models.cpp).
inline constexpr const char* lighting = R"(
struct Light {
    int kind;  // 1 directional, 2 point, 3 spot
    vec3 diffuse, specular, position, direction, attenuation;
    float cos_cutoff, falloff;
    bool inverse_square;
};
uniform Light lights[8];
uniform int light_count;
uniform vec4 viewer;
uniform vec3 grain;
uniform float grain_cosine, grain_sine;

void illuminate(vec3 n, vec3 p, out vec3 diffuse, out vec3 specular) {
    vec3 v = normalize(viewer.xyz - p * viewer.w), t = normalize(grain - n * dot(n, grain));
    t = t * grain_cosine + cross(n, t) * grain_sine;
    vec3 b = cross(n, t);
    diffuse = specular = vec3(0.0);
    for (int i = 0; i < light_count; ++i) {
        vec3 l = -lights[i].direction;
        float strength = 1.0;
        if (lights[i].kind != 1) {
            vec3 to_light = lights[i].position - p;
            float d = length(to_light);
            l = to_light / d;
            strength = lights[i].inverse_square ? 1.0 / (d * d)
                                                : min(1.0 / dot(lights[i].attenuation, vec3(1.0, d, d * d)), 1.0);
            float along = dot(-l, lights[i].direction);
            if (lights[i].kind == 3) strength *= along >= lights[i].cos_cutoff ? pow(along, lights[i].falloff) : 0.0;
        }
        if (dot(n, l) <= 0.0) continue;
        vec3 light_diffuse, light_specular;
        reflect_light(n, v, t, b, l, light_diffuse, light_specular);
        diffuse += lights[i].diffuse * light_diffuse * strength;
        specular += lights[i].specular * light_specular * strength;
    }
}
)";

inline constexpr const char* vertex_main = R"(
in vec3 position, normal, color, face_a, face_b, face_c;
in vec2 uv;
uniform mat4 clip_from_object, eye_from_object;
uniform mat3 eye_from_object_normal;
uniform int frequency;  // 0 flat, 1 Gouraud, 2 Phong
uniform bool two_sided;
out vec3 normal_eye, position_eye, tint, front_diffuse, front_specular, back_diffuse, back_specular;
flat out vec3 face_diffuse, face_specular;
out vec2 where;

vec3 to_eye(vec3 p) { return (eye_from_object * vec4(p, 1.0)).xyz; }

void main() {
    gl_Position = clip_from_object * vec4(position, 1.0);
    position_eye = to_eye(position);
    normal_eye = eye_from_object_normal * normal;
    tint = color;
    where = uv;
    face_diffuse = face_specular = front_diffuse = front_specular = back_diffuse = back_specular = vec3(0.0);
    if (frequency == 0) {
        vec3 a = to_eye(face_a), b = to_eye(face_b), c = to_eye(face_c), middle = (a + b + c) / 3.0;
        vec3 n = normalize(cross(b - a, c - a));
        if (two_sided && dot(n, viewer.xyz - middle * viewer.w) < 0.0) n = -n;
        illuminate(n, middle, face_diffuse, face_specular);
    } else if (frequency == 1) {
        vec3 n = normalize(normal_eye);
        illuminate(n, position_eye, front_diffuse, front_specular);
        illuminate(-n, position_eye, back_diffuse, back_specular);
    }
}
)";

inline constexpr const char* fragment_main = R"(
in vec3 normal_eye, position_eye, tint, front_diffuse, front_specular, back_diffuse, back_specular;
flat in vec3 face_diffuse, face_specular;
in vec2 where;
uniform int frequency;
uniform bool two_sided, vertex_colors, ambient_is_diffuse, alpha_of_alpha;
uniform vec3 light_ambient, ambient_color, diffuse_color, specular_color, emission_color;
uniform float alpha;
uniform bool textured[5];
uniform sampler2D images[5];
out vec4 result;

void main() {
    vec3 kd = diffuse_color, ka = ambient_color, ks = specular_color, ke = emission_color;
    float opacity = alpha;
    if (textured[1]) kd *= texture(images[1], where).rgb;
    if (ambient_is_diffuse) ka *= kd;
    else if (textured[0]) ka *= texture(images[0], where).rgb;
    if (textured[2]) ks *= texture(images[2], where).rgb;
    if (textured[3]) ke *= texture(images[3], where).rgb;
    if (textured[4]) opacity *= alpha_of_alpha ? texture(images[4], where).a : texture(images[4], where).r;
    if (vertex_colors) kd *= tint, ka *= tint;
    bool turned = two_sided && !gl_FrontFacing;
    vec3 diffuse = face_diffuse, specular = face_specular;
    if (frequency == 1) {
        diffuse = turned ? back_diffuse : front_diffuse;
        specular = turned ? back_specular : front_specular;
    } else if (frequency == 2) {
        vec3 n = normalize(normal_eye);
        illuminate(turned ? -n : n, position_eye, diffuse, specular);
    }
    result = vec4(ke + ka * light_ambient + kd * diffuse + ks * specular, opacity);
}
)";

}  // namespace raster::tool::glsl
